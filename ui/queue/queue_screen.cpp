#include "ui/queue/queue_screen.h"

#include <QAction>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QListView>
#include <QPlainTextEdit>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

#include "files/files.h"
#include "paper/report_page.h"
#include "ui/frame/batch_place.h"
#include "ui/frame/no_batch_yet.h"
#include "ui/frame/project_session.h"
#include "ui/import/batch_importer.h"
#include "ui/import/import_line.h"
#include "ui/look/look.h"
#include "ui/masks/mask_page.h"
#include "ui/queue/batch_computation.h"
#include "ui/queue/batch_delegate.h"
#include "ui/queue/batch_queue.h"
#include "ui/queue/marker_side.h"
#include "ui/queue/queue_switches.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/message_panel.h"
#include "ui/widgets/open_outside.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/page_area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/thumbnails.h"
#include "ui/widgets/tool_row.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

// Below this much work a stop loses so little that nobody is asked.
constexpr double kAskBeforeLosing_s = 3600;

}  // namespace

QueueScreen::QueueScreen(BatchQueue* queue, QWidget* parent)
    : Screen(tr("Queue"), QStringLiteral("queue"), parent),
      queue_(queue),
      list_(named<QListView>({"queueList", tr("Batches")}, this)),
      delegate_(new BatchDelegate(*queue, this)),
      log_(named<QPlainTextEdit>({"queueLogText", tr("Log of the computation")}, this)),
      message_(new MessagePanel(QStringLiteral("queueMessage"), this)),
      pages_(new QStackedWidget(this)),
      masks_page_(new MaskPage(this)),
      masks_area_(new PageArea(masks_page_, this)) {
  setObjectName(QStringLiteral("queue"));
  pause_ = addPageAct(this, "queuePause", "pause", tr("Pause"), Qt::Key_Space, queue_->switches(),
                      &QueueSwitches::togglePaused);
  again_ = addPageAct(this, "queueAgain", "retry", tr("Reprocess"), Qt::Key_R, this,
                      [this] { queue_->retry(selected()); });
  cancel_ = addPageAct(this, "queueCancel", "cancel", tr("Cancel"), Qt::Key_Delete, this,
                       &QueueScreen::askOrCancel);
  report_ = addPageAct(this, "queueReport", "report", tr("Show report"), Qt::Key_O, this,
                       &QueueScreen::openReport);
  review_ = addPageAct(this, "queueReview", "review", tr("Review"), Qt::Key_V, this,
                       [this] { emit wantsScreen(QStringLiteral("review"), selected()); });
  masks_ = addPageAct(this, "queueMasks", "edit", tr("Edit masks"), Qt::Key_M, this,
                      &QueueScreen::showMasks);
  log_action_ = addPageAct(this, "queueLog", "log", tr("Log"), Qt::Key_L);
  log_action_->setCheckable(true);
  open_ = addPageAct(this, "queueOpen", "open", tr("Open"), Qt::Key_Return, this,
                     &QueueScreen::openSelected);
  open_->setShortcuts({Qt::Key_Return, Qt::Key_Enter});
  drafts_ = addPageAct(this, "queueDrafts", "picture", tr("Drafts first"), Qt::Key_D);
  drafts_->setCheckable(true);
  calibrate_ = addPageAct(
      this, "queueCalibrate", "turntable", tr("Recalibrate rig"), Qt::Key_C, this, [this] {
        emit wantsScreen(QStringLiteral("capture"), QStringLiteral("calibrate:") + selected());
      });
  calibrate_->setToolTip(
      tr("A camera was bumped: this batch's photographs tell where the cameras stand now (C)"));
  marker_action_ = addPageAct(this, "queueMarkerSide", "measure", tr("Marker side…"), {}, this,
                              [this] { marker_side_->ask(selected()); });
  keep_both_ = addPageAct(this, "queueKeepBoth", "plus", tr("Keep both"), {}, this,
                          [this] { queue_->keepBoth(selected()); });
  keep_both_->setToolTip(
      tr("Processes this batch although another one has the same photographs; the sherds of both "
         "are then in the catalogue"));
  marker_side_ = new MarkerSide(this);
  buildLayout();

  connect(marker_side_, &MarkerSide::changed, queue_, &BatchQueue::retry);
  connect(marker_side_, &MarkerSide::failed, this,
          [this](const Error& error) { emit said(sentenceOf(error)); });
  connect(masks_page_, &MaskPage::closed, this, &QueueScreen::leaveMasks);
  connect(masks_page_, &MaskPage::computeWanted, this, [this](const QString& batch) {
    leaveMasks();
    queue_->retry(batch);
  });
  connect(log_action_, &QAction::toggled, log_, &QWidget::setVisible);
  connect(log_action_, &QAction::triggered, this, [this] {
    if (isVisible()) return;  // by the window's foot, from another page
    log_wanted_ = true;
    emit wantsScreen(QStringLiteral("queue"), {});
  });
  connect(drafts_, &QAction::toggled, queue_->switches(), &QueueSwitches::setMakesDrafts);
  connect(queue_, &BatchQueue::logged, log_, &QPlainTextEdit::appendPlainText);
  connect(queue_, &BatchQueue::workChanged, this, &QueueScreen::follow);
  connect(queue_, &QAbstractItemModel::modelReset, this, &QueueScreen::follow);
  connect(queue_, &QAbstractItemModel::dataChanged, this, &QueueScreen::follow);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &QueueScreen::follow);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &Screen::whereChanged);
  connect(list_, &QListView::activated, this, &QueueScreen::openSelected);
  follow();
}

void QueueScreen::buildLayout() {
  list_->setModel(queue_);
  list_->setItemDelegate(delegate_);
  list_->setUniformItemSizes(false);
  list_->setResizeMode(QListView::Adjust);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  log_->setReadOnly(true);
  log_->setMaximumBlockCount(2000);
  log_->hide();

  empty_ = new NoBatchYet(QStringLiteral("queue"), tr("No batch yet"),
                          tr("What you photograph or import is processed here, one batch after "
                             "the other, while you go on working."),
                          this);

  pages_->addWidget(buildList());
  pages_->addWidget(new PageArea(empty_, pages_));
  pages_->addWidget(masks_area_);
  column_ = pageColumn(this);
  column_->addWidget(pages_);
  connect(message_, &MessagePanel::acted, this, [this] {
    message_->hide();
    std::exchange(stop_shown_, false) ? queue_->switches()->setPaused(false)
                                      : queue_->cancel(asked_about_);
  });
  connect(message_, &MessagePanel::actedSecond, message_, &QWidget::hide);
}

// Pause and log are in the status bar, on every page.
QWidget* QueueScreen::buildList() {
  auto* page = new QWidget(this);
  tools_ = new ToolRow(page);
  tools_->addGroup(tr("Batch"),
                   {review_, report_, masks_, again_, keep_both_, marker_action_, cancel_});
  tools_->addGroup(tr("Queue"), {drafts_, calibrate_});
  next_ = new BigButton(QStringLiteral("queueNext"), {}, page);
  next_->setKeyHint(keyText(Qt::Key_Return));
  connect(next_, &QPushButton::clicked, this, &QueueScreen::openSelected);
  QSplitter* split = filled(new QSplitter(Qt::Vertical, page), {{list_, 3}, {log_, 2}});
  auto* foot = filled(new QHBoxLayout, {{tools_, 1}, {next_, 0, Qt::AlignBottom}});
  filled(bareLayout<QVBoxLayout>(page), {message_, {split, 1}, foot});
  return page;
}

QAbstractButton* QueueScreen::primary() const {
  return pages_->currentWidget() == masks_area_ ? masks_page_->primary()
         : queue_->rowCount() == 0              ? empty_->act()
                                                : next_;
}

QString QueueScreen::whereWords() const {
  const QString batch = selected();
  return session_ == nullptr || batch.isEmpty()
             ? QString()
             : batchWords(session_->project().catalogue(), batch);
}

void QueueScreen::setCompact(bool compact) {
  tools_->setCompact(compact);
  message_->setCompact(compact);
  masks_page_->setCompact(compact);
}

void QueueScreen::openProject(ProjectSession& session) {
  session_ = &session;
  thumbnails_ = new Thumbnails(session.jobs(), this);
  delegate_->setThumbnails(thumbnails_);
  connect(thumbnails_, &Thumbnails::ready, list_->viewport(),
          [this] { list_->viewport()->update(); });
  queue_->setSession(&session);
  marker_side_->setSession(&session);
  drafts_->setChecked(queue_->switches()->makesDrafts());
  log_->setPlainText(queue_->log().join(QLatin1Char('\n')));
  if (queue_->rowCount() > 0) list_->setCurrentIndex(queue_->index(0));
  follow();
}

void QueueScreen::closeProject() {
  leaveMasks();
  queue_->setSession(nullptr);
  marker_side_->setSession(nullptr);
  delegate_->setThumbnails(nullptr);
  if (thumbnails_ != nullptr) thumbnails_->deleteLater();
  thumbnails_ = nullptr;
  session_ = nullptr;
}

// The button of the log stands on every page: pressed only where the log is.
void QueueScreen::setInFront(bool in_front) {
  if (in_front_ && !in_front) log_wanted_ = log_action_->isChecked();
  in_front_ = in_front;
  log_action_->setChecked(in_front && log_wanted_);
  if (in_front)
    (pages_->currentWidget() == masks_area_ ? static_cast<QWidget*>(masks_page_) : list_)
        ->setFocus();
}

int QueueScreen::waiting() const {
  return queue_->failed() + (queue_->switches()->trouble().isEmpty() ? 0 : 1);
}

QString QueueScreen::waitingText() const {
  return queue_->switches()->trouble().isEmpty()
             ? tr("%n batch(es) stopped and need you", nullptr, waiting())
             : queue_->switches()->trouble();
}

void QueueScreen::showItem(const QString& batch) {
  const int row = queue_->rowOf(batch);
  if (row >= 0) list_->setCurrentIndex(queue_->index(row));
}

QString QueueScreen::selected() const {
  const QModelIndex at = list_->currentIndex();
  return at.isValid() && at.row() < queue_->rowCount() ? queue_->row(at.row()).number : QString();
}

void QueueScreen::follow() {
  const bool mending = pages_->currentWidget() == masks_area_ && queue_->rowCount() > 0;
  if (!mending) pages_->setCurrentIndex(queue_->rowCount() == 0 ? 1 : 0);
  if (!list_->currentIndex().isValid() && queue_->rowCount() > 0)
    list_->setCurrentIndex(queue_->index(0));
  followPause();
  const int at = queue_->rowOf(selected());
  const QueueState state = at < 0 ? QueueState::Shooting : queue_->row(at).state;
  followCancel(state, at >= 0 && queue_->row(at).aside, at >= 0 && queue_->row(at).stopping);
  again_->setEnabled(state == QueueState::Failed || state == QueueState::Done ||
                     state == QueueState::Review);
  report_->setEnabled(state == QueueState::Done || state == QueueState::Review ||
                      state == QueueState::Failed);
  review_->setEnabled(state == QueueState::Review || state == QueueState::Done);
  const bool masks = at >= 0 && queue_->row(at).has_masks;
  masks_->setEnabled(masks && (state == QueueState::Review || state == QueueState::Done ||
                               state == QueueState::Failed));
  masks_->setToolTip(at < 0 || masks ? QString() : tr("This batch has no masks."));
  followReadOnly();
  const bool moved = at >= 0 && queue_->row(at).figures && !queue_->row(at).figures->moved.empty();
  calibrate_->setEnabled(moved);
  calibrate_->setVisible(moved);
  // Where a brush is in hand, keys of the list must do nothing to the batch.
  if (mending)
    for (QAction* action : {cancel_, again_, report_, review_, masks_, calibrate_})
      action->setEnabled(false);
  marker_action_->setVisible(marker_side_->isTyped(selected()));
  marker_action_->setEnabled(again_->isEnabled());
  keep_both_->setVisible(at >= 0 && queue_->row(at).shared);
  keep_both_->setEnabled(again_->isEnabled());
  followNext(mending ? QueueState::Shooting : state);
  followStop();
  if (waiting() == waiting_said_) return;
  waiting_said_ = waiting();
  emit waitingChanged();
}

void QueueScreen::followStop() {
  const QueueSwitches& switches = *queue_->switches();
  const bool before = std::exchange(
      stop_shown_, session_ != nullptr && (!switches.trouble().isEmpty() || switches.isRestored()));
  if (stop_shown_) message_->setSecondAct({});
  if (!switches.trouble().isEmpty())
    message_->showError({ErrorCode::CannotWrite, switches.trouble().toStdString(), {}},
                        tr("Resume"));
  else if (stop_shown_)
    message_->showWords(State::Ask,
                        tr("The queue is paused: this project was restored from an archive."),
                        tr("Its batches that are not processed yet wait until you resume it."),
                        session_->whyReadOnly().isEmpty() ? tr("Resume") : QString());
  else if (before)
    message_->hide();
}

// What changes the project is not offered where that cannot be done.
void QueueScreen::followReadOnly() {
  const QString why = session_ == nullptr ? QString() : session_->whyReadOnly();
  again_->setToolTip(why);
  cancel_->setToolTip(why);
  drafts_->setEnabled(why.isEmpty());
  drafts_->setToolTip(
      why.isEmpty()
          ? tr("Processes each new batch quickly and coarsely, for a check while the sherds are "
               "still on the plate; reprocessing makes it final (D)")
          : why);
  if (why.isEmpty()) return;
  masks_->setToolTip(why);
  for (QAction* action : {again_, cancel_, masks_}) action->setEnabled(false);
}

// What Enter, a double click and the one button do with the batch.
void QueueScreen::followNext(QueueState state) {
  next_->setText(state == QueueState::Failed ? again_->text()
                 : state == QueueState::Done ? report_->text()
                                             : review_->text());
  next_->setEnabled((state == QueueState::Failed && again_->isEnabled()) ||
                    state == QueueState::Done || state == QueueState::Review);
  next_->setToolTip(state == QueueState::Failed && !again_->isEnabled() ? again_->toolTip()
                                                                        : QString());
}

void QueueScreen::openSelected() {
  const int at = queue_->rowOf(selected());
  if (at < 0 || !next_->isEnabled()) return;
  const QueueState state = queue_->row(at).state;
  if (state == QueueState::Done) return openReport();
  (state == QueueState::Failed ? again_ : review_)->trigger();
}

// One key for what is not wanted any more: what runs is stopped, what has failed is set aside.
void QueueScreen::followCancel(QueueState state, bool aside, bool stopping) {
  const bool failed = state == QueueState::Failed;
  const QString words = failed ? tr("Set aside") : tr("Cancel");
  if (cancel_->text() != words) {
    cancel_->setText(words);
    cancel_->setIcon(icon(failed ? QStringLiteral("aside") : QStringLiteral("cancel")));
  }
  cancel_->setEnabled(!stopping && (state == QueueState::Busy || state == QueueState::Paused ||
                                    state == QueueState::Waiting || (failed && !aside)));
}

void QueueScreen::followPause() {
  const QString words = queue_->switches()->isPaused() ? tr("Resume") : tr("Pause");
  if (pause_->text() != words) {
    pause_->setText(words);
    pause_->setIcon(
        icon(queue_->switches()->isPaused() ? QStringLiteral("play") : QStringLiteral("pause")));
  }
  pause_->setEnabled(queue_->switches()->isPaused() || queue_->waitingToCompute() > 0);
}

void QueueScreen::showMasks() {
  if (session_ == nullptr || selected().isEmpty()) return;
  masks_page_->openBatch(*session_, selected());
  pages_->setCurrentWidget(masks_area_);
  masks_page_->setFocus();
  follow();
}

QWidget* QueueScreen::masksPage() const {
  return masks_page_;
}

void QueueScreen::showImportsOf(BatchImporter* importer) {
  column_->addWidget(new ImportLine(importer, this));
  connect(importer, &BatchImporter::started, empty_, [this] {
    empty_->setWords(
        tr("Photographs are being imported; their batch appears here when all of "
           "them are copied."));
    empty_->act()->setText(tr("Show the import"));
  });
  connect(importer, &BatchImporter::ended, empty_, [this] { empty_->follow(session_); });
}

void QueueScreen::leaveMasks() {
  if (pages_->currentWidget() != masks_area_) return;
  masks_page_->closeBatch();
  pages_->setCurrentIndex(0);
  follow();
  list_->setFocus();
}

void QueueScreen::openReport() {
  if (session_ == nullptr || selected().isEmpty()) return;
  const std::filesystem::path results = session_->folder() / "results" / selected().toStdString();
  for (const char* file : {"report.html", "log.txt"})
    if (std::filesystem::exists(results / file)) {
      if (const Result<std::string> page = readFile(results / file);
          file == std::string_view("report.html") && !(page && isSafeReport(*page))) {
        emit said(tr("The report of %1 is not opened: this version of Ostraka did not write it, "
                     "and it may run scripts. Reprocess the batch to write it again.")
                      .arg(selected()));
        return;
      }
      emit said(openOutside(QString::fromStdString((results / file).string())));
      return;
    }
  emit said(tr("%1 has no report yet.").arg(selected()));
}

void QueueScreen::askOrCancel() {
  if (const int at = queue_->rowOf(selected());
      at >= 0 && queue_->row(at).state == QueueState::Failed)
    return queue_->setAside(selected());
  if (queue_->computation()->secondsOf(selected()) < kAskBeforeLosing_s) {
    queue_->cancel(selected());
    return;
  }
  asked_about_ = selected();
  message_->showWords(State::Ask, tr("Cancel %1?").arg(asked_about_),
                      tr("It has been processing for more than an hour. Finished stages are saved; "
                         "the current one is lost."),
                      tr("Cancel it"));
  message_->setSecondAct(tr("Keep processing"));
}

}  // namespace ostraka::ui
