#include "ui/main/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QFileInfo>
#include <QFontInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QStackedWidget>
#include <QStyle>
#include <QUndoGroup>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "catalogue/settings.h"
#include "ui/capture/capture_screen.h"
#include "ui/capture/capture_wizard.h"
#include "ui/frame/lines.h"
#include "ui/frame/message_panel.h"
#include "ui/frame/page_area.h"
#include "ui/frame/project_session.h"
#include "ui/frame/sidebar.h"
#include "ui/frame/thumbnails.h"
#include "ui/main/catalogue_repair.h"
#include "ui/main/file_watch.h"
#include "ui/main/help_page.h"
#include "ui/main/project_care.h"
#include "ui/main/project_lock.h"
#include "ui/main/start_screen.h"
#include "ui/main/window_actions.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/queue_screen.h"
#include "ui/settings/settings_page.h"
#include "ui/viewport/sherd_view.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kFrame = 4;  // pixels that a desktop draws around a window, about

}  // namespace

MainWindow::MainWindow(JobRunner& runner, QWidget* parent)
    : QMainWindow(parent),
      runner_(runner),
      settings_(readSettings()),
      undo_(new QUndoGroup(this)),
      queue_(new BatchQueue(this)),
      wizard_(new CaptureWizard(this)),
      thumbnails_(new Thumbnails(runner, this)),
      care_(new ProjectCare(runner, this)),
      file_watch_(new FileWatch(runner, this)) {
  setObjectName(QStringLiteral("mainWindow"));
  setWindowTitle(tr("Ostraka"));
  reserveOpenGl(*this);
  buildScreens();
  buildLayout();
  addWindowActions(*this, *undo_, *sidebar_, *header_);
  applySettings(settings_);
  settings_page_->setSettings(settings_);
  start_->setRecent(settings_.recent, settings_.titles);
  connect(queue_, &BatchQueue::workChanged, this, &MainWindow::followLines);
  connect(queue_, &BatchQueue::left, this, [this] { leaving_lock_.reset(); });
  connect(capture_screen_, &CaptureScreen::lineChanged, this, &MainWindow::followLines);
  connect(capture_screen_, &CaptureScreen::rigRenewed, queue_, &BatchQueue::forgetMoved);
  connect(capture_screen_, &CaptureScreen::batchSetAside, queue_, &BatchQueue::setAside);
  connect(queue_, &BatchQueue::batchComputed, care_, &ProjectCare::measureRoom);
  connect(care_, &ProjectCare::roomMeasured, header_, &HeaderLine::setRoom);
  connect(care_, &ProjectCare::said, footer_, &FooterLine::say);
  connect(file_watch_, &FileWatch::found, footer_, &FooterLine::say);
  connect(file_watch_, &FileWatch::catalogueDamaged, this, [this](const Error& damage) {
    if (wizard_->isShooting()) return footer_->say(sentenceOf(damage));
    closeProject(), start_->showError(damage);  // nothing more is entered
  });
  if (!restoreGeometry(settings_.geometry)) {
    const int frame = style()->pixelMetric(QStyle::PM_TitleBarHeight) + 2 * kFrame;
    resize(QSize(1280, 760).boundedTo(screen()->availableSize() - QSize(2 * kFrame, frame)));
  }
  fitToSize();
  followLines();
}

MainWindow::~MainWindow() {
  closeProject();
}

void MainWindow::buildScreens() {
  capture_screen_ = new CaptureScreen(wizard_, this);
  queue_screen_ = new QueueScreen(queue_, this);
  screens_ = makeScreens(capture_screen_, queue_screen_, this);
}

void MainWindow::buildLayout() {
  all_ = new QStackedWidget(this);
  start_ = new StartScreen(thumbnails_, all_);
  auto* work = new QWidget(all_);
  sidebar_ = new Sidebar(work);
  header_ = new HeaderLine(work);
  pages_ = new QStackedWidget(work);
  footer_ = new FooterLine(queue_screen_->pauseAction(), queue_screen_->logAction(), work);
  for (Screen* screen : screens_) {
    pages_->addWidget(new PageArea(screen, pages_));
    addAction(sidebar_->addScreen(screen));  // its key works on the side pages too
    connect(screen, &Screen::said, footer_, &FooterLine::say);
    connect(screen, &Screen::working, this, [this](const QString& words, double fraction) {
      other_work_ = words;
      other_fraction_ = fraction;
      if (words.isEmpty()) warned_ = false;  // what would have been lost is done
      followLines();
    });
    connect(screen, &Screen::wantsScreen, this, &MainWindow::showScreenNamed);
    connect(screen, &Screen::whereChanged, this, &MainWindow::followLines);
  }
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  right->addWidget(header_);
  right->addWidget(pages_, 1);
  right->addWidget(footer_);
  auto* row = new QHBoxLayout(work);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(sidebar_);
  row->addLayout(right, 1);
  settings_page_ = new SettingsPage(all_);
  help_ = new HelpPage(all_);
  start_area_ = new PageArea(start_, all_);
  settings_area_ = new PageArea(settings_page_, all_);
  for (QWidget* page : {static_cast<QWidget*>(start_area_), work,
                        static_cast<QWidget*>(settings_area_), static_cast<QWidget*>(help_)})
    all_->addWidget(page);
  setCentralWidget(all_);
  connect(sidebar_, &Sidebar::selectedChanged, this, &MainWindow::showScreen);
  connect(start_, &StartScreen::opened, this, &MainWindow::openProject);
  connect(start_, &StartScreen::found, this, &MainWindow::findProject);
  connect(start_, &StartScreen::made, this, &MainWindow::takeProject);
  connect(start_, &StartScreen::settingsWanted, this, &MainWindow::showSettings);
  connect(start_, &StartScreen::manualWanted, this, &MainWindow::showManual);
  connect(start_, &StartScreen::virtualRigWanted, this, &MainWindow::tryVirtualRig);
  auto* repair = new CatalogueRepair(runner_, this);
  connect(start_, &StartScreen::repairWanted, repair, &CatalogueRepair::repair);
  connect(repair, &CatalogueRepair::told, start_, &StartScreen::showRepair);
  connect(settings_page_, &SettingsPage::changed, this, &MainWindow::applySettings);
  connect(settings_page_, &SettingsPage::closed, this, &MainWindow::leaveSidePage);
  connect(all_, &QStackedWidget::currentChanged, this, [this, work] {  // a live picture rests
    for (Screen* screen : screens_)
      if (all_->currentWidget() != work) screen->setInFront(false);
  });
  connect(help_, &HelpPage::closed, this, &MainWindow::leaveSidePage);
  connect(help_, &HelpPage::shortcutsWanted, this, &MainWindow::showShortcuts);
  connect(queue_, &BatchQueue::batchComputed, this,
          [this](const QString& number) { footer_->say(tr("%1 is ready.").arg(number)); });
  connect(queue_, &BatchQueue::batchFailed, this,
          [this](const QString& number, const QString& why) {
            footer_->say(tr("%1 stopped: %2").arg(number, why));
          });
}

// The lock comes first: opening may bring the catalogue up to date.
void MainWindow::openProject(const QString& path) {
  closeProject();
  // A file manager hands over the catalogue's file; the project is its folder.
  const QFileInfo given(path);
  const QString folder = given.isFile() ? given.absolutePath() : path;
  if (upkeep::Project::isProject(folder.toStdString()) && !lockProject(folder)) return;
  Result<upkeep::Project> project = upkeep::Project::open(folder.toStdString());
  if (!project) {
    lock_.reset();
    return start_->showError(project.error());
  }
  showProject(std::make_shared<upkeep::Project>(std::move(*project)));
  showScreen(qMax(0, screenNamed(settings_.screen)));
}

void MainWindow::findProject(const QString& lost, const QString& found) {
  if (upkeep::Project::isProject(found.toStdString())) settings_.moved(lost, found);
  openProject(found);
}

bool MainWindow::lockProject(const QString& folder) {
  if (leaving_lock_ != nullptr && leaving_lock_->isOf(folder)) {
    lock_ = std::move(leaving_lock_);
    return true;
  }
  lock_ = ProjectLock::take(folder);
  if (lock_ != nullptr) return true;
  start_->showError(
      {ErrorCode::UnusableInput,
       tr("This project is open in another window already: go on there.").toStdString(),
       folder.toStdString()});
  return false;
}

void MainWindow::takeProject(std::shared_ptr<upkeep::Project> project) {
  closeProject();
  if (!lockProject(QString::fromStdString(project->folder().string()))) return;
  showProject(std::move(project));
  showScreen(0);
}

void MainWindow::showProject(std::shared_ptr<upkeep::Project> project) {
  const std::filesystem::path folder = project->folder();
  const QString path = QString::fromStdString(folder.string());
  session_ = std::make_unique<ProjectSession>(std::move(project), folder, runner_);
  const auto project_row = catalogue::Settings(session_->project().catalogue()).project();
  title_ = project_row ? QString::fromStdString(project_row->title) : QString();
  if (title_.isEmpty()) title_ = QDir(path).dirName();
  session_->setInitials(settings_.initials);
  undo_->addStack(&session_->undo());
  undo_->setActiveStack(&session_->undo());
  for (Screen* screen : screens_) screen->openProject(*session_);
  settings_page_->setSession(session_.get());
  settings_.remember(path, title_);
  writeSettings(settings_);
  const bool read_only = !QFileInfo(path).isWritable() ||
                         !QFileInfo(path + QStringLiteral("/catalogue.sqlite")).isWritable();
  if (read_only) title_ = tr("%1 (read-only)").arg(title_);
  setWindowTitle(tr("%1 - Ostraka").arg(title_));
  all_->setCurrentIndex(1);
  connect(session_.get(), &ProjectSession::batchChanged, this, &MainWindow::followLines);
  connect(session_.get(), &ProjectSession::initialsChanged, this, [this](const QString& who) {
    settings_.initials = who;
    writeSettings(settings_);
  });
  connect(session_.get(), &ProjectSession::personRefused, footer_, &FooterLine::say);
  if (read_only)
    footer_->say(tr("This project is read-only: you can look at everything, but change nothing."));
  care_->begin(folder, read_only);
  file_watch_->look(folder);
}

void MainWindow::closeProject() {
  if (session_ == nullptr) return;
  // What stands in a field without Return or Tab after it is saved too.
  if (auto* typing = qobject_cast<QLineEdit*>(focusWidget())) emit typing->editingFinished();
  for (Screen* screen : screens_) {
    screen->setInFront(false);
    screen->closeProject();
  }
  settings_page_->setSession(nullptr);
  file_watch_->stop();
  care_->end();
  undo_->removeStack(&session_->undo());
  session_.reset();
  warned_ = false;
  // One project leaves at a time: nothing is computed before it has left.
  if (queue_->isLeaving() && leaving_lock_ == nullptr) leaving_lock_ = std::move(lock_);
  lock_.reset();
  setWindowTitle(tr("Ostraka"));
  start_->setRecent(settings_.recent, settings_.titles);
  all_->setCurrentWidget(start_area_);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  fitToSize();
}

void MainWindow::fitToSize() {
  // Where letters are large, less stands in the same height.
  const double letters = static_cast<double>(QFontInfo(font()).pixelSize()) / Look::kBody;
  const bool compact = height() < Look::kCompactBelow * std::max(1.0, letters);
  sidebar_->fit(size());
  header_->setCompact(compact);
  footer_->setCompact(compact);
  for (Screen* screen : screens_) screen->setCompact(compact);
}

bool MainWindow::saysWhatIsLost() {
  for (std::size_t i = 0; i < screens_.size() && session_ != nullptr; ++i) {
    const QString loss = screens_[i]->losesByClosing();
    if (loss.isEmpty()) continue;
    if (std::exchange(warned_, true)) return false;
    showScreen(static_cast<int>(i));
    footer_->say(loss);
    return true;
  }
  return warned_ = false;
}

void MainWindow::leaveProject() {
  if (!saysWhatIsLost()) closeProject();
}

void MainWindow::tryVirtualRig() {
  const QDir place(projectsFolder());
  QString folder = place.filePath(tr("Virtual rig"));
  for (int n = 2; QDir(folder).exists(); ++n) folder = place.filePath(tr("Virtual rig %1").arg(n));
  auto made = makeVirtualProject(folder);
  if (!made) return start_->showError(made.error());
  takeProject(*made);
}

void MainWindow::showScreen(int index) {
  if (index < 0 || index >= static_cast<int>(screens_.size()) || session_ == nullptr) return;
  if (!session_->isThere() && !wizard_->isShooting()) {
    const Error gone = session_->goneError();
    closeProject();
    return start_->showError(gone);
  }
  const auto before = static_cast<std::size_t>(pages_->currentIndex());
  const auto now = static_cast<std::size_t>(index);
  if (before != now) screens_[now]->takeChosen(screens_[before]->chosen());
  all_->setCurrentIndex(1);
  pages_->setCurrentIndex(index);
  sidebar_->select(index);
  for (std::size_t i = 0; i < screens_.size(); ++i)
    screens_[i]->setInFront(static_cast<int>(i) == index);
  followLines();
}

int MainWindow::screenNamed(const QString& icon_name) const {
  for (std::size_t i = 0; i < screens_.size(); ++i)
    if (screens_[i]->iconName() == icon_name) return static_cast<int>(i);
  return -1;
}

void MainWindow::showScreenNamed(const QString& icon_name, const QString& what) {
  const int screen = screenNamed(icon_name);
  if (screen < 0) return;
  showScreen(screen);
  if (!what.isEmpty()) screens_[static_cast<std::size_t>(screen)]->showItem(what);
}

void MainWindow::showSettings() {
  settings_page_->setSettings(settings_);
  all_->setCurrentWidget(settings_area_);
  settings_page_->setFocus();
}

void MainWindow::showManual() {
  const QWidget* shown = all_->currentWidget();
  QString page = QStringLiteral("index");
  if (shown == start_area_)
    page = QStringLiteral("start");
  else if (shown == settings_area_)
    page = QStringLiteral("settings");
  else if (shown != help_)
    page = screens_[static_cast<std::size_t>(pages_->currentIndex())]->manualPage();
  help_->showManual(page);
  all_->setCurrentWidget(help_);
}

void MainWindow::showShortcuts() {
  std::vector<std::pair<QString, const QWidget*>> screens;
  for (const Screen* screen : screens_) {
    screens.emplace_back(screen->title(), screen);
    if (screen == queue_screen_)
      screens.emplace_back(tr("Queue: editing masks"), queue_screen_->masksPage());
  }
  screens.emplace_back(tr("Everywhere"), this);
  help_->showShortcuts(screens);
  all_->setCurrentWidget(help_);
}

void MainWindow::leaveSidePage() {
  if (session_ == nullptr)
    all_->setCurrentWidget(start_area_);
  else
    showScreen(pages_->currentIndex());
}

void MainWindow::applySettings(const WindowSettings& settings) {
  const bool look =
      settings.theme != settings_.theme || settings.text_percent != settings_.text_percent;
  settings_ = settings;
  if (look) applyLook(*qApp, settings.theme, settings.text_percent);
  queue_->setThreads(settings.threads);
  if (session_ != nullptr) session_->setInitials(settings.initials);
  writeSettings(settings_);
}

void MainWindow::followLines() {
  const QString queued = queue_->workWords();
  const bool other = !other_work_.isEmpty() && !queue_->isBusy();
  footer_->setWork(other ? other_work_ : queued, other ? other_fraction_ : queue_->workFraction());
  const QString where =
      session_ == nullptr || pages_->currentIndex() < 0
          ? QString()
          : screens_[static_cast<std::size_t>(pages_->currentIndex())]->whereWords();
  header_->setWhere(where.isEmpty() && session_ != nullptr ? title_ : where);
  header_->setRig(capture_screen_->rigWords(), capture_screen_->isRigReady());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (saysWhatIsLost()) return event->ignore();
  settings_.geometry = saveGeometry();
  const int selected = sidebar_->selected();
  if (session_ != nullptr)
    settings_.screen = selected < 0 ? QString() : screens_.at(selected)->iconName();
  writeSettings(settings_);
  closeProject();
  if (!queue_->isLeaving()) return event->accept();
  start_->showError({ErrorCode::Cancelled,
                     tr("The computation is being stopped; it goes on when the project is opened "
                        "again. The window closes in a moment.")
                         .toStdString(),
                     {}});
  connect(queue_, &BatchQueue::left, this, &QWidget::close, Qt::UniqueConnection);
  event->ignore();
}

}  // namespace ostraka::ui
