#include "ui/main/work_page.h"

#include <QFontInfo>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/capture/capture_screen.h"
#include "ui/frame/lines.h"
#include "ui/frame/project_session.h"
#include "ui/frame/sidebar.h"
#include "ui/look/look.h"
#include "ui/main/main_window.h"
#include "ui/queue/batch_computation.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/queue_screen.h"
#include "ui/widgets/page_area.h"

namespace ostraka::ui {
namespace {

constexpr const char* kScreen = "window.screen";  // that was in front when the project was closed

}  // namespace

WorkPage::WorkPage(BatchQueue& queue, CaptureScreen& capture, QueueScreen& queue_screen,
                   QWidget* parent)
    : QWidget(parent),
      queue_(queue),
      capture_(capture),
      queue_screen_(queue_screen),
      screens_(makeScreens(&capture, &queue_screen, this)) {
  buildLayout();
  for (Screen* screen : screens_) {
    connect(screen, &Screen::said, footer_, &FooterLine::say);
    connect(screen, &Screen::working, this, [this](const QString& words, double fraction) {
      other_work_ = words;
      other_fraction_ = fraction;
      if (words.isEmpty()) warned_ = false;  // what would have been lost is done
      followLines();
    });
    connect(screen, &Screen::whereChanged, this, &WorkPage::followLines);
  }
  connect(sidebar_, &Sidebar::selectedChanged, this, &WorkPage::screenWanted);
  connect(&queue, &BatchQueue::batchComputed, this, [this](const QString& number) {
    footer_->say(MainWindow::tr("%1 is ready.").arg(number));
  });
  // Queued: the other screens have heard of the results by then.
  connect(
      &queue, &BatchQueue::batchComputed, this,
      [this](const QString& number) {
        if (number == awaited_ && !queue_screen_.masksPage()->isVisible())
          emit resultsWanted(QStringLiteral("catalogue"), number);
      },
      Qt::QueuedConnection);
  connect(&queue, &BatchQueue::batchFailed, this,
          [this](const QString& number, const QString& why) {
            footer_->say(MainWindow::tr("%1 stopped: %2").arg(number, why));
          });
  queue_screen.showImportsOf(capture.importer());
  connect(&queue, &BatchQueue::workChanged, this, &WorkPage::followLines);
  connect(&capture, &CaptureScreen::rigRenewed, &queue, &BatchQueue::forgetMoved);
  connect(&capture, &CaptureScreen::batchSetAside, &queue, &BatchQueue::setAside);
  connect(&capture, &CaptureScreen::lineChanged, this, &WorkPage::followLines);
}

void WorkPage::buildLayout() {
  sidebar_ = new Sidebar(this);
  header_ = new HeaderLine(this);
  pages_ = new QStackedWidget(this);
  footer_ = new FooterLine(queue_screen_.pauseAction(), queue_screen_.logAction(), this);
  for (Screen* screen : screens_) {
    pages_->addWidget(new PageArea(screen, pages_));
    window()->addAction(sidebar_->addScreen(screen));  // its key works on the side pages too
  }
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  right->addWidget(header_);
  right->addWidget(pages_, 1);
  right->addWidget(footer_);
  auto* row = bareLayout<QHBoxLayout>(this);
  row->setSpacing(0);
  row->addWidget(sidebar_);
  row->addLayout(right, 1);
}

int WorkPage::shown() const {
  return pages_->currentIndex();
}

QString WorkPage::shownName() const {
  return screens_.at(static_cast<std::size_t>(shown()))->iconName();
}

int WorkPage::shownLast() const {
  return std::max(0, screenNamed(session_->setting(kScreen)));
}

std::vector<std::pair<QString, const QWidget*>> WorkPage::partsWithKeys() const {
  std::vector<std::pair<QString, const QWidget*>> parts;
  for (const Screen* screen : screens_) {
    parts.emplace_back(screen->title(), screen);
    if (screen == &queue_screen_)
      parts.emplace_back(MainWindow::tr("Queue: editing masks"), queue_screen_.masksPage());
  }
  return parts;
}

int WorkPage::screenNamed(const QString& icon_name) const {
  for (std::size_t i = 0; i < screens_.size(); ++i)
    if (screens_[i]->iconName() == icon_name) return static_cast<int>(i);
  return -1;
}

void WorkPage::openProject(ProjectSession& session) {
  session_ = &session;
  for (Screen* screen : screens_) screen->openProject(session);
  connect(&session, &ProjectSession::batchChanged, this, &WorkPage::followLines);
}

void WorkPage::setTitle(const QString& title) {
  title_ = title;
  followLines();
}

void WorkPage::closeProject() {
  if (session_->setting(kScreen) != shownName()) session_->noteSetting(kScreen, shownName());
  for (Screen* screen : screens_) {
    screen->setInFront(false);
    screen->closeProject();
  }
  session_ = nullptr;
  awaited_.clear();
  warned_ = false;
}

void WorkPage::bringChosen(int index) {
  const auto from = static_cast<std::size_t>(shown());
  const auto to = static_cast<std::size_t>(index);
  if (from != to) screens_[to]->takeChosen(screens_[from]->chosen());
}

void WorkPage::showScreen(int index) {
  warned_ = false;
  awaited_.clear();
  pages_->setCurrentIndex(index);
  sidebar_->select(index);
  for (std::size_t i = 0; i < screens_.size(); ++i)
    screens_[i]->setInFront(static_cast<int>(i) == index);
  followLines();
}

void WorkPage::rest() {
  awaited_.clear();
  for (Screen* screen : screens_) screen->setInFront(false);
}

void WorkPage::fit(const QSize& window) {
  // Where letters are large, less stands in the same height.
  const double letters = static_cast<double>(QFontInfo(font()).pixelSize()) / Look::kBody;
  const bool compact = window.height() < Look::kCompactBelow * std::max(1.0, letters);
  sidebar_->fit(window);
  header_->setCompact(compact);
  footer_->setCompact(compact);
  for (Screen* screen : screens_) screen->setCompact(compact);
}

WorkPage::Warning WorkPage::loss() const {
  for (std::size_t i = 0; i < screens_.size() && session_ != nullptr; ++i)
    if (QString words = screens_[i]->losesByClosing(); !words.isEmpty())
      return {static_cast<int>(i), std::move(words)};
  return {};
}

// Whoever goes on working is warned anew.
bool WorkPage::warn(const Warning& of) {
  if (of.words.isEmpty() || warned_) return warned_ = false;
  emit screenWanted(of.screen);
  footer_->say(of.words);
  return warned_ = true;
}

bool WorkPage::saysWhatIsLost() {
  return warn(loss());
}

bool WorkPage::saysWhatStops() {
  Warning of = loss();
  if (of.words.isEmpty() && queue_.computation()->isBusy())
    of = {screenNamed(QStringLiteral("queue")),
          MainWindow::tr(
              "%1 is being processed. Leaving the project stops it, and it continues when the "
              "project is opened again. Choose Projects once more to leave.")
              .arg(queue_.computation()->number())};
  return warn(of);
}

void WorkPage::followLines() {
  const QString queued = queue_.workWords();
  const bool other = !other_work_.isEmpty() && !queue_.computation()->isBusy();
  footer_->setWork(other ? other_work_ : queued, other ? other_fraction_ : queue_.workFraction());
  const QString where = session_ == nullptr
                            ? QString()
                            : screens_.at(static_cast<std::size_t>(shown()))->whereWords();
  header_->setWhere(where.isEmpty() && session_ != nullptr ? title_ : where);
  header_->setRig(capture_.rigWords(), capture_.isRigReady());
}

}  // namespace ostraka::ui
