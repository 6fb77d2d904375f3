#include "ui/main/begun_project.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "catalogue/history.h"
#include "ui/capture/capture_screen.h"
#include "ui/frame/project_session.h"
#include "ui/import/import_sides.h"
#include "ui/jobs/when_done.h"
#include "ui/main/main_window.h"
#include "ui/main/start_screen.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

std::int64_t historyOf(ProjectSession& session) {
  return catalogue::History(session.project().catalogue()).length();
}

}  // namespace

BegunProject::BegunProject(MainWindow& window, StartScreen& start, CaptureScreen& capture,
                           JobRunner& runner)
    : QObject(&window), window_(window), start_(start), capture_(capture), runner_(runner) {
  connect(&capture, &CaptureScreen::importLeft, this, &BegunProject::leave,
          Qt::QueuedConnection);  // it closes the screen that tells
}

void BegunProject::beginWith(const QStringList& photographs) {
  if (photographs.isEmpty()) return;
  if (photographs.size() == 1 && upkeep::Project::isProject(photographs.front().toStdString()))
    return window_.openProject(photographs.front());
  JobHandle* job = runner_.start(
      makeJob([photographs](Progress&, std::stop_token) { return planSides(photographs, {}); }),
      this);
  whenDone<std::optional<SidesPlan>>(job, this, [this, photographs](const auto& plan) {
    if (window_.session() != nullptr) return;  // one was opened meanwhile
    if (!plan) return start_.showError(plan.error());
    make(photographs);
  });
}

void BegunProject::make(const QStringList& photographs) {
  start_.makeFor(photographs);
  session_ = window_.session();
  if (!session_) return;
  history_ = historyOf(*session_);
  capture_.importPhotographs(photographs);
}

// Without its photographs the project that was made for them is nothing that a person asked for.
void BegunProject::leave() {
  const QPointer<ProjectSession> begun = std::exchange(session_, nullptr);
  if (!begun || historyOf(*begun) > history_) return;
  const std::filesystem::path place = begun->folder();
  const QString folder = QString::fromStdString(place.string());
  window_.closeProject();
  if (const auto gone = upkeep::Project::removeUnused(place, history_); !gone || !*gone)
    return window_.openProject(folder);
  emit removed(folder);
  start_.tell(State::Ask, MainWindow::tr("Import cancelled"),
              MainWindow::tr("The project that was created for it is removed. Your photographs are "
                             "as they were."),
              {});
}

}  // namespace ostraka::ui
