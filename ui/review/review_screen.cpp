#include "ui/review/review_screen.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "catalogue/batches.h"
#include "intake/batch_figures.h"
#include "intake/computed_again.h"
#include "intake/enter_results.h"
#include "intake/plate_sherds.h"
#include "intake/settle_batch.h"
#include "ui/frame/no_batch_yet.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/look/look.h"
#include "ui/look/state_colours.h"
#include "ui/pairs/free_words.h"
#include "ui/pairs/pair_review.h"
#include "ui/review/review_pane.h"
#include "ui/widgets/message_panel.h"
#include "ui/widgets/parts.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

namespace fs = std::filesystem;

}  // namespace

ReviewScreen::ReviewScreen(QWidget* parent)
    : PlateScreen(tr("Review"), QStringLiteral("review"), parent) {
  batches_->view()->installEventFilter(this);
  person_ = named<QLineEdit>({"initials", tr("Your initials")}, this);
  person_->setMaxLength(8);
  person_->setMaximumWidth(fontMetrics().averageCharWidth() * 14);
  compute_ = named<QPushButton>("compute", tr("Update changed models"), this);
  compute_->setFocusPolicy(Qt::TabFocus);
  compute_->hide();
  auto* head =
      filled(new QHBoxLayout,
             {batches_, {message_, 1}, compute_, labelFor(person_, tr("Your &initials")), person_});
  empty_ = new NoBatchYet(QStringLiteral("review"), tr("No pairs to review yet"),
                          tr("Photograph or import a batch. Its pairs appear here when it is "
                             "processed."),
                          this);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(Look::kGap, Look::kGap, Look::kGap, Look::kGap);
  filled(all, {head, buildScale(), {empty_, 1}});
  connect(person_, &QLineEdit::editingFinished, this, [this] {
    if (session_) session_->setInitials(person_->text().trimmed());
    if (pane_) pane_->setFocus();
  });
  connect(compute_, &QPushButton::clicked, this, &ReviewScreen::compute);
}

QAbstractButton* ReviewScreen::primary() const {
  if (!empty_->isHidden() || !pane_) return empty_->act();
  return pane_->accept();
}

void ReviewScreen::setCompact(bool compact) {
  compact_ = compact;
  if (pane_) pane_->setCompact(compact);
}

// Enter in the open list is the list's alone. Qt closes it before the shortcuts are asked, and then
// the pair that one leaves would be accepted.
bool ReviewScreen::eventFilter(QObject* watched, QEvent* event) {
  if (watched == batches_->view() && event->type() == QEvent::ShortcutOverride) event->accept();
  return Screen::eventFilter(watched, event);
}

QWidget* ReviewScreen::buildScale() {
  scale_ = named<QFrame>("scaleInDoubt", this);
  scale_->setFrameShape(QFrame::StyledPanel);
  scale_->setAutoFillBackground(true);
  scale_words_ = wrappedLabel(scale_, "scaleWords");
  auto* report = new QPushButton(icon(QStringLiteral("report")), tr("Show report"), scale_);
  report->setFocusPolicy(Qt::TabFocus);
  connect(report, &QPushButton::clicked, this,
          [this] { emit wantsScreen(QStringLiteral("queue"), batch_); });
  filled(new QHBoxLayout(scale_), {{scale_words_, 1}, report});
  scale_->hide();
  return scale_;
}

// A batch that is held for its scale, or has none, says so beside its pairs: nothing here can
// settle it.
void ReviewScreen::showScale() {
  QString doubts;
  if (session_ && session_->hasProject())
    if (const auto batch =
            catalogue::Batches(session_->project().catalogue()).byNumber(batch_.toStdString()))
      doubts = wordsOf(batch->scale_doubts);
  doubts.replace(QLatin1Char('\n'), QLatin1Char(' '));
  const bool none = review_->batch().isOpen() && !review_->batch().table().has_scale;
  scale_words_->setText(
      none ? tr("%1 has no scale: no length shown here is in millimetres.").arg(batch_)
           : tr("No measurement of %1 is certain. %2").arg(batch_, doubts));
  QPalette look;  // the one colour only: all others follow the theme
  look.setColor(QPalette::Window, StateColours(QApplication::palette()).behind(State::Ask));
  scale_->setPalette(look);
  scale_->setVisible(none || !doubts.isEmpty());
}

void ReviewScreen::openProject(ProjectSession& session) {
  closeProject();
  session_ = &session;
  review_ = new PairReview(session.jobs(), session.undo(), this);
  const QString read_only = session.whyReadOnly();
  review_->setReadOnly(read_only);
  compute_->setEnabled(read_only.isEmpty());
  compute_->setToolTip(
      read_only.isEmpty() ? tr("Reprocesses the pairs that were decided differently") : read_only);
  pane_ = new ReviewPane(*review_, this);
  pane_->setCompact(compact_);
  layout()->addWidget(pane_);
  static_cast<QVBoxLayout*>(layout())->setStretchFactor(pane_, 1);
  setFocusProxy(pane_);
  person_->setText(session.initials());
  review_->setPerson(session.initials());
  connect(&session, &ProjectSession::initialsChanged, review_, &PairReview::setPerson);
  connect(&session, &ProjectSession::initialsChanged, person_, &QLineEdit::setText);
  connect(&session, &ProjectSession::batchChanged, this, &ReviewScreen::follow);
  connect(&session, &ProjectSession::sherdsChanged, this, &ReviewScreen::nameSherds);
  connect(review_, &PairReview::waitingChanged, this, &Screen::waitingChanged);
  connect(review_, &PairReview::failed, this, &ReviewScreen::say);
  connect(review_, &PairReview::personWanted, this, [this] {
    asked_ = message_->text();
    person_->setFocus();
  });
  connect(&session, &ProjectSession::initialsChanged, this, [this](const QString& initials) {
    if (!initials.isEmpty() && !asked_.isEmpty() && message_->text() == asked_) say({});
  });
  connect(review_, &PairReview::decided, this, &ReviewScreen::showApplied);
  review_->setApply([this](const fs::path& output, decisions::PairDecision decision) {
    if (!session_->hasProject()) return intake::applyToFileAlone(output, std::move(decision));
    return intake::applyDecision(session_->project().catalogue(), output.filename().string(),
                                 output, std::move(decision));
  });
  listBatches();
  if (batches_->count() > 0) showBatch(batches_->itemText(0));
}

void ReviewScreen::closeProject() {
  if (opening_) opening_->drop();
  if (pane_) pane_->deleteLater();
  if (review_ != nullptr) {
    review_->close();
    review_->deleteLater();
  }
  if (session_) disconnect(session_, nullptr, this, nullptr);
  review_ = nullptr;
  session_.clear();
  elsewhere_ = 0;
  batch_.clear();
  batches_->clear();
  message_->clear();
  compute_->hide();
  scale_->hide();
  emit waitingChanged();
}

void ReviewScreen::listBatches() {
  if (!session_) return;
  const QStringList names = reviewable();
  QStringList shown;
  for (int i = 0; i < batches_->count(); ++i) shown << batches_->itemText(i);
  if (pane_) pane_->setVisible(!names.isEmpty());  // empty panes would say nothing
  if (names.isEmpty()) empty_->follow(session_);
  empty_->setVisible(names.isEmpty());
  batches_->setVisible(!names.isEmpty());
  if (names == shown && !names.isEmpty()) return;
  batches_->clear();
  batches_->addItems(names);
  batches_->setCurrentText(batch_);
}

void ReviewScreen::showItem(const QString& batch) {
  if (!session_) return;
  listBatches();
  showBatch(batch);
}

void ReviewScreen::showBatch(const QString& batch) {
  if (!session_ || batch.isEmpty()) return;
  review_->close();  // nothing is to be decided on what is no longer meant
  batch_ = batch;
  stamp_ = stampOf(batch);
  emit whereChanged();
  countElsewhere();
  batches_->setCurrentText(batch);
  compute_->hide();
  message_->clear();
  showScale();
  if (opening_) opening_->drop();
  const fs::path rows = session_->hasProject() ? session_->project().folder() : fs::path();
  opening_ =
      session_->jobs().start(makeJob([output = outputOf(batch), rows](Progress&, std::stop_token) {
                               return openBatch(output, rows);
                             }),
                             this);
  whenDone<OpenedBatch>(opening_, this, [this](const auto& opened) {
    if (!opened) return say(sentenceOf(opened.error()));
    showOpened(*opened);
  });
}

void ReviewScreen::showOpened(const OpenedBatch& opened) {
  review_->open(opened);
  showScale();
  nameSherds();
  compute_->setVisible(review_->batch().wantsComputing());
  if (pane_ && isVisible() && !person_->hasFocus()) pane_->setFocus();  // for the keys
  for (const Message& warning : review_->batch().review().warnings) say(wordsOf(warning));
  if (!opened.caught_up) say(sentenceOf(opened.caught_up.error()));
  if (!opened.caught_up || *opened.caught_up == 0) return;
  const Result<bool> settled =
      intake::settleByResults(session_->project().catalogue(), batch_.toStdString(),
                              outputOf(batch_), session_->initials().toStdString());
  if (!settled) say(sentenceOf(settled.error()));
  if (settled && !*settled) restoreModels(batch_);
  session_->tellBatchChanged(batch_);
  session_->tellSherdsChanged();
}

// The queue computes; this only says that the batch wants it.
void ReviewScreen::compute() {
  if (!session_ || !session_->hasProject()) return;
  const Result<void> queued = intake::queueAgain(session_->project().catalogue(),
                                                 batch_.toStdString(), session_->provenance());
  if (!queued) return say(sentenceOf(queued.error()));
  compute_->hide();
  say(tr("%1 is queued; only what changed is reprocessed.").arg(batch_));
  session_->tellBatchChanged(batch_);
}

// The decision is taken; what it did is said.
void ReviewScreen::showApplied(const fs::path& output, const intake::AppliedDecision& applied) {
  const QString batch = QString::fromStdString(output.filename().string());
  if (review_->batch().isIn(output))
    compute_->setVisible(review_->batch().wantsComputing());
  else
    showBatch(batch);  // where the change is visible
  say(told_ = appliedWords(applied));
  for (const Error& error : applied.errors) say(sentenceOf(error));
  for (const intake::AppliedDecision::Twice& twice : applied.twice)
    say(tr("%1 was reshot as %2 in %3 and now has two records. Void one of them in the "
           "catalogue, or set the fragment aside here.")
            .arg(nameOf(twice.scan), QString::fromStdString(twice.again.number),
                 QString::fromStdString(twice.again.batch_number)));
  if (session_->hasProject() && !applied.wants_computing) restoreModels(batch);
  session_->tellBatchChanged(batch);
}

// A number that loses its piece is said when it is done, not found later in the table.
QString ReviewScreen::appliedWords(const intake::AppliedDecision& applied) const {
  const QString split = QString::fromStdString(applied.split_number);
  const QString kept = QString::fromStdString(applied.joined.kept);
  const QString left = QString::fromStdString(applied.joined.left);
  if (!split.isEmpty())
    return tr("Saved. After reprocessing, number %1 goes to the half that it was typed on, or else "
              "to the larger one. Undo merges them again.")
        .arg(split);
  if (!left.isEmpty())
    return kept.isEmpty() ? tr("Saved. After reprocessing, the merged sherd has no number, and "
                               "%1 has no fragment. Undo separates them again.")
                                .arg(left)
                          : tr("Saved. After reprocessing, the merged sherd keeps the number "
                               "%1, and %2 has no fragment. Undo separates them again.")
                                .arg(kept, left);
  switch (applied.decision.kind) {
    case decisions::DecisionKind::Join:
    case decisions::DecisionKind::Split:
      return tr("Saved. Pairs of the new fragments appear after reprocessing.");
    case decisions::DecisionKind::Withdraw:
      return tr("Undone. The history keeps both.");
    default:
      break;
  }
  if (!review_->batch().isOpen() || review_->waiting() > 0) return tr("Saved, with your initials.");
  return compute_->isHidden()
             ? tr("Saved. All pairs of %1 are decided. Next: the sherds in the catalogue.")
                   .arg(batch_)
             : tr("Saved. All pairs of %1 are decided. Next: update the changed models.")
                   .arg(batch_);
}

// What the catalogue calls the sherds on the cards.
void ReviewScreen::nameSherds() {
  if (!session_ || !session_->hasProject() || review_ == nullptr || !review_->batch().isOpen())
    return;
  const intake::PlateSherds sherds(session_->project().catalogue(), batch_.toStdString());
  QHash<int, QString> numbers;
  const std::vector<decisions::ScanRef>& fronts = review_->batch().table().fronts;
  for (std::size_t i = 0; i < fronts.size(); ++i)
    if (const auto* sherd = sherds.at(fronts[i].place_mm); sherd && !sherd->number.empty())
      numbers.insert(static_cast<int>(i), QString::fromStdString(sherd->number));
    else if (const auto* again = sherds.again(fronts[i].place_mm))
      numbers.insert(static_cast<int>(i), QCoreApplication::translate("ostraka::ui", "%1 in %2")
                                              .arg(QString::fromStdString(again->number),
                                                   QString::fromStdString(again->batch_number)));
  review_->cards().setNumbers(numbers);
}

// A sherd that lost its back lost its model. When the pair is again as it was computed, its results
// lie there still.
void ReviewScreen::restoreModels(const QString& batch) {
  JobHandle* job =
      session_->jobs().start(makeJob([folder = session_->folder(), number = batch.toStdString()](
                                         Progress& progress, std::stop_token stop) -> Result<bool> {
                               return intake::enterLostModels(folder, number, progress, stop);
                             }),
                             this);
  whenDone<bool>(job, this, [this, batch, session = session_](const auto& restored) {
    if (!restored) return say(sentenceOf(restored.error()));
    if (!*restored || !session || session != session_) return;
    session_->tellBatchChanged(batch);
    session_->tellSherdsChanged();
  });
}

// What another screen did to this batch: new pairs are shown, a mere change of its state is not.
void ReviewScreen::follow(const QString& batch) {
  countElsewhere();
  if (batches_->findText(batch) < 0) listBatches();
  if (batches_->findText(batch) < 0) return;
  if (batch == batch_) showScale();
  // The first batch that is computed shows itself; one that was computed anew is read anew.
  if (batch_.isEmpty() || (batch == batch_ && stampOf(batch) > stamp_)) showBatch(batch);
}

// The report is written last, and is gone while the batch is computed.
fs::file_time_type ReviewScreen::stampOf(const QString& batch) const {
  std::error_code gone;
  return std::max(fs::last_write_time(outputOf(batch) / "work" / "pairs" / "candidates.json", gone),
                  fs::last_write_time(outputOf(batch) / "report.json", gone));
}

void ReviewScreen::setInFront(bool in_front) {
  if (in_front && pane_) pane_->setFocus();
  if (!in_front && message_->text() == told_) message_->clear();  // it is about what was just done
}

// Else the batch that waits for a person, where the one that is shown does not.
void ReviewScreen::takeChosen(const QString& what) {
  if (what.startsWith(kPlate) && what != chosen()) return PlateScreen::takeChosen(what);
  if (review_ == nullptr || opening_ || review_->waiting() > 0 || waits_.isEmpty()) return;
  listBatches();
  if (const QString batch = waits_; batches_->findText(batch) >= 0) showBatch(batch);
}

// Of all batches: what is not opened yet waits as well.
int ReviewScreen::waiting() const {
  return (review_ != nullptr ? review_->waiting() : 0) + elsewhere_;
}

void ReviewScreen::countElsewhere() {
  elsewhere_ = 0;
  waits_.clear();
  if (session_ && session_->hasProject()) {
    const catalogue::Catalogue& rows = session_->project().catalogue();
    if (const auto batches = catalogue::Batches(rows).all())
      for (const records::BatchRecord& batch : *batches) {
        const QString number = QString::fromStdString(batch.number);
        if (batch.state != records::BatchState::Review || number == batch_) continue;
        const auto figures = intake::keptFigures(rows, batch.number);
        if (!figures || figures->ask == 0) continue;
        elsewhere_ += figures->ask;
        waits_ = number;  // the newest
      }
  }
  emit waitingChanged();
}

QString ReviewScreen::waitingText() const {
  return waiting() == 0 ? tr("No pairs to review") : tr("%n pair(s) to review", nullptr, waiting());
}

}  // namespace ostraka::ui
