#pragma once
#include <QObject>
#include <QPointer>

#include "ui/import/import_batch.h"
#include "ui/import/place_text.h"
#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// A batch that was photographed elsewhere, or scanned, becomes one of the project's and goes into
/// the queue.
class BatchImporter final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  void setSession(ProjectSession* session);
  bool isBusy() const { return job_ != nullptr; }
  const QString& title() const { return title_; }  ///< of the import that runs, or ran last
  double fraction() const { return job_ == nullptr ? 0 : job_->progress().fraction; }

 public slots:
  /// sides: of photographs by hand, which then are imported in place of a batch folder.
  void start(const QString& folder, ostraka::ui::ImportKind kind,
             const ostraka::ui::PlaceText& place,
             const std::optional<ostraka::ui::ImportSides>& sides = {});
  void startAllTheSame();  ///< what alreadyThere told of
  void cancel();

 signals:
  void started(const QString& title);
  void progressed(double fraction);
  /// doubts: what is not usable of it, whole sentences; note: what else to know of it, or empty.
  void imported(const QString& number, int files, const QStringList& doubts, const QString& note);
  void failed(const ostraka::Error& error);
  /// The project has these photographs or scans: nothing was imported.
  /// Of its files; not all need to be there.
  void alreadyThere(const QString& number, const QString& folder, int there, int files);
  void ended();  ///< whatever became of it, also when the project is closed

 private:
  void copy(const ImportOptions& options, const PlaceText& place);
  Result<QString> enter(const Imported& copied, const PlaceText& place, bool twice);
  Result<std::string> addBatch(const Imported& copied, const PlaceText& place);  ///< its number

  QPointer<ProjectSession> session_;
  QPointer<JobHandle> job_;
  QString title_;
  ImportOptions asked_;  ///< of alreadyThere
  PlaceText asked_place_;
  QStringList doubts_;  ///< of the import that runs
};

}  // namespace ostraka::ui
