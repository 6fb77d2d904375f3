#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>

#include "base/result.h"

namespace ostraka::ui {

class JobHandle;
class JobRunner;

/// Makes a project from an archive, one at a time.
class ProjectRestoring final : public QObject {
  Q_OBJECT

 public:
  explicit ProjectRestoring(JobRunner& runner, QObject* parent = nullptr);

  /// The chosen folder where it is empty or new, else a new one in it that is called as the archive
  /// is.
  static QString placeIn(const QString& chosen, const QString& archive);

 public slots:
  void restore(const QString& archive, const QString& folder);
  void cancel();

 signals:
  void progressed(const QString& folder, const QString& words);
  /// damage: with which it was archived, a sentence a file.
  void restored(const QString& folder, const QStringList& damage);
  void failed(const ostraka::Error& error);

 private:
  JobRunner& runner_;
  QPointer<JobHandle> job_;
};

}  // namespace ostraka::ui
