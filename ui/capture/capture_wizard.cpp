#include "ui/capture/capture_wizard.h"

#include <algorithm>
#include <utility>

#include "batch/batch.h"
#include "capture/batch_store.h"
#include "records/records.h"
#include "ui/capture/doubt_words.h"
#include "ui/frame/project_session.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

using records::BatchState;

struct SideTaken {
  capture::SideSummary summary;
  std::optional<capture::SideCheck> front;  ///< when nobody knew it any more
};

}  // namespace

CaptureWizard::CaptureWizard(QObject* parent) : QObject(parent) {
  live_timer_.setSingleShot(true);
  connect(&live_timer_, &QTimer::timeout, this, &CaptureWizard::lookLive);
  connect(&question_, &Question::asked, this, &CaptureWizard::changed);
  connect(&question_, &Question::settled, this, &CaptureWizard::changed);
}

CaptureWizard::~CaptureWizard() = default;

void CaptureWizard::setSession(ProjectSession* session) {
  stop();
  for (JobHandle* job : {work_.data(), live_job_.data(), front_job_.data()})
    if (job != nullptr) job->drop();
  work_ = live_job_ = front_job_ = nullptr;
  after_live_ = {};
  waiting_.reset();
  labels_.clear();
  if (session_ != nullptr) session_->disconnect(this);
  session_ = session;
  batch_.setSession(session);
  if (session_ != nullptr)
    connect(session_, &ProjectSession::batchChanged, this, [this](const QString& number) {
      if (phase_ == CapturePhase::Done && number == batch_.number()) emit changed();
      if (phase_ != CapturePhase::Place || batch_.isThere() || isBusy()) return;
      batch_.resume(number);  // one that was set aside is wanted again
      if (!batch_.isThere() && devicesAreForThis()) return;
      takePlace();
      devices_.reset();
      openRig();
    });
  live_.reset();
  forgetPlate();
  devices_.reset();
  clearRig();
  before_.reset();
}

bool CaptureWizard::isShooting() const {
  return isBusy() && (phase_ == CapturePhase::ShootFront || phase_ == CapturePhase::ShootBack);
}

void CaptureWizard::clearRig() {
  changeRig({});
}

void CaptureWizard::setRig(RigSource source) {
  changeRig(std::move(source));
}

// Whatever runs now goes on with the devices that it has; only what opens them is asked to end.
void CaptureWizard::changeRig(RigSource source) {
  if (isBusy()) {
    waiting_ = std::move(source);
    if (!isShooting()) stop();
    return;
  }
  if (devices_ != nullptr && source_.open) before_ = source_;
  source_ = std::move(source);
  devices_.reset();
  if (source_.open) {
    const QString before = batch_.number();
    batch_.resume();
    if (batch_.number() != before) forgetPlate();  // what was seen is another batch's
    takePlace();
    return openRig();
  }
  batch_.forget();
  enter(CapturePhase::NoRig);
}

void CaptureWizard::keepRig() {
  if (before_ && !isBusy()) changeRig(*std::exchange(before_, std::nullopt));
}

// Batches that were imported since took the number that the next one was going to have.
bool CaptureWizard::devicesAreForThis() const {
  return !source_.anew_for_each_batch || opened_for_ == batch_.index();
}

// What was typed last may be the bag of another batch.
void CaptureWizard::takePlace() {
  if (!batch_.isThere() || batch_.place() == place_) return;
  setPlace(batch_.place());
  emit placeRead();
}

bool CaptureWizard::takeWaitingRig() {
  if (!waiting_ || isBusy()) return false;
  changeRig(*std::exchange(waiting_, std::nullopt));
  return true;
}

JobHandle* CaptureWizard::start(Job job) {
  JobHandle* handle = session_->jobs().start(std::move(job), this);
  connect(handle, &JobHandle::finished, handle, &QObject::deleteLater);
  return handle;
}

void CaptureWizard::openRig() {
  if (session_ == nullptr || !source_.open) return;
  if (devices_ != nullptr && !source_.anew_for_each_batch) return enter(CapturePhase::Place);
  enter(CapturePhase::Opening);
  opened_for_ = batch_.index();
  whenCameraIsFree([this] {
    work_ = start(makeJob(tr("Opening the rig"),
                          [open = source_.open, ask = question_.asker(), batch = opened_for_](
                              Progress&, std::stop_token stop) { return open(batch, ask, stop); }));
    connect(work_, &JobHandle::finished, this, [this](const JobOutcome& outcome) {
      work_ = nullptr;
      if (!takeWaitingRig()) takeDevices(outcomeAs<std::shared_ptr<capture::RigDevices>>(outcome));
    });
  });
}

void CaptureWizard::takeDevices(const Result<std::shared_ptr<capture::RigDevices>>& opened) {
  if (!opened && before_) {
    emit rigTried(opened.error());
    return changeRig(*std::exchange(before_, std::nullopt));
  }
  if (!opened) return fail(opened.error(), {});
  devices_ = *opened;
  before_.reset();
  emit rigTried({});
  camera_ = std::clamp(camera_ < 0 ? cameras() - 1 : camera_, 0, cameras() - 1);
  if (!batch_.isThere()) return enter(CapturePhase::Place);
  const BatchState state = batch_.state();
  // Whole, and only a person says that it is right where there were doubts.
  if (state == BatchState::Back) {
    if (doubts_.isEmpty())  // what they were is not known any more
      doubts_ << tr("%1 is photographed whole, but nobody said that it is right: look at its "
                    "photographs, then go on.")
                     .arg(batch_.number());
    return enter(CapturePhase::Done);
  }
  enter(state == BatchState::Placed ? CapturePhase::Place : CapturePhase::Flip);
  if (state == BatchState::Placed || state == BatchState::Flipped)
    goOnWithin(state == BatchState::Placed ? batch::Side::Front : batch::Side::Back);
  emit said(tr("%1 resumes where it stopped.").arg(batch_.number()));
}

void CaptureWizard::setLive(bool on) {
  live_on_ = on;
  if (on) wanted_again_ = batch_.toPhotographAgain();
  if (on)
    lookLive();
  else
    live_timer_.stop();
}

int CaptureWizard::cameras() const {
  return devices_ == nullptr ? 0 : static_cast<int>(devices_->cameras.size());
}

void CaptureWizard::setCamera(int camera) {
  if (camera < 0 || camera >= cameras() || camera == camera_) return;
  camera_ = camera;
  live_missing_ = false;
  emit changed();
  lookLive();
}

void CaptureWizard::setPlace(const PlaceText& place) {
  if (place == place_) return;
  place_ = place;
  emit changed();
}

void CaptureWizard::setCounted(int sherds) {
  if (sherds == batch_.counted() || sherds < 0) return;
  // A slip in the count is mended while the plate still lies there.
  const auto& seen = summary_[phase_ == CapturePhase::Done ? 1 : 0];
  const bool told = seen && (phase_ == CapturePhase::Flip || phase_ == CapturePhase::Done);
  if (told) doubts_.removeAll(countDoubt(seen->check));
  batch_.setCounted(sherds);
  // Its own bag: a person may be typing another.
  if (batch_.isThere() && canDescribe()) keep(batch_.place());
  if (told) doubtCount(seen->check);
  emit changed();
}

bool CaptureWizard::canDescribe() const {
  return phase_ == CapturePhase::Place || phase_ == CapturePhase::Opening ||
         phase_ == CapturePhase::Flip || (phase_ == CapturePhase::Done && !queued_) ||
         (fault_ && !isBusy() && phase_ != CapturePhase::NoRig);  // stopped in a side
}

void CaptureWizard::forgetPlate() {
  doubts_.clear();
  shots_.clear();
  summary_[0].reset();
  summary_[1].reset();
  front_picture_.reset();
  live_.reset();  // of the plate before
  retaking_.clear();
  queued_ = false;
  stop_ = -1;
  stops_done_ = 0;
  wanted_again_ = batch_.toPhotographAgain();
  emit shotsChanged();
  emit liveChanged();
}

void CaptureWizard::enter(CapturePhase phase) {
  phase_ = phase;
  fault_.reset();
  holders_.clear();
  if (phase == CapturePhase::Place) forgetPlate();
  live_missing_ = false;
  if (phase == CapturePhase::Flip) lookAtFront();
  emit changed();
  lookLive();
}

bool CaptureWizard::canGoOn() const {
  if (!question().isEmpty()) return true;
  if (session_ == nullptr || isBusy()) return false;
  return fault_.has_value() || phase_ == CapturePhase::Place || phase_ == CapturePhase::Flip ||
         phase_ == CapturePhase::Done;
}

void CaptureWizard::next() {
  if (!canGoOn()) return;
  if (!question().isEmpty()) return question_.answer(true);
  if (fault_ && !holders_.isEmpty()) return releaseCameras();
  if (fault_ && (phase_ == CapturePhase::Opening || phase_ == CapturePhase::NoRig)) {
    devices_.reset();
    return openRig();
  }
  switch (phase_) {
    case CapturePhase::Place:
      return shoot(batch::Side::Front, {});
    case CapturePhase::ShootFront:
      return shoot(batch::Side::Front, {});  // after a fault
    case CapturePhase::Flip:
    case CapturePhase::ShootBack:
      return shoot(batch::Side::Back, {});
    case CapturePhase::Done:
      if (!queued_) return queueBatch();
      batch_.forget();
      return openRig();
    case CapturePhase::NoRig:
    case CapturePhase::Opening:
      return;
  }
}

void CaptureWizard::stop() {
  if (!isBusy()) return;
  if (devices_ != nullptr && isShooting()) devices_->turntable->stopNow();
  question_.answer(false);
  if (work_ != nullptr) return work_->cancel();
  after_live_ = {};  // it has not begun
  if (!takeWaitingRig()) fail(Error::cancelled(), {});
}

QString CaptureWizard::repeatQuestion() {
  return tr(
      "Nothing is wrong with the photographs of this side. Photograph again once more "
      "to put all of them aside and take new ones.");
}

void CaptureWizard::again() {
  const bool back = phase_ == CapturePhase::Done;
  if ((!back && phase_ != CapturePhase::Flip) || isBusy()) return;
  const auto& summary = summary_[back ? 1 : 0];
  std::vector<capture::ShotName> retake;
  // Light, focus and settings are of single photographs; what is moved lies elsewhere at all stops.
  if (summary && !summary->lies_wrongly &&
      doubts_.size() <= static_cast<qsizetype>(summary->flagged.size()))
    retake = summary->flagged;
  if (retake.empty() && doubts_.isEmpty()) {
    doubts_ << repeatQuestion();
    return emit changed();
  }
  if (retake.empty())  // the whole side: something was moved or lost
    for (int stop = 0; stop < stops(); ++stop)
      for (int camera = 0; camera < cameras(); ++camera) retake.push_back({stop, camera});
  shoot(back ? batch::Side::Back : batch::Side::Front, std::move(retake));
}

bool CaptureWizard::canSetAside() const {
  return batch_.isThere() && !isBusy() && canDescribe();
}

void CaptureWizard::setAside() {
  if (!canSetAside()) return;
  const QString number = batch_.number();
  batch_.forget();
  forgetPlate();
  devices_.reset();
  openRig();
  emit batchSetAside(number);
}

// Numbers that are typed are of the bag's context.
void CaptureWizard::keepDescribed() {
  if (session_ == nullptr || !batch_.isThere() || !canDescribe()) return;
  keep(place_);
  emit changed();
}

void CaptureWizard::takeNumbersAsRight() {
  batch_.takeNumbersAsRight();
  emit changed();
}

void CaptureWizard::keep(const PlaceText& place) {
  if (const Result<void> kept = batch_.begin(place); !kept) emit said(sentenceOf(kept.error()));
}

void CaptureWizard::setState(records::BatchState state) {
  if (const Result<void> set = batch_.setState(state); !set) emit said(sentenceOf(set.error()));
}

void CaptureWizard::shoot(batch::Side side, std::vector<capture::ShotName> retake) {
  if (!session_->isThere()) return fail(session_->goneError(), {});  // or a ghost of it is made
  if (const Result<void> begun = batch_.begin(place_); !begun) return fail(begun.error(), {});
  if (!devicesAreForThis()) return openRig();
  const CapturePhase phase =
      side == batch::Side::Front ? CapturePhase::ShootFront : CapturePhase::ShootBack;
  const bool goes_on = phase_ == phase && retake.empty();
  if (goes_on)
    retake = retaking_;  // some of them may not be put aside yet
  else
    retaking_ = retake;
  phase_ = phase;
  fault_.reset();
  holders_.clear();
  doubts_.clear();
  queued_ = false;  // what was queued are other photographs
  stop_ = -1;
  if (goes_on) {
    std::erase_if(shots_, [](const TakenShot& shot) { return shot.refused; });
  } else {
    shots_.clear();
    stops_done_ = 0;
  }
  // Whoever opens the project next knows that this side is not whole.
  const BatchState begun_state =
      side == batch::Side::Back ? BatchState::Flipped : BatchState::Placed;
  if (batch_.state() != begun_state) setState(begun_state);
  emit changed();
  emit shotsChanged();
  whenCameraIsFree([this, side, retake = std::move(retake)] { startShooting(side, retake); });
}

void CaptureWizard::startShooting(batch::Side side, std::vector<capture::ShotName> retake) {
  capture::SideOptions options;
  options.batch = batch_.folder();
  options.side = side;
  options.stops = source_.stops;
  options.retake = std::move(retake);
  // What the back is compared with, when the program was closed since.
  std::vector<std::vector<std::filesystem::path>> uncounted;
  if (side == batch::Side::Back && !summary_[0])
    uncounted = batch_.files(batch::Side::Front, cameras());
  const auto work = [devices = devices_, source = source_, batch = batch_.index(), options,
                     uncounted](Progress& progress, std::stop_token stop) -> Result<SideTaken> {
    if (const Result<void> same = capture::checkPlate(options.batch, devices->plate); !same)
      return same.error();
    if (options.side == batch::Side::Front)
      if (const Result<void> done = source.prepare(options.batch, batch, progress, stop); !done)
        return done.error();
    if (devices->side_placed) devices->side_placed(options.side);
    Result<capture::SideSummary> summary = source.shoot(
        *devices, options,
        [&progress](const capture::CaptureEvent& event) { tell(progress, event); }, progress, stop);
    if (!summary) return summary.error();
    SideTaken taken{std::move(*summary), {}};
    if (!uncounted.empty()) taken.front = source.check(uncounted, devices->plate, {}, stop);
    return taken;
  };
  prepared_ = {};
  work_ = start(makeJob(tr("Photographs of %1").arg(batch_.number()), work));
  connect(work_, &JobHandle::told, this, [this](const std::any& event) {
    if (const auto* photographs = std::any_cast<PreparedPhotographs>(&event)) {
      prepared_ = *photographs;
      return emit changed();
    }
    if (std::exchange(prepared_, {}).total > 0) emit changed();  // the headline, too
    hear(std::any_cast<const capture::CaptureEvent&>(event));
  });
  connect(work_, &JobHandle::finished, this, [this, side](const JobOutcome& outcome) {
    work_ = nullptr;
    const Result<SideTaken> taken = outcomeAs<SideTaken>(outcome);
    if (taken && taken->front) takeFrontCount(*taken->front);
    finishSide(side, taken ? Result<capture::SideSummary>(taken->summary) : taken.error());
    takeWaitingRig();
  });
  emit changed();
}

void CaptureWizard::hear(const capture::CaptureEvent& event) {
  using Kind = capture::CaptureEventKind;
  if (event.stop >= 0) stop_ = event.stop;
  if (event.kind == Kind::StopDone) stops_done_ = std::max(stops_done_, event.stop + 1);
  if (event.kind == Kind::ShotKept || event.kind == Kind::ShotRefused) {
    TakenShot shot{event.stop,
                   event.camera,
                   event.take,
                   QString::fromStdString(event.file.string()),
                   doubtsOf(event.check),
                   event.kind == Kind::ShotRefused};
    if (shot.refused && !event.trouble.empty()) shot.problems << wordsOf(event.trouble);
    std::erase_if(shots_, [&](const TakenShot& old) {
      return old.stop == shot.stop && old.camera == shot.camera;
    });
    shots_.push_back(std::move(shot));
    if (event.kind == Kind::ShotKept)
      std::erase(retaking_, capture::ShotName{event.stop, event.camera});
  }
  if (event.kind == Kind::Trouble) emit said(wordsOf(event.trouble));
  if (event.kind == Kind::PressShutter)
    emit said(tr("Press the shutter of camera %1.")
                  .arg(QString::fromStdString(batch::cameraLetter(event.camera))));
  emit shotsChanged();
}

void CaptureWizard::finishSide(batch::Side side, const Result<capture::SideSummary>& summary) {
  const bool back = side == batch::Side::Back;
  if (!summary) return fail(summary.error(), safeWords());
  summary_[back ? 1 : 0] = *summary;
  retaking_.clear();
  setState(back ? BatchState::Back : BatchState::Front);
  enter(back ? CapturePhase::Done : CapturePhase::Flip);
  for (const capture::ShotName& shot : summary->flagged) {
    const auto at = std::find_if(shots_.begin(), shots_.end(), [&](const TakenShot& taken) {
      return taken.stop == shot.stop && taken.camera == shot.camera;
    });
    const QString why = at == shots_.end() ? QString() : at->problems.join(QStringLiteral(", "));
    doubts_ << tr("Camera %1 at position %2: %3")
                   .arg(QString::fromStdString(batch::cameraLetter(shot.camera)))
                   .arg(shot.stop + 1)
                   .arg(why);
  }
  doubts_ << doubtsOf(summary->check);
  doubtCount(summary->check);
  if (back && summary_[0]) doubts_ << doubtsBetween(summary_[0]->check, summary_[1]->check);
  if (back && doubts_.isEmpty()) return queueBatch();
  emit changed();
}

// Hidden, touching another, in the hand still, broken, or a pebble: only a person knows.
QString CaptureWizard::countDoubt(const capture::SideCheck& check) const {
  const int counted = batch_.counted();
  if (counted == 0 || !check.counted || check.sherds == counted) return {};
  const QString words =
      check.sherds < counted
          ? tr("You counted %1 sherds, the photographs show %2: look for one that hides, touches "
               "another or was never laid down.")
          : tr("You counted %1 sherds, the photographs show %2: look whether one lies there in "
               "parts, or a thing that is no sherd, or mend the count.");
  return words.arg(counted).arg(check.sherds);
}

void CaptureWizard::doubtCount(const capture::SideCheck& check) {
  if (const QString doubt = countDoubt(check); !doubt.isEmpty()) doubts_ << doubt;
}

void CaptureWizard::queueBatch() {
  if (const Result<void> kept = batch_.begin(place_); !kept) return fail(kept.error(), {});
  const int seen = summary_[0] ? summary_[0]->check.sherds : 0;
  if (const Result<void> queued = batch_.queue(seen); !queued) return fail(queued.error(), {});
  queued_ = true;
  doubts_.clear();
  enter(CapturePhase::Done);
  emit batchQueued(batch_.number());
}

}  // namespace ostraka::ui
