// What a person tries on the card in hand, and what is fetched to show it: jobs, one of a kind.
#include <algorithm>

#include "ui/review/pair_review_model.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

using review::ReviewCandidate;
using ScenePtr = std::shared_ptr<const PairScene>;

constexpr int kWantedCandidates = 3;

// Settles the back from a pose; whoever looks on sees it come.
Result<review::LiveFit> settledInSight(const LivePairsPtr& live, int front, int back,
                                       const Eigen::Isometry3d& from, Progress& progress,
                                       std::stop_token stop) {
  return live->settled(front, back, from, std::move(stop),
                       [&progress](const review::LiveFit& fit) { tell(progress, fit); });
}

}  // namespace

void PairReviewModel::stepStart(int by) {
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
      [live = live_, front, back, to](Progress& progress,
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

void PairReviewModel::stepSample(int by) {
  if (trial_.front < 0 || trial_.back < 0) return;
  const int front = trial_.front, back = trial_.back, to = std::max(0, trial_.shift) + by;
  fitAt([live = live_, front, back, to](
            Progress&, std::stop_token) { return live->atStartPoint(front, back, to); },
        Made::StartPoint, tr("start point"));
}

void PairReviewModel::settle() {
  if (trial_.front < 0 || trial_.back < 0) return;
  const Trial from = trial_;
  fitAt(
      [live = live_, from](Progress& progress, std::stop_token stop) -> Result<review::LiveFit> {
        Result<review::LiveFit> fit =
            settledInSight(live, from.front, from.back, from.front_from_back, progress, stop);
        if (fit) fit->shift = from.shift;
        return fit;
      },
      Made::Settled, tr("refining the fit"));
}

void PairReviewModel::moveByHand(const Eigen::Vector3d& turn_rad, const Eigen::Vector3d& move_mm) {
  if (trial_.front < 0 || trial_.back < 0) return;
  Trial trial = trial_;
  trial.front_from_back =
      review::movedByHand(trial_.front_from_back, backRef(trial_.back), turn_rad, move_mm);
  trial.made = Made::ByHand;
  tryOut(trial, tr("turning by hand"), true);
}

void PairReviewModel::stopSettling() {
  if (fit_job_) fit_job_->cancel();
}

void PairReviewModel::fitAt(std::function<Result<review::LiveFit>(Progress&, std::stop_token)> work,
                            Made made, const QString& text) {
  if (!live_ || trial_.front < 0) return;
  if (fit_job_) fit_job_->drop();  // its result is not wanted any more
  busy_ = true;
  settling_rms_.clear();
  emit busyChanged(true);
  const Trial from = trial_;
  fit_job_ = runner_.start(makeJob(text, std::move(work)), this);
  connect(fit_job_, &JobHandle::told, this, [this, from](const std::any& value) {
    if (from.front != trial_.front || from.back != trial_.back) return;
    const auto& fit = std::any_cast<const review::LiveFit&>(value);
    settling_rms_.push_back(fit.fracture_rms_mm);
    emit settlingAt(fit.front_from_back);
  });
  connect(fit_job_, &JobHandle::finished, this,
          [this, from, made, text](const JobOutcome& outcome) {
            busy_ = false;
            emit busyChanged(false);
            const auto fit = outcomeAs<review::LiveFit>(outcome);
            if (!fit) emit trialChanged();  // back to where it was
            if (!fit && fit.error().code == ErrorCode::Cancelled)
              return emit failed(tr("Cancelled. The back stays where it was."));
            if (!fit) return emit failed(sentenceOf(fit.error()));
            if (from.front != trial_.front || from.back != trial_.back) return;
            tryOut({from.front, from.back, fit->front_from_back, made, fit->shift}, text);
          });
}

void PairReviewModel::fetchModel() {
  if (!live_) return;
  const int front = trial_.front, back = trial_.back;
  if (front < 0 || back < 0) {
    emit modelFetched(nullptr);
    return emit failed(front < 0 ? tr("A back alone has no closed model.")
                                 : tr("No back is chosen."));
  }
  if (model_job_) model_job_->drop();
  model_job_ = runner_.start(makeJob(tr("Closed model"),
                                     [live = live_, front, back](Progress&, std::stop_token) {
                                       return closedModel(live, front, back);
                                     }),
                             this);
  connect(model_job_, &JobHandle::finished, this, [this, front, back](const JobOutcome& outcome) {
    const auto model = outcomeAs<MeshPtr>(outcome);
    if (front != trial_.front || back != trial_.back) return;
    emit modelFetched(model ? *model : nullptr);
    if (!model)
      emit failed(tr("This pair has no closed model yet. Reprocess the batch to make it."));
  });
}

// One picture at a time; what changed meanwhile is fetched when it is there.
void PairReviewModel::fetchScene(Clouds clouds) {
  clouds_wanted_ = clouds_wanted_ || clouds == Clouds::Fetch;
  scene_wanted_ = true;
  if (scene_job_ || !live_ || rowInHand() < 0) return;
  const Trial trial = trial_;
  const Clouds with = clouds_wanted_ ? Clouds::Fetch : Clouds::Leave;
  scene_wanted_ = clouds_wanted_ = false;
  scene_job_ = runner_.start(makeJob(tr("Picture of a pair"),
                                     [live = live_, trial, with](Progress&, std::stop_token) {
                                       if (trial.front < 0)
                                         return loneScene(live, batch::Side::Back, trial.back);
                                       return trial.back < 0
                                                  ? loneScene(live, batch::Side::Front, trial.front)
                                                  : pairScene(live, trial.front, trial.back,
                                                              trial.front_from_back, with);
                                     }),
                             this);
  connect(scene_job_, &JobHandle::finished, this, [this, trial](const JobOutcome& outcome) {
    scene_job_->deleteLater();
    scene_job_ = nullptr;
    const auto scene = outcomeAs<ScenePtr>(outcome);
    const bool current = trial.front == trial_.front && trial.back == trial_.back;
    if (scene && current) {
      fit_ = (*scene)->fit;
      emit sceneChanged(*scene);
    } else if (!scene && current) {
      emit failed(sentenceOf(scene.error()));
    }
    if (scene_wanted_ || clouds_wanted_) return fetchScene(Clouds::Leave);
    fetchMore();
  });
}

// One candidate a job, so that each is shown when it is there: for the front in hand, then for the
// others that want a person, in their order.
void PairReviewModel::fetchMore() {
  if (!live_ || more_job_) return;
  int front = wantsMore(trial_.front) ? trial_.front : -1;
  for (int i = 0; front < 0 && i < rowCount(); ++i)
    if (wantsMore(at(i).front)) front = at(i).front;
  if (front < 0) return;
  std::vector<int> known;
  for (const ReviewCandidate& c : candidatesOf(front)) known.push_back(c.back);
  more_job_ =
      runner_.start(makeJob(
                        tr("More candidates"),
                        [live = live_, front, known](Progress& progress, std::stop_token stop) {
                          return anotherCandidate(live, front, known, progress, stop);
                        },
                        JobPriority::Background),
                    this);
  connect(more_job_, &JobHandle::finished, this, [this, front](const JobOutcome& outcome) {
    more_job_->deleteLater();
    more_job_ = nullptr;
    const auto found = outcomeAs<std::optional<ReviewCandidate>>(outcome);
    if (found && *found)
      more_[front].push_back(**found);
    else
      asked_.insert(front);  // there is none; what is there stays
    if (front == trial_.front && found && *found) {
      takeCandidates();
      // Its next best, now that there is one.
      if (trial_.back < 0 && !busy_ && standing(*card()).back >= 0) select(front);
    }
    fetchMore();
  });
}

Trial PairReviewModel::standing(const review::ReviewCard& card) const {
  Trial trial;
  trial.front = card.front;
  const CardStory story = storyOf(card);
  if (card.back >= 0) {
    trial.back = card.back;
    trial.front_from_back = card.front_from_back;
    if (story.by_hand) trial.made = Made::ByHand;
  } else if (story.next && card.state == review::CardState::Alone) {
    trial.back = story.next->back;
    trial.front_from_back = story.next->front_from_back;
  }
  return trial;
}

CardStory PairReviewModel::storyOf(const review::ReviewCard& card) const {
  CardStory story;
  for (const decisions::PairDecision& d : decisions_)
    if (d.id == card.decision && d.kind == decisions::DecisionKind::Pair)
      story.by_hand = d.settle == decisions::Settle::AsGiven;
  const review::ReviewCard* own = program_.ofFront(card.front);
  const int lost = own == nullptr ? -1 : own->back;
  const review::ReviewCard* holder = review_.ofBack(lost);
  if (holder != nullptr && holder->front != card.front &&
      holder->state == review::CardState::Decided) {
    story.lost_back = lost;
    story.lost_to = holder->front;
  }
  const auto& free = review_.lone_backs;
  for (const ReviewCandidate& c : candidatesOf(card.front))
    if (!story.next && std::find(free.begin(), free.end(), c.back) != free.end()) story.next = c;
  return story;
}

bool PairReviewModel::wantsMore(int front) const {
  const review::ReviewCard* card = review_.ofFront(front);
  if (card == nullptr || asked_.contains(front)) return false;
  const bool doubtful =
      card->state == review::CardState::Ask || card->state == review::CardState::Alone;
  return (doubtful || front == trial_.front) &&
         static_cast<int>(candidatesOf(front).size()) < kWantedCandidates;
}

}  // namespace ostraka::ui
