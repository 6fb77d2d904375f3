#include "ui/main/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QLineEdit>
#include <QStackedWidget>
#include <QUndoGroup>
#include <utility>

#include "ui/capture/capture_screen.h"
#include "ui/frame/lines.h"
#include "ui/frame/project_session.h"
#include "ui/frame/sidebar.h"
#include "ui/main/begun_project.h"
#include "ui/main/catalogue_repair.h"
#include "ui/main/help_page.h"
#include "ui/main/open_project.h"
#include "ui/main/project_care.h"
#include "ui/main/restored_project.h"
#include "ui/main/start_screen.h"
#include "ui/main/window_actions.h"
#include "ui/main/window_place.h"
#include "ui/main/work_page.h"
#include "ui/merge/merge_words.h"
#include "ui/queue/batch_computation.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/queue_screen.h"
#include "ui/settings/settings_page.h"
#include "ui/viewport/sherd_view.h"
#include "ui/widgets/page_area.h"
#include "ui/widgets/thumbnails.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {

MainWindow::MainWindow(JobRunner& runner, QWidget* parent)
    : QMainWindow(parent),
      runner_(runner),
      undo_(new QUndoGroup(this)),
      queue_(new BatchQueue(this)),
      wizard_(new CaptureWizard(this)),
      project_(new OpenProject(*queue_->computation(), runner, this)),
      thumbnails_(new Thumbnails(runner, this)),
      care_(new ProjectCare(runner, this)) {
  setObjectName(QStringLiteral("mainWindow"));
  setWindowTitle(tr("Ostraka"));
  reserveOpenGl(*this);
  buildLayout();
  connectParts();
  addWindowActions(*this, *undo_, *work_->sidebar(), *work_->header());
  applySettings(settings_);
  start_->setRecent(settings_.recent, settings_.projects);
  connect(queue_, &BatchQueue::batchComputed, care_, &ProjectCare::measureRoom);
  connect(care_, &ProjectCare::roomMeasured, work_->header(), &HeaderLine::setRoom);
  connect(care_, &ProjectCare::said, work_->footer(), &FooterLine::say);
  connect(care_, &ProjectCare::catalogueDamaged, this, [this](const Error& damage) {
    if (wizard_->isShooting()) return work_->footer()->say(sentenceOf(damage));
    closeProject(), start_->showError(damage);  // nothing more is entered
  });
  placeWindow(*this, settings_.geometry);
  work_->fit(size());
  work_->followLines();
}

MainWindow::~MainWindow() {
  closeProject();
}

void MainWindow::buildLayout() {
  capture_screen_ = new CaptureScreen(wizard_, this);
  queue_screen_ = new QueueScreen(queue_, this);
  all_ = new QStackedWidget(this);
  start_ = new StartScreen(thumbnails_, all_);
  work_ = new WorkPage(*queue_, *capture_screen_, *queue_screen_, all_);
  settings_page_ = new SettingsPage(all_);
  help_ = new HelpPage(all_);
  start_area_ = new PageArea(start_, all_);
  settings_area_ = new PageArea(settings_page_, all_);
  for (QWidget* page : {static_cast<QWidget*>(start_area_), static_cast<QWidget*>(work_),
                        static_cast<QWidget*>(settings_area_), static_cast<QWidget*>(help_)})
    all_->addWidget(page);
  setCentralWidget(all_);
}

void MainWindow::connectParts() {
  for (Screen* screen : screens())
    connect(screen, &Screen::wantsScreen, this, &MainWindow::showScreenNamed);
  connect(work_, &WorkPage::screenWanted, this, &MainWindow::showScreen);
  connect(work_, &WorkPage::resultsWanted, this, &MainWindow::showScreenNamed);
  connect(start_, &StartScreen::opened, this, &MainWindow::openProject);
  connect(start_, &StartScreen::found, this, &MainWindow::findProject);
  connect(start_, &StartScreen::made, this, &MainWindow::takeProject);
  connect(start_, &StartScreen::settingsWanted, this, &MainWindow::showSettings);
  connect(start_, &StartScreen::manualWanted, this, &MainWindow::showManual);
  connect(start_, &StartScreen::virtualRigWanted, this, &MainWindow::tryVirtualRig);
  auto* begun = new BegunProject(*this, *start_, *capture_screen_, runner_);
  connect(start_, &StartScreen::photographsChosen, begun, &BegunProject::beginWith);
  connect(begun, &BegunProject::removed, this, [this](const QString& folder) {
    settings_.forget(folder);
    settings_.keep();
    start_->setRecent(settings_.recent, settings_.projects);
  });
  auto* repair = new CatalogueRepair(runner_, this);
  connect(start_, &StartScreen::repairWanted, repair, &CatalogueRepair::repair);
  connect(repair, &CatalogueRepair::told, start_, &StartScreen::tell);
  auto* restored = new RestoredProject(*this, *start_, runner_);
  connect(restored, &RestoredProject::said, work_->footer(), &FooterLine::say);
  connect(settings_page_, &SettingsPage::changed, this, &MainWindow::applySettings);
  connect(settings_page_, &SettingsPage::projectRenamed, this, &MainWindow::showTitle);
  connect(settings_page_, &SettingsPage::closed, this, &MainWindow::leaveSidePage);
  connect(settings_page_, &SettingsPage::restartWanted, this, &MainWindow::restart);
  connect(all_, &QStackedWidget::currentChanged, this, [this] {
    if (all_->currentWidget() != work_) work_->rest();
  });
  connect(help_, &HelpPage::closed, this, &MainWindow::leaveSidePage);
  connect(help_, &HelpPage::shortcutsWanted, this, &MainWindow::showShortcuts);
}

ProjectSession* MainWindow::session() const {
  return project_->session();
}

const std::vector<Screen*>& MainWindow::screens() const {
  return work_->screens();
}

void MainWindow::openProject(const QString& path) {
  closeProject();
  if (const auto opened = project_->open(path); !opened) return start_->showError(opened.error());
  showProject();
  showScreen(work_->shownLast());
}

void MainWindow::findProject(const QString& lost, const QString& found) {
  if (upkeep::Project::isProject(found.toStdString())) settings_.moved(lost, found);
  openProject(found);
}

void MainWindow::takeProject(std::shared_ptr<upkeep::Project> project) {
  closeProject();
  if (const auto taken = project_->take(std::move(project)); !taken)
    return start_->showError(taken.error());
  showProject();
  showScreen(0);
}

void MainWindow::showProject() {
  const QString read_only = session()->whyReadOnly();
  session()->setInitials(settings_.initials);
  undo_->addStack(&session()->undo());
  undo_->setActiveStack(&session()->undo());
  work_->openProject(*session());
  settings_page_->setSession(session());
  showTitle();
  all_->setCurrentWidget(work_);
  connect(session(), &ProjectSession::initialsChanged, this, [this](const QString& who) {
    settings_.initials = who;
    settings_.keep();
  });
  connect(session(), &ProjectSession::personRefused, work_->footer(), &FooterLine::say);
  connect(session(), &ProjectSession::stepRefused, this, [this](const QString& why) {
    all_->currentWidget() == settings_area_ ? settings_page_->say(why) : work_->footer()->say(why);
  });
  if (!read_only.isEmpty()) work_->footer()->say(read_only);
  if (const QString kept = keptWords(session()->project().keptFiles()); !kept.isEmpty())
    work_->footer()->say(kept);
  care_->begin(session()->folder(), !read_only.isEmpty());
}

void MainWindow::showTitle() {
  const QString title = project_->title();
  const bool read_only = !session()->whyReadOnly().isEmpty();
  const QString shown = read_only ? tr("%1 (read-only)").arg(title) : title;
  work_->setTitle(shown);
  settings_.remember(QString::fromStdString(session()->folder().string()),
                     {title, queue_->unfinished()});
  settings_.keep();
  setWindowTitle(tr("%1 - Ostraka").arg(shown));
}

void MainWindow::closeProject() {
  if (session() == nullptr) return;
  // What stands in a field without Return or Tab after it is saved too.
  if (auto* typing = qobject_cast<QLineEdit*>(focusWidget())) emit typing->editingFinished();
  showTitle();  // remembers what is left to do
  work_->closeProject();
  settings_page_->setSession(nullptr);
  care_->end();
  undo_->removeStack(&session()->undo());
  project_->close();
  setWindowTitle(tr("Ostraka"));
  start_->setRecent(settings_.recent, settings_.projects);
  all_->setCurrentWidget(start_area_);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  work_->fit(size());
}

void MainWindow::leaveProject() {
  if (!work_->saysWhatStops()) closeProject();
}

void MainWindow::tryVirtualRig() {
  auto made = makeVirtualProject(freshFolder(tr("Virtual rig")));
  if (!made) return start_->showError(made.error());
  takeProject(*made);
}

void MainWindow::showScreen(int index) {
  if (index < 0 || index >= static_cast<int>(screens().size()) || session() == nullptr) return;
  if (!session()->isThere() && !wizard_->isShooting()) {
    const Error gone = session()->goneError();
    closeProject();
    return start_->showError(gone);
  }
  work_->bringChosen(index);
  all_->setCurrentWidget(work_);
  work_->showScreen(index);
}

void MainWindow::showScreenNamed(const QString& icon_name, const QString& what) {
  if (icon_name == QLatin1String("settings")) {
    showSettings();
    return settings_page_->showPart(what);
  }
  const int index = work_->screenNamed(icon_name);
  const bool imported = icon_name == QLatin1String("queue") &&
                        screens()[static_cast<std::size_t>(work_->shown())] == capture_screen_;
  showScreen(index);
  work_->await(imported ? what : QString());
  if (index >= 0 && !what.isEmpty()) screens()[static_cast<std::size_t>(index)]->showItem(what);
}

void MainWindow::showSettings() {
  settings_page_->setSettings(settings_);
  settings_page_->say({});
  all_->setCurrentWidget(settings_area_);
  settings_page_->setFocus();
}

void MainWindow::showManual() {
  const QWidget* at = all_->currentWidget();
  help_->showManual(at == start_area_      ? QStringLiteral("start")
                    : at == settings_area_ ? QStringLiteral("settings")
                    : at == help_          ? QStringLiteral("index")
                                           : work_->shownName());
  all_->setCurrentWidget(help_);
}

void MainWindow::showShortcuts() {
  std::vector<std::pair<QString, const QWidget*>> parts = work_->partsWithKeys();
  parts.emplace_back(tr("Everywhere"), this);
  help_->showShortcuts(parts);
  all_->setCurrentWidget(help_);
}

void MainWindow::leaveSidePage() {
  session() == nullptr ? all_->setCurrentWidget(start_area_) : showScreen(work_->shown());
}

void MainWindow::applySettings(const WindowSettings& settings) {
  const bool look =
      settings.theme != settings_.theme || settings.text_percent != settings_.text_percent;
  settings_ = settings;
  if (look) applyLook(*qApp, settings.theme, settings.text_percent);
  queue_->computation()->setThreads(settings.threads);
  if (session() != nullptr) session()->setInitials(settings.initials);
  settings_.keep();
}

// What would be lost is told on the project's page, and who asks once more means it.
void MainWindow::restart() {
  restarted_ =
      session() == nullptr ? QString() : QString::fromStdString(session()->folder().string());
  leaveSidePage();
  close();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (work_->saysWhatIsLost()) {
    restarted_.reset();
    return event->ignore();
  }
  settings_.geometry = saveGeometry();
  settings_.keep();
  closeProject();
  if (!queue_->computation()->isLeaving()) return event->accept();
  start_->showError({ErrorCode::Cancelled,
                     tr("The computation is being stopped; it goes on when the project is opened "
                        "again. The window closes in a moment.")
                         .toStdString(),
                     {}});
  connect(queue_->computation(), &BatchComputation::left, this, &QWidget::close,
          Qt::UniqueConnection);
  event->ignore();
}

}  // namespace ostraka::ui
