#pragma once
#include <QObject>
#include <QPointer>
#include <QStringList>

#include "ui/import/import_batch.h"
#include "ui/import/import_sides.h"
#include "ui/jobs/job.h"

class QWidget;

namespace ostraka::ui {

class ImportAsk;
class ProjectSession;

/// The ways to name what is imported: a dialog, or folders and photographs dropped onto a screen.
/// What it is comes out in a job; then a person is asked.
class ImportChooser final : public QObject {
  Q_OBJECT

 public:
  /// `screen` takes drops while there is a session.
  ImportChooser(QWidget* screen, ImportAsk* ask);
  void setSession(ProjectSession* session);

 public slots:
  void choose(ostraka::ui::ImportKind kind);
  void take(const QStringList& paths);  ///< folders or photographs

 signals:
  void failed(const ostraka::Error& error);

 private:
  void chooseBack();
  void readLabels();
  std::filesystem::path lastSheet() const;
  std::optional<double> lastMarker() const;

  QWidget* screen_;
  ImportAsk* ask_;
  QPointer<ProjectSession> session_;
  QPointer<JobHandle> job_, labels_job_;
};

}  // namespace ostraka::ui
