#pragma once
#include <QObject>
#include <QString>
#include <memory>

#include "base/result.h"

namespace ostraka::upkeep {
class Project;
}

namespace ostraka::ui {

class BatchComputation;
class JobRunner;
class ProjectLock;
class ProjectSession;

/// The project that the window has open: its lock and its session. One that was closed stays locked
/// until its computation has ended.
class OpenProject final : public QObject {
  Q_OBJECT

 public:
  OpenProject(const BatchComputation& computation, JobRunner& runner, QObject* parent);
  ~OpenProject() override;

  ProjectSession* session() const { return session_.get(); }  ///< null: none is open
  QString title() const;

  /// path: its folder, or its catalogue's file. None may be open. Errors: it is open in another
  /// window, or cannot be read.
  Result<void> open(const QString& path);
  Result<void> take(std::shared_ptr<upkeep::Project> project);
  void close();

 private:
  Result<void> lock(const QString& folder);
  void begin(std::shared_ptr<upkeep::Project> project);

  const BatchComputation& computation_;
  JobRunner& runner_;
  std::unique_ptr<ProjectSession> session_;
  std::unique_ptr<ProjectLock> lock_;
  std::unique_ptr<ProjectLock> leaving_lock_;  ///< of a project whose computation is ending
};

}  // namespace ostraka::ui
