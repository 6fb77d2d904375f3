#include "ui/main/open_project.h"

#include <QDir>
#include <QFileInfo>
#include <utility>

#include "catalogue/settings.h"
#include "ui/frame/project_session.h"
#include "ui/main/main_window.h"
#include "ui/main/project_lock.h"
#include "ui/queue/batch_computation.h"
#include "upkeep/project.h"

namespace ostraka::ui {

OpenProject::OpenProject(const BatchComputation& computation, JobRunner& runner, QObject* parent)
    : QObject(parent), computation_(computation), runner_(runner) {
  connect(&computation, &BatchComputation::left, this, [this] { leaving_lock_.reset(); });
}

OpenProject::~OpenProject() = default;

QString OpenProject::title() const {
  const auto row = catalogue::Settings(session_->project().catalogue()).project();
  const QString title = row ? QString::fromStdString(row->title) : QString();
  return title.isEmpty() ? QDir(QString::fromStdString(session_->folder().string())).dirName()
                         : title;
}

// The lock comes first: opening may bring the catalogue up to date.
Result<void> OpenProject::open(const QString& path) {
  // A file manager hands over the catalogue's file; the project is its folder.
  const QFileInfo given(path);
  const QString folder = given.isFile() ? given.absolutePath() : path;
  if (upkeep::Project::isProject(folder.toStdString()))
    if (const Result<void> locked = lock(folder); !locked) return locked.error();
  Result<upkeep::Project> project = upkeep::Project::open(folder.toStdString());
  if (!project) {
    lock_.reset();
    return project.error();
  }
  begin(std::make_shared<upkeep::Project>(std::move(*project)));
  return {};
}

Result<void> OpenProject::take(std::shared_ptr<upkeep::Project> project) {
  const Result<void> locked = lock(QString::fromStdString(project->folder().string()));
  if (locked) begin(std::move(project));
  return locked;
}

void OpenProject::close() {
  session_.reset();
  // One project leaves at a time: nothing is computed before it has left.
  if (computation_.isLeaving() && leaving_lock_ == nullptr) leaving_lock_ = std::move(lock_);
  lock_.reset();
}

Result<void> OpenProject::lock(const QString& folder) {
  if (leaving_lock_ != nullptr && leaving_lock_->isOf(folder)) {
    lock_ = std::move(leaving_lock_);
    return {};
  }
  lock_ = ProjectLock::take(folder);
  if (lock_ != nullptr) return {};
  return Error{
      ErrorCode::UnusableInput,
      MainWindow::tr("This project is open in another window already: go on there.").toStdString(),
      folder.toStdString()};
}

void OpenProject::begin(std::shared_ptr<upkeep::Project> project) {
  const std::filesystem::path folder = project->folder();
  session_ = std::make_unique<ProjectSession>(std::move(project), folder, runner_);
}

}  // namespace ostraka::ui
