#pragma once
#include <QObject>
#include <QPointer>
#include <filesystem>

#include "ui/jobs/job.h"

namespace ostraka::ui {

class ProjectSession;

/// A camera was bumped: the project's rig is calibrated anew by the photographs of a batch that was
/// computed since. The calibration before is kept beside it.
class RigRenewal final : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;
  void forget();  ///< of a project that is closed; it ends in silence
  void start(ProjectSession& session, const std::filesystem::path& rig_file, const QString& batch);

 signals:
  void renewed(const QString& batch, const QString& kept_as);
  void failed(const ostraka::Error& error);

 private:
  QPointer<JobHandle> job_;
};

}  // namespace ostraka::ui
