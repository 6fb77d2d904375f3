#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <filesystem>

#include "base/result.h"

namespace ostraka::ui {

class JobHandle;
class JobRunner;

/// Looks at the catalogue and a share of a project's files in the background each time it is
/// opened, so that damage by a disk is known while there still are copies.
class FileWatch final : public QObject {
  Q_OBJECT

 public:
  FileWatch(JobRunner& runner, QObject* parent);
  void look(const std::filesystem::path& project);
  void stop();  ///< nothing of a look that is under way arrives any more

 signals:
  void found(const QString& words);  ///< files are missing or changed, and what to do
  void catalogueDamaged(const ostraka::Error& damage);

 private:
  JobRunner& runner_;
  QPointer<JobHandle> job_;
};

}  // namespace ostraka::ui
