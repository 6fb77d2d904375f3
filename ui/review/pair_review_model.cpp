#include "ui/review/pair_review_model.h"

#include <QUndoStack>
#include <algorithm>

#include "ui/review/free_words.h"
#include "ui/review/review_commands.h"
#include "ui/review/review_words.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

using batch::Side;
using decisions::DecisionKind;
using decisions::PairDecision;
using review::CardState;
using review::ReviewCandidate;

}  // namespace

PairReviewModel::PairReviewModel(JobRunner& runner, QUndoStack& undo, QObject* parent)
    : QAbstractListModel(parent), runner_(runner), undo_(undo), apply_(intake::applyToFileAlone) {}

void PairReviewModel::open(OpenedBatch batch) {
  beginResetModel();
  dropJobs();  // of the batch before: its fronts and backs are others
  candidates_.clear();
  live_ = std::move(batch.live);
  decisions_ = std::move(batch.decisions);
  followed_ = std::move(batch.followed);
  thumbnails_.clear();
  more_.clear();
  asked_.clear();
  trial_ = {};
  review_ = program_ = {};
  if (const auto alone = review::reviewOf(live_->table(), {})) program_ = *alone;
  if (const Result<review::Review> review =
          review::reviewOf(live_->table(), decisions::standing(decisions_)))
    review_ = *review;
  else
    emit failed(sentenceOf(review.error()));
  rows_ = rowsOf(review_);
  markPieces(rows_, live_->table(), decisions_, followed_);
  endResetModel();
  emit waitingChanged();
  thumbnails_job_ = runner_.start(
      makeJob(tr("Small pictures of the sherds"),
              [live = live_](Progress&, std::stop_token stop) { return scanPictures(live, stop); }),
      this);
  connect(thumbnails_job_, &JobHandle::finished, this, [this](const JobOutcome& outcome) {
    const auto pictures = outcomeAs<ScanPictures>(outcome);
    if (!pictures) return;  // cards without pictures still have names
    thumbnails_ = *pictures;
    if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1));
  });
  selectRow(0);
}

void PairReviewModel::dropJobs() {
  for (const QPointer<JobHandle>& job :
       {scene_job_, fit_job_, more_job_, thumbnails_job_, model_job_})
    if (job) job->drop();
  scene_job_ = fit_job_ = more_job_ = thumbnails_job_ = model_job_ = nullptr;
  busy_ = scene_wanted_ = clouds_wanted_ = false;
}

void PairReviewModel::close() {
  beginResetModel();
  dropJobs();
  live_.reset();
  review_ = program_ = {};
  rows_.clear();
  decisions_.clear();
  followed_.clear();
  candidates_.clear();
  trial_ = {};
  scene_wanted_ = clouds_wanted_ = busy_ = false;
  endResetModel();
  emit cardChanged();
  emit candidatesChanged();
  emit waitingChanged();
}

bool PairReviewModel::shows(const std::filesystem::path& output) const {
  return live_ && live_->output() == output;
}

void PairReviewModel::setPerson(const QString& initials) {
  person_ = initials.trimmed();
  emit cardChanged();
}

int PairReviewModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant PairReviewModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount() || !live_) return {};
  const ReviewRow& row = at(index.row());
  const auto words = [&] {
    if (const QString change = pieceSentence(row); !change.isEmpty()) return change;
    const review::ReviewCard* of = review_.ofFront(row.front);
    return of == nullptr ? loneBackSentence(row) : doubtSentence(*of, live_->table(), storyOf(*of));
  };
  const auto picture = [this](Side side, int scan) {
    const auto found = thumbnails_.find({side, scan});
    return found == thumbnails_.end() ? QImage() : found->second;
  };
  switch (role) {
    case Qt::DisplayRole:
      return rowName(row, live_->table());
    case Qt::ToolTipRole:
    case CardRole::Words:
      return words();
    case Qt::AccessibleTextRole:
      return tr("%1, %2. %3").arg(rowName(row, live_->table()), rowWord(row), words());
    case CardRole::SherdNumber:
      return numbers_.value(row.front);
    case CardRole::Front:
      return row.front;
    case CardRole::Back:
      return row.back;
    case CardRole::State:
      return static_cast<int>(row.state);
    case CardRole::Waits:
      return row.change != PieceChange::None;
    case CardRole::StateWord:
      return rowWord(row);
    case CardRole::FrontPicture:
      return picture(Side::Front, row.front);
    case CardRole::BackPicture:
      return picture(Side::Back, row.back);
    default:
      return {};
  }
}

void PairReviewModel::setNumbers(const QHash<int, QString>& numbers) {
  if (numbers == numbers_) return;
  emit layoutAboutToBeChanged();  // a card with a number is higher
  numbers_ = numbers;
  emit layoutChanged();
}

int PairReviewModel::rowOf(int front) const {
  for (int row = 0; row < rowCount(); ++row)
    if (front >= 0 && at(row).front == front) return row;
  return -1;
}

int PairReviewModel::rowOfLoneBack(int back) const {
  for (int row = 0; row < rowCount(); ++row)
    if (at(row).isLoneBack() && at(row).back == back) return row;
  return -1;
}

int PairReviewModel::rowInHand() const {
  return trial_.front >= 0 ? rowOf(trial_.front) : rowOfLoneBack(trial_.back);
}

const review::ReviewCard* PairReviewModel::card() const {
  return review_.ofFront(trial_.front);
}

int PairReviewModel::chosen() const {
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    if (candidates_[i].back == trial_.back) return static_cast<int>(i);
  return -1;
}

QString PairReviewModel::reason() const {
  const int row = rowInHand();
  if (row < 0) return {};
  const QString words = index(row).data(CardRole::Words).toString();
  if (card() == nullptr || at(row).change != PieceChange::None) return words;
  const Trial stands = standing(*card());
  const bool tried = trial_.back != stands.back || trial_.made != stands.made ||
                     trial_.front_from_back.matrix() != stands.front_from_back.matrix();
  if (tried && trial_.back >= 0) {
    const double score = chosen() < 0 ? 0 : candidates_[static_cast<std::size_t>(chosen())].score;
    return triedSentence(trial_, score, isMeasured() ? &fit_ : nullptr, *card(), live_->table());
  }
  const bool stated = card()->state == CardState::Decided || card()->state == CardState::Sure;
  const bool poor = stated && isMeasured() && fit_.hardlyMeets();
  return poor ? words + QLatin1Char(' ') + hardlyMeetSentence(fit_) : words;
}

bool PairReviewModel::isMeasured() const {
  return fit_.front_from_back.matrix() == trial_.front_from_back.matrix();
}

QString PairReviewModel::figuresText() const {
  if (trial_.back < 0) return tr("No back is chosen.");
  if (trial_.front < 0) return tr("This back has no partner.");
  if (!(fit_.fracture_rms_mm > 0)) return tr("The fractures do not touch here.");
  QString text = tr("Fractures %1 apart, %2 of them touch.")
                     .arg(mm(fit_.fracture_rms_mm), percent(fit_.fracture_overlap));
  if (trial_.made == Made::ByHand) text += " " + tr("Turned by hand; B refines the fit.");
  if (trial_.made == Made::StartPoint)
    text += " " + tr("Start point %1; B refines the fit.").arg(trial_.shift);
  const QString failed_check = slipSentence(fit_.failed_check, 0);
  if (fit_.check_failed && !failed_check.isEmpty() &&
      fit_.failed_check == registration::FailedCheck::UpsideDown)
    text += " " + failed_check;
  return text;
}

QString PairReviewModel::whyNotAccept() const {
  if (!live_ || trial_.front < 0) return tr("No pair is chosen: give this back to a front first.");
  if (trial_.back < 0) return tr("Choose a back first.");
  if (person_.isEmpty()) return tr("Enter your initials first: each decision keeps its name.");
  return {};
}

int PairReviewModel::holderOf(int back) const {
  const review::ReviewCard* holder = review_.ofBack(back);
  return holder == nullptr ? -1 : holder->front;
}

bool PairReviewModel::wantsComputing() const {
  return live_ &&
         !review::onlyConfirm(live_->table(), decisions::changedSince(decisions_, followed_));
}

void PairReviewModel::selectRow(int row) {
  if (row < 0 || row >= rowCount()) return;
  if (!at(row).isLoneBack()) return select(at(row).front);
  Trial trial;
  trial.back = at(row).back;
  hold(trial);
}

void PairReviewModel::next() {
  selectRow(std::min(rowInHand() + 1, rowCount() - 1));
}

void PairReviewModel::previous() {
  selectRow(std::max(rowInHand() - 1, 0));
}

void PairReviewModel::select(int front) {
  const review::ReviewCard* chosen_card = review_.ofFront(front);
  if (chosen_card == nullptr) return;
  hold(standing(*chosen_card));
}

void PairReviewModel::show(const decisions::ScanRef& scan, const Trial& tried) {
  const bool front = scan.side == Side::Front;
  const int at = decisions::resolved(scan, front ? live_->table().fronts : live_->table().backs);
  const int row = front ? rowOf(at) : std::max(rowOfLoneBack(at), rowOf(holderOf(at)));
  if (row >= 0 && tried.back >= 0 && this->at(row).isAbout(tried.front, tried.back))
    return hold(tried);
  selectRow(row);
}

void PairReviewModel::hold(const Trial& trial) {
  trial_ = trial;
  takeCandidates();
  if (chosen() >= 0 && trial_.shift < 0)
    trial_.shift = candidates_[static_cast<std::size_t>(chosen())].shift;
  emit cardChanged();
  emit trialChanged();
  fetchScene(Clouds::Fetch);
}

void PairReviewModel::takeCandidates() {
  candidates_ = candidatesOf(trial_.front);
  emit candidatesChanged();
}

std::vector<ReviewCandidate> PairReviewModel::candidatesOf(int front) const {
  std::vector<ReviewCandidate> all;
  if (const review::ReviewCard* of = review_.ofFront(front)) all = of->candidates;
  const auto more = more_.find(front);
  if (more == more_.end()) return all;
  for (const ReviewCandidate& c : more->second) {
    const bool known = std::any_of(all.begin(), all.end(),
                                   [&](const ReviewCandidate& o) { return o.back == c.back; });
    if (!known) all.push_back(c);
  }
  return all;
}

void PairReviewModel::choose(int candidate) {
  if (candidate < 0 || candidate >= static_cast<int>(candidates_.size())) return;
  const ReviewCandidate& c = candidates_[static_cast<std::size_t>(candidate)];
  Trial trial{trial_.front, c.back, c.front_from_back, Made::Program, c.shift};
  // What was decided for this very pair is shown as it was decided.
  if (card() != nullptr && card()->back == c.back) trial = standing(*card());
  trial.shift = c.shift;
  tryOut(trial, tr("choice of %1").arg(nameOf(backRef(c.back))));
}

void PairReviewModel::chooseBack(int back) {
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    if (candidates_[i].back == back) return choose(static_cast<int>(i));
  if (!live_ || trial_.front < 0) return;
  busy_ = true;
  emit busyChanged(true);
  const int front = trial_.front;
  if (fit_job_) fit_job_->drop();  // its result is not wanted any more
  fit_job_ = runner_.start(makeJob(tr("Comparing two sides"),
                                   [live = live_, front, back](Progress&, std::stop_token stop) {
                                     return oneCandidate(live, front, back, stop);
                                   }),
                           this);
  connect(fit_job_, &JobHandle::finished, this, [this, front, back](const JobOutcome& outcome) {
    busy_ = false;
    emit busyChanged(false);
    const auto candidate = outcomeAs<ReviewCandidate>(outcome);
    if (!candidate) return emit failed(sentenceOf(candidate.error()));
    more_[front].push_back(*candidate);
    if (front != trial_.front) return;
    takeCandidates();
    chooseBack(back);
  });
}

void PairReviewModel::tryOut(const Trial& trial, const QString& text, bool merge) {
  undo_.push(new TryCommand(*this, trial_, trial, text, merge));
}

void PairReviewModel::showTrial(const Trial& trial) {
  const bool same_pair = trial.front == trial_.front && trial.back == trial_.back;
  if (trial.front != trial_.front) {
    trial_.front = trial.front;
    takeCandidates();
  }
  trial_ = trial;
  if (!same_pair) emit cardChanged();
  emit trialChanged();
  fetchScene(same_pair ? Clouds::Leave : Clouds::Fetch);
}

PairDecision PairReviewModel::about(DecisionKind kind) const {
  PairDecision decision;
  decision.kind = kind;
  decision.by = person_.toStdString();
  decision.scans = {trial_.front >= 0 ? frontRef(trial_.front) : backRef(trial_.back)};
  return decision;
}

decisions::ScanRef PairReviewModel::frontRef(int i) const {
  return live_->table().fronts.at(static_cast<std::size_t>(i));
}

decisions::ScanRef PairReviewModel::backRef(int i) const {
  return live_->table().backs.at(static_cast<std::size_t>(i));
}

QString PairReviewModel::inHand() const {
  const decisions::ScanRef& scan =
      trial_.front >= 0 ? frontRef(trial_.front) : backRef(trial_.back);
  return nameOf(scan);
}

void PairReviewModel::accept() {
  if (!canAccept()) {
    emit failed(whyNotAccept());
    if (person_.isEmpty()) emit personWanted();
    return;
  }
  PairDecision decision = about(DecisionKind::Pair);
  decision.scans.push_back(backRef(trial_.back));
  decision.front_from_back = trial_.front_from_back;
  decision.settle =
      trial_.made == Made::ByHand ? decisions::Settle::AsGiven : decisions::Settle::ByFractures;
  const QString front = inHand(), back = nameOf(backRef(trial_.back));
  const review::LiveFit fit = isMeasured() ? fit_ : review::LiveFit{.fracture_overlap = 1};
  const std::size_t before = decisions_.size();
  decide(decision, tr("pair %1 – %2").arg(front, back));
  if (decisions_.size() > before && fit.hardlyMeets())
    emit failed(
        tr("Saved, with your name; but the fractures of %1 and %2 barely touch: %3 of them.")
            .arg(front, back, percent(fit.fracture_overlap)));
}

void PairReviewModel::setAside() {
  if (rowInHand() < 0 || !personIsKnown()) return;
  decide(about(DecisionKind::Aside), tr("setting aside %1").arg(inHand()));
}

void PairReviewModel::reshoot() {
  if (rowInHand() < 0 || !personIsKnown()) return;
  PairDecision decision = about(DecisionKind::Reshoot);
  if (card() != nullptr && card()->back >= 0) decision.scans.push_back(backRef(card()->back));
  decide(decision, tr("reshooting %1").arg(inHand()));
}

void PairReviewModel::giveBack(int front, int back) {
  if (!live_ || front < 0 || back < 0 || !personIsKnown()) return;
  const decisions::RegisteredCandidate* known = live_->table().find(front, back);
  if (known == nullptr) {  // how they fit is to be seen first
    select(front);
    return chooseBack(back);
  }
  PairDecision decision = about(DecisionKind::Pair);
  decision.scans = {frontRef(front), backRef(back)};
  decision.front_from_back = known->registration.front_from_back;
  decide(decision, tr("pair %1 – %2").arg(nameOf(frontRef(front)), nameOf(backRef(back))));
}

void PairReviewModel::joinWith(Side side, int row) {
  const int mine = rowInHand();
  if (mine < 0 || row < 0 || row >= rowCount() || row == mine || !personIsKnown()) return;
  const ReviewRow &one = at(mine), &other = at(row);
  PairDecision decision = about(DecisionKind::Join);
  if (side == Side::Front && !one.isLoneBack() && !other.isLoneBack()) {
    decision.scans.push_back(frontRef(other.front));
  } else {
    if (one.back < 0 || other.back < 0)
      return emit failed(tr("One of the two has no back to merge."));
    decision.scans = {backRef(one.back), backRef(other.back)};
  }
  decide(decision,
         tr("merging %1 and %2").arg(nameOf(decision.scans[0]), nameOf(decision.scans[1])));
}

void PairReviewModel::split(Side side, const Eigen::Vector2d& a_mm, const Eigen::Vector2d& b_mm) {
  if (rowInHand() < 0 || !personIsKnown()) return;
  if ((side == Side::Back ? trial_.back : trial_.front) < 0) return;
  PairDecision decision = about(DecisionKind::Split);
  decision.cut_mm = {a_mm, b_mm};
  if (side == Side::Back) {
    const decisions::ScanRef back = backRef(trial_.back);
    decision.scans = {back};
    for (Eigen::Vector2d& p : decision.cut_mm)
      if (trial_.front >= 0)  // a back alone is shown as it lies on its own plate
        p = review::onBackPlate(trial_.front_from_back, back, p);
  }
  decide(decision, tr("splitting %1").arg(nameOf(decision.scans[0])));
}

bool PairReviewModel::personIsKnown() {
  if (!person_.isEmpty()) return true;
  emit failed(tr("Enter your initials first: each decision keeps its name."));
  emit personWanted();
  return false;
}

void PairReviewModel::decide(PairDecision decision, const QString& text) {
  const int row = rowInHand();
  undo_.push(new DecideCommand(*this, std::move(decision), text));
  // On to what wants a person most; without any to the card that moved up to here.
  selectRow(!rows_.empty() && rows_[0].wantsPerson() ? 0 : std::min(row, rowCount() - 1));
}

Result<void> PairReviewModel::write(const std::filesystem::path& output, PairDecision& decision) {
  const Result<intake::AppliedDecision> applied = apply_(output, decision);
  if (!applied) {
    emit failed(sentenceOf(applied.error()));
    return applied.error();
  }
  decision = applied->decision;
  if (shows(output)) {
    decisions_.push_back(decision);
    redoReview();
  }
  emit decided(output, *applied);
  return {};
}

void PairReviewModel::redoReview() {
  const Result<review::Review> review =
      review::reviewOf(live_->table(), decisions::standing(decisions_));
  if (!review) return emit failed(sentenceOf(review.error()));
  std::vector<ReviewRow> rows = rowsOf(*review);
  markPieces(rows, live_->table(), decisions_, followed_);
  if (rows.size() != rows_.size()) {  // a back became somebody's, or nobody's
    beginResetModel();
    review_ = *review;
    rows_ = std::move(rows);
    endResetModel();
    return emit waitingChanged();
  }
  emit layoutAboutToBeChanged();
  const QModelIndexList before = persistentIndexList();
  std::vector<ReviewRow> were;
  for (const QModelIndex& i : before) were.push_back(at(i.row()));
  review_ = *review;
  rows_ = std::move(rows);
  QModelIndexList after;
  for (const ReviewRow& was : were) {
    const auto now = std::find_if(rows_.begin(), rows_.end(), [&](const ReviewRow& row) {
      return row.isAbout(was.front, was.back);
    });
    after.append(now == rows_.end() ? QModelIndex() : index(static_cast<int>(now - rows_.begin())));
  }
  changePersistentIndexList(before, after);
  emit layoutChanged();
  if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1));
  emit waitingChanged();
}

}  // namespace ostraka::ui
