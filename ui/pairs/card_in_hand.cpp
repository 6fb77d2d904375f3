#include "ui/pairs/card_in_hand.h"

#include <QUndoStack>
#include <algorithm>

#include "ui/jobs/when_done.h"
#include "ui/pairs/free_words.h"
#include "ui/pairs/review_commands.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

using review::ReviewCandidate;
using ScenePtr = std::shared_ptr<const PairScene>;

// Settles the back from a pose; whoever looks on sees it come.
Result<review::LiveFit> settledInSight(const LivePairsPtr& live, int front, int back,
                                       const Eigen::Isometry3d& from, Progress& progress,
                                       std::stop_token stop) {
  return live->settled(front, back, from, std::move(stop),
                       [&progress](const review::LiveFit& fit) { tell(progress, fit); });
}

}  // namespace

CardInHand::CardInHand(JobRunner& runner, QUndoStack& undo, ReviewedBatch& batch,
                       const CardListModel& cards)
    : runner_(runner), undo_(undo), batch_(batch), cards_(cards) {}

void CardInHand::hold(const Trial& trial) {
  trial_ = trial;
  updateCandidates();
  if (chosen() >= 0 && trial_.shift < 0)
    trial_.shift = candidates_[static_cast<std::size_t>(chosen())].shift;
  fetchScene(Clouds::Fetch);  // before anybody asks whether the pair is there
  emit cardChanged();
  emit trialChanged();
}

void CardInHand::clear() {
  for (QPointer<JobHandle>* job : {&scene_job_, &fit_job_, &model_job_}) dropJob(*job);
  busy_ = scene_wanted_ = clouds_wanted_ = false;
  candidates_.clear();
  trial_ = {};
  scene_.reset();
  emit cardChanged();
  emit candidatesChanged();
}

void CardInHand::updateCandidates() {
  candidates_ = batch_.candidatesOf(trial_.front);
  emit candidatesChanged();
}

int CardInHand::chosen() const {
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    if (candidates_[i].back == trial_.back) return static_cast<int>(i);
  return -1;
}

QString CardInHand::reason() const {
  if (row() < 0) return {};
  const QString words = batch_.wordsOf(cards_.at(row()));
  if (card() == nullptr || cards_.at(row()).change != PieceChange::None) return words;
  if (isTried() && trial_.back >= 0) {
    std::optional<double> score = 0;
    if (chosen() >= 0) score = candidates_[static_cast<std::size_t>(chosen())].score;
    if (!card()->score) score.reset();
    return triedSentence(trial_, score, isMeasured() ? &fit_ : nullptr, *card(), batch_.table());
  }
  const bool stated =
      card()->state == review::CardState::Decided || card()->state == review::CardState::Sure;
  const bool poor = stated && isMeasured() && fit_.hardlyMeets();
  return poor ? words + QLatin1Char(' ') + hardlyMeetSentence(fit_) : words;
}

bool CardInHand::isTried() const {
  if (card() == nullptr) return false;
  const Trial stands = batch_.standing(*card());
  return trial_.back != stands.back || trial_.made != stands.made ||
         trial_.front_from_back.matrix() != stands.front_from_back.matrix();
}

bool CardInHand::isMeasured() const {
  return isShown() && fit_.front_from_back.matrix() == trial_.front_from_back.matrix();
}

QString CardInHand::figuresText() const {
  if (row() < 0) return {};
  if (isLoading()) return tr("Loading…");
  if (trial_.back < 0) return tr("No back is chosen.");
  if (trial_.front < 0) return tr("This back has no partner.");
  if (!isShown()) return {};  // it could not be loaded, and that was said
  if (!(fit_.fracture_rms_mm > 0)) return tr("The fractures do not touch here.");
  QString text = tr("Fractures %1 apart, %2 of them touch.")
                     .arg(mm(fit_.fracture_rms_mm), percent(fit_.fracture_overlap));
  if (trial_.made == Made::ByHand) text += " " + tr("Turned by hand; B refines the fit.");
  if (trial_.made == Made::StartPoint)
    text += " " + tr("Start point %1; B refines the fit.").arg(trial_.shift);
  if (fit_.failed_check == registration::FailedCheck::UpsideDown)
    text += " " + failedCheckSentence(fit_.failed_check, 0);
  return text;
}

void CardInHand::choose(int candidate) {
  if (candidate < 0 || candidate >= static_cast<int>(candidates_.size())) return;
  const ReviewCandidate& c = candidates_[static_cast<std::size_t>(candidate)];
  Trial trial{trial_.front, c.back, c.front_from_back, Made::Program, c.shift};
  // What was decided for this very pair is shown as it was decided.
  if (card() != nullptr && card()->back == c.back) trial = batch_.standing(*card());
  trial.shift = c.shift;
  tryOut(trial, tr("choice of %1").arg(nameOf(batch_.back(c.back))));
}

void CardInHand::chooseBack(int back) {
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    if (candidates_[i].back == back) return choose(static_cast<int>(i));
  if (!batch_.isOpen() || trial_.front < 0) return;
  busy_ = true;
  emit busyChanged(true);
  const int front = trial_.front;
  dropJob(fit_job_);  // its result is not wanted any more
  fit_job_ =
      runner_.start(makeJob([live = batch_.live(), front, back](Progress&, std::stop_token stop) {
                      return oneCandidate(live, front, back, stop);
                    }),
                    this);
  whenDone<ReviewCandidate>(fit_job_, this, [this, front, back](const auto& candidate) {
    busy_ = false;
    emit busyChanged(false);
    if (!candidate) return emit failed(sentenceOf(candidate.error()));
    batch_.addCandidate(front, *candidate);
    if (front != trial_.front) return;
    updateCandidates();
    chooseBack(back);
  });
}

void CardInHand::tryOut(const Trial& trial, const QString& text, bool merge) {
  undo_.push(new TryCommand(*this, trial_, trial, text, merge));
}

void CardInHand::showTrial(const Trial& trial) {
  const bool same_pair = trial.front == trial_.front && trial.back == trial_.back;
  if (trial.front != trial_.front) {
    trial_.front = trial.front;
    updateCandidates();
  }
  trial_ = trial;
  fetchScene(same_pair ? Clouds::Leave : Clouds::Fetch);
  if (!same_pair) emit cardChanged();
  emit trialChanged();
}

void CardInHand::stepStart(int by) {
  if (chosen() < 0) return;
  const std::vector<int>& shifts = candidates_[static_cast<std::size_t>(chosen())].shifts;
  if (shifts.empty()) return;
  const int n = static_cast<int>(shifts.size());
  int at = 0;  // the good start point nearest to the present one
  for (int i = 0; i < n; ++i)
    if (std::abs(shifts[static_cast<std::size_t>(i)] - trial_.shift) <
        std::abs(shifts[static_cast<std::size_t>(at)] - trial_.shift))
      at = i;
  const int to = shifts[static_cast<std::size_t>(((at + by) % n + n) % n)];
  const int front = trial_.front, back = trial_.back;
  fitAt(
      [live = batch_.live(), front, back, to](Progress& progress,
                                              std::stop_token stop) -> Result<review::LiveFit> {
        const Result<review::LiveFit> start = live->atStartPoint(front, back, to);
        if (!start) return start;
        Result<review::LiveFit> fit =
            settledInSight(live, front, back, start->front_from_back, progress, stop);
        if (fit) fit->shift = to;
        return fit;
      },
      Made::Settled, tr("start point"));
}

void CardInHand::stepSample(int by) {
  if (trial_.front < 0 || trial_.back < 0) return;
  const int front = trial_.front, back = trial_.back, to = std::max(0, trial_.shift) + by;
  fitAt([live = batch_.live(), front, back, to](
            Progress&, std::stop_token) { return live->atStartPoint(front, back, to); },
        Made::StartPoint, tr("start point"));
}

void CardInHand::settle() {
  if (trial_.front < 0 || trial_.back < 0) return;
  const Trial from = trial_;
  fitAt(
      [live = batch_.live(), from](Progress& progress,
                                   std::stop_token stop) -> Result<review::LiveFit> {
        Result<review::LiveFit> fit =
            settledInSight(live, from.front, from.back, from.front_from_back, progress, stop);
        if (fit) fit->shift = from.shift;
        return fit;
      },
      Made::Settled, tr("refining the fit"));
}

void CardInHand::moveByHand(const Eigen::Vector3d& turn_rad, const Eigen::Vector3d& move_mm) {
  if (trial_.front < 0 || trial_.back < 0) return;
  Trial trial = trial_;
  trial.front_from_back =
      review::movedByHand(trial_.front_from_back, batch_.back(trial_.back), turn_rad, move_mm);
  trial.made = Made::ByHand;
  tryOut(trial, tr("turning by hand"), true);
}

void CardInHand::stopSettling() {
  if (fit_job_) fit_job_->cancel();
}

void CardInHand::fitAt(std::function<Result<review::LiveFit>(Progress&, std::stop_token)> work,
                       Made made, const QString& text) {
  if (!batch_.isOpen() || trial_.front < 0) return;
  dropJob(fit_job_);  // its result is not wanted any more
  busy_ = true;
  settling_rms_.clear();
  emit busyChanged(true);
  const Trial from = trial_;
  fit_job_ = runner_.start(makeJob(std::move(work)), this);
  connect(fit_job_, &JobHandle::told, this, [this, from](const std::any& value) {
    if (!isAbout(from.front, from.back)) return;
    const auto& fit = std::any_cast<const review::LiveFit&>(value);
    settling_rms_.push_back(fit.fracture_rms_mm);
    emit settlingAt(fit.front_from_back, settling_rms_);
  });
  whenDone<review::LiveFit>(fit_job_, this, [this, from, made, text](const auto& fit) {
    busy_ = false;
    emit busyChanged(false);
    if (!fit) emit trialChanged();  // back to where it was
    if (!fit && fit.error().code == ErrorCode::Cancelled)
      return emit failed(tr("Cancelled. The back stays where it was."));
    if (!fit) return emit failed(sentenceOf(fit.error()));
    if (!isAbout(from.front, from.back)) return;
    tryOut({from.front, from.back, fit->front_from_back, made, fit->shift}, text);
  });
}

void CardInHand::fetchModel() {
  if (!batch_.isOpen()) return;
  const int front = trial_.front, back = trial_.back;
  if (front < 0 || back < 0) {
    emit modelFetched(nullptr);
    return emit failed(front < 0 ? tr("A back alone has no closed model.")
                                 : tr("No back is chosen."));
  }
  dropJob(model_job_);
  model_job_ =
      runner_.start(makeJob([live = batch_.live(), front, back](Progress&, std::stop_token) {
                      return closedModel(live, front, back);
                    }),
                    this);
  whenDone<MeshPtr>(model_job_, this, [this, front, back](const auto& model) {
    if (!isAbout(front, back)) return;
    emit modelFetched(model ? *model : nullptr);
    if (!model)
      emit failed(tr("This pair has no closed model yet. Reprocess the batch to make it."));
  });
}

// One picture at a time; what changed meanwhile is fetched when it is there.
void CardInHand::fetchScene(Clouds clouds) {
  clouds_wanted_ = clouds_wanted_ || clouds == Clouds::Fetch;
  scene_wanted_ = true;
  if (scene_job_ || !batch_.isOpen() || row() < 0) return;
  const Trial trial = trial_;
  const Clouds with = clouds_wanted_ ? Clouds::Fetch : Clouds::Leave;
  scene_wanted_ = clouds_wanted_ = false;
  scene_job_ = runner_.start(
      makeJob([live = batch_.live(), trial, with](Progress&, std::stop_token) {
        if (trial.front < 0) return loneScene(live, batch::Side::Back, trial.back);
        return trial.back < 0
                   ? loneScene(live, batch::Side::Front, trial.front)
                   : pairScene(live, trial.front, trial.back, trial.front_from_back, with);
      }),
      this);
  whenDone<ScenePtr>(scene_job_, this, [this, trial](const auto& scene) {
    const bool current = isAbout(trial.front, trial.back);
    if (scene && current) {
      scene_ = *scene;
      fit_ = scene_->fit;
      emit sceneChanged(*scene);
    } else if (!scene && current) {
      emit failed(sentenceOf(scene.error()));
    }
    if (scene_wanted_ || clouds_wanted_) return fetchScene(Clouds::Leave);
    emit sceneFetched();
  });
}

}  // namespace ostraka::ui
