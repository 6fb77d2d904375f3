#include "ui/main/restored_project.h"

#include "ui/export/project_restoring.h"
#include "ui/main/main_window.h"
#include "ui/main/start_screen.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

RestoredProject::RestoredProject(MainWindow& window, StartScreen& start, JobRunner& runner)
    : QObject(&window), window_(window), start_(start) {
  auto* restoring = new ProjectRestoring(runner, this);
  connect(&start, &StartScreen::restoreWanted, restoring, &ProjectRestoring::restore);
  connect(&start, &StartScreen::restoreCancelled, restoring, &ProjectRestoring::cancel);
  connect(restoring, &ProjectRestoring::progressed, &start, &StartScreen::showRestoring);
  connect(restoring, &ProjectRestoring::restored, this, &RestoredProject::take);
  connect(restoring, &ProjectRestoring::failed, this, &RestoredProject::tellFailure);
}

// Whoever opened another project meanwhile keeps it.
void RestoredProject::take(const QString& folder, const QStringList& damage) {
  const QString done = MainWindow::tr("The project is restored.");
  const bool other = window_.session() != nullptr;
  if (!other && damage.isEmpty()) {
    start_.tell(State::Sure, done, folder, {});
    return window_.openProject(folder);
  }
  const QString words = damage.isEmpty() ? folder
                                         : MainWindow::tr("It was archived with damage:") + '\n' +
                                               damage.join(QLatin1Char('\n'));
  start_.tell(damage.isEmpty() ? State::Sure : State::Ask, done, words, folder);
  if (other) emit said(done);
}

void RestoredProject::tellFailure(const Error& error) {
  if (error.code == ErrorCode::Cancelled)
    return start_.tell(State::Ask, MainWindow::tr("Restoring cancelled"),
                       MainWindow::tr("Nothing was left behind."), {});
  start_.showError(error);
  if (window_.session() != nullptr) emit said(sentenceOf(error));
}

}  // namespace ostraka::ui
