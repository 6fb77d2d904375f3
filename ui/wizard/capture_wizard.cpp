#include "ui/wizard/capture_wizard.h"

#include <algorithm>
#include <utility>

#include "batch/batch.h"
#include "capture/batch_store.h"
#include "ui/frame/project_session.h"
#include "ui/import/record_photographs.h"
#include "ui/wizard/batch_description.h"
#include "ui/wizard/plate_pictures.h"
#include "ui/wizard/rig_connection.h"
#include "ui/wizard/side_progress.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

using records::BatchState;

struct SideTaken {
  capture::SideSummary summary;
  std::optional<capture::SideCheck> front;  ///< when nobody knew it any more
};

// Hidden, touching another, in the hand still, broken, or a pebble: only a person knows.
// counted: by a person, 0: not; empty: no doubt.
QString countDoubt(const capture::SideCheck& check, int counted) {
  if (counted == 0 || !check.counted || check.sherds == counted) return {};
  const QString words =
      check.sherds < counted
          ? CaptureWizard::tr(
                "You counted %1 sherds, the photographs show %2: look for one that is hidden, "
                "touches another or was never laid down.")
          : CaptureWizard::tr(
                "You counted %1 sherds, the photographs show %2: check whether one is in "
                "fragments or an object is not a sherd, or correct the count.");
  return words.arg(counted).arg(check.sherds);
}

}  // namespace

CaptureWizard::CaptureWizard(QObject* parent)
    : QObject(parent),
      rig_(new RigConnection(this)),
      pictures_(new PlatePictures(rig_, &batch_, this)),
      side_(new SideProgress(this)),
      description_(new BatchDescription(&batch_, this)) {
  connect(rig_, &RigConnection::changed, this, &CaptureWizard::changed);
  connect(rig_, &RigConnection::waited, this, [this] {
    if (!isShooting()) stop();  // only what opens the devices is asked to end
  });
  connect(rig_, &RigConnection::taken, this, &CaptureWizard::followRig);
  connect(rig_, &RigConnection::opened, this, &CaptureWizard::resumeBatch);
  connect(rig_, &RigConnection::released, this, &CaptureWizard::next);  // what failed once more
  connect(rig_, &RigConnection::failed, this, [this](const Error& error) { fail(error, {}); });
  connect(pictures_, &PlatePictures::cameraChanged, this, &CaptureWizard::changed);
  connect(pictures_, &PlatePictures::liveTurnedOn, this,
          [this] { to_reshoot_ = batch_.toPhotographAgain(); });
  connect(pictures_, &PlatePictures::codesSeen, this, [this](const QStringList& codes) {
    if (phase_ == CapturePhase::Flip) return description_->compareLabels(codes);
    description_->readLabels(codes);
  });
  connect(pictures_, &PlatePictures::frontCounted, this, &CaptureWizard::takeFrontCount);
  connect(side_, &SideProgress::preparing, this, &CaptureWizard::changed);
  connect(description_, &BatchDescription::changed, this, &CaptureWizard::changed);
  connect(description_, &BatchDescription::countChanged, this, &CaptureWizard::followCount);
}

CaptureWizard::~CaptureWizard() = default;

void CaptureWizard::setSession(ProjectSession* session) {
  stop();
  if (session_ != nullptr) session_->disconnect(this);
  session_ = session;
  rig_->setSession(session);
  pictures_->setSession(session);
  description_->setSession(session);
  batch_.setSession(session);
  if (session_ != nullptr)
    connect(session_, &ProjectSession::batchChanged, this, &CaptureWizard::followBatch);
  forgetPlate();
  rig_->clear();
}

void CaptureWizard::followBatch(const QString& number) {
  if (phase_ == CapturePhase::Done && number == batch_.number()) emit changed();
  if (phase_ != CapturePhase::Place || batch_.isThere() || rig_->isBusy()) return;
  batch_.resume(number);  // one that was set aside is wanted again
  if (!batch_.isThere() && rig_->isFor(batch_.index())) return;
  description_->takePlaceOfBatch();
  rig_->close();
  openRig();
}

bool CaptureWizard::isShooting() const {
  return rig_->isBusy() &&
         (phase_ == CapturePhase::ShootFront || phase_ == CapturePhase::ShootBack);
}

void CaptureWizard::followRig() {
  if (rig_->source().open) {
    const QString before = batch_.number();
    batch_.resume();
    if (batch_.number() != before) forgetPlate();  // what was seen is another batch's
    description_->takePlaceOfBatch();
    return openRig();
  }
  batch_.forget();
  enter(CapturePhase::NoRig);
}

void CaptureWizard::openRig() {
  if (session_ == nullptr || !rig_->source().open) return;
  if (rig_->devices() != nullptr && !rig_->source().anew_for_each_batch)
    return enter(CapturePhase::Place);
  enter(CapturePhase::Opening);
  rig_->open(batch_.index());
}

void CaptureWizard::resumeBatch() {
  if (!batch_.isThere()) return enter(CapturePhase::Place);
  const BatchState state = batch_.state();
  // Whole, and only a person says that it is right where there were doubts.
  if (state == BatchState::Back) {
    if (doubts().isEmpty())  // what they were is not known any more
      doubts_.found << tr("%1 is photographed whole, but nobody said that it is right: look at its "
                          "photographs, then go on.")
                           .arg(batch_.number());
    return enter(CapturePhase::Done);
  }
  enter(state == BatchState::Placed ? CapturePhase::Place : CapturePhase::Flip);
  if (state == BatchState::Placed || state == BatchState::Flipped)
    goOnWithin(state == BatchState::Placed ? batch::Side::Front : batch::Side::Back);
  emit said(tr("%1 resumes where it stopped.").arg(batch_.number()));
}

bool CaptureWizard::canDescribe() const {
  return phase_ == CapturePhase::Place || phase_ == CapturePhase::Opening ||
         phase_ == CapturePhase::Flip || (phase_ == CapturePhase::Done && !queued_) ||
         (fault_ && !rig_->isBusy() && phase_ != CapturePhase::NoRig);  // stopped in a side
}

const std::optional<capture::SideSummary>& CaptureWizard::summary(batch::Side side) const {
  return summary_[side == batch::Side::Back ? 1 : 0];
}

void CaptureWizard::followCount() {
  // A slip in the count is mended while the plate still lies there.
  const auto& seen = summary_[phase_ == CapturePhase::Done ? 1 : 0];
  const bool told = seen && (phase_ == CapturePhase::Flip || phase_ == CapturePhase::Done);
  // Its own bag: a person may be typing another.
  if (batch_.isThere() && canDescribe()) keep(batch_.place());
  if (told) doubtCount(seen->check);
  emit changed();
}

void CaptureWizard::forgetPlate() {
  doubts_ = {};
  summary_ = {};
  queued_ = false;
  description_->forgetLabelsOfBacks();
  to_reshoot_ = batch_.toPhotographAgain();
  side_->forget();
  pictures_->forget();
}

void CaptureWizard::setPhase(CapturePhase phase) {
  phase_ = phase;
  pictures_->setPhase(phase);
  fault_.reset();
  rig_->forgetHolders();
}

void CaptureWizard::enter(CapturePhase phase) {
  setPhase(phase);
  if (phase == CapturePhase::Place) forgetPlate();
  if (phase == CapturePhase::Flip) pictures_->readFront(uncountedFronts());
  pictures_->preview();
  emit changed();
}

// What the back is compared with, when the program was closed since.
std::vector<std::vector<std::filesystem::path>> CaptureWizard::uncountedFronts() const {
  if (summary_[0]) return {};
  return batch_.files(batch::Side::Front, rig_->cameras());
}

bool CaptureWizard::canGoOn() const {
  if (!rig_->question().isEmpty()) return true;
  if (session_ == nullptr || rig_->isBusy()) return false;
  return fault_.has_value() || phase_ == CapturePhase::Place || phase_ == CapturePhase::Flip ||
         phase_ == CapturePhase::Done;
}

void CaptureWizard::next() {
  if (!canGoOn()) return;
  if (asksToRepeat()) return keepPhotographs();
  if (!rig_->question().isEmpty()) return rig_->answer();
  if (fault_ && !rig_->holders().isEmpty()) return rig_->release();
  if (fault_ && (phase_ == CapturePhase::Opening || phase_ == CapturePhase::NoRig)) {
    rig_->close();
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
  if (!rig_->isBusy()) return;
  if (rig_->devices() != nullptr && isShooting()) rig_->devices()->turntable->stopNow();
  rig_->cancel();
}

QStringList CaptureWizard::doubts() const {
  QStringList all = doubts_.found;
  if (!doubts_.count.isEmpty()) all << doubts_.count;
  const bool asks = phase_ == CapturePhase::Flip || (phase_ == CapturePhase::Done && !queued_);
  if (const QString other = description_->otherBag(); asks && !other.isEmpty())
    all << tr("The label beside the backs names %1, but the fronts are of %2: check that these are "
              "the same sherds, or correct the bag.")
               .arg(other, description_->place().words());
  if (doubts_.repeat)
    all << tr(
        "Nothing is wrong with the photographs of this side. Space or Esc keeps them; R once "
        "more puts all of them aside and takes new ones.");
  return all;
}

void CaptureWizard::keepPhotographs() {
  if (!asksToRepeat()) return;
  doubts_ = {};
  emit changed();
}

void CaptureWizard::again() {
  const bool back = phase_ == CapturePhase::Done;
  if ((!back && phase_ != CapturePhase::Flip) || rig_->isBusy()) return;
  const auto& summary = summary_[back ? 1 : 0];
  std::vector<capture::ShotName> retake;
  // Light, focus and settings are of single photographs; what is moved lies elsewhere at all stops.
  if (summary && !summary->cut_off &&
      doubts().size() <= static_cast<qsizetype>(summary->flagged.size()))
    retake = summary->flagged;
  // A label beside the backs says nothing against the fronts: other sherds lie there now, perhaps.
  const bool doubted = back
                           ? !doubts().isEmpty()
                           : doubts_.repeat || !doubts_.found.isEmpty() || !doubts_.count.isEmpty();
  if (retake.empty() && !doubted) {
    doubts_.repeat = true;
    return emit changed();
  }
  if (retake.empty())  // the whole side: something was moved or lost
    for (int stop = 0; stop < rig_->source().stops; ++stop)
      for (int camera = 0; camera < rig_->cameras(); ++camera) retake.push_back({stop, camera});
  shoot(back ? batch::Side::Back : batch::Side::Front, std::move(retake));
}

bool CaptureWizard::canSetAside() const {
  return batch_.isThere() && !rig_->isBusy() && canDescribe();
}

void CaptureWizard::setAside() {
  if (!canSetAside()) return;
  const QString number = batch_.number();
  batch_.forget();
  forgetPlate();
  rig_->close();
  openRig();
  emit batchSetAside(number);
}

// Numbers that are typed are of the bag's context.
void CaptureWizard::keepDescribed() {
  if (session_ == nullptr || !batch_.isThere() || !canDescribe()) return;
  keep(description_->place());
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
  if (const Result<void> begun = batch_.begin(description_->place()); !begun)
    return fail(begun.error(), {});
  if (!rig_->isFor(batch_.index())) return openRig();
  const CapturePhase phase =
      side == batch::Side::Front ? CapturePhase::ShootFront : CapturePhase::ShootBack;
  const bool goes_on = phase_ == phase && retake.empty();
  setPhase(phase);
  doubts_ = {};
  queued_ = false;  // what was queued are other photographs
  if (goes_on)
    side_->goOn();
  else
    side_->begin(std::move(retake));
  // Whoever opens the project next knows that this side is not whole.
  const BatchState begun_state =
      side == batch::Side::Back ? BatchState::Flipped : BatchState::Placed;
  if (batch_.state() != begun_state) setState(begun_state);
  emit changed();
  rig_->whenFree([this, side] { startShooting(side); });
}

void CaptureWizard::startShooting(batch::Side side) {
  capture::SideOptions options;
  options.batch = batch_.folder();
  options.side = side;
  options.stops = rig_->source().stops;
  options.retake = side_->retaking();
  std::vector<std::vector<std::filesystem::path>> uncounted;
  if (side == batch::Side::Back) uncounted = uncountedFronts();
  const auto work = [devices = rig_->devices(), source = rig_->source(), batch = batch_.index(),
                     options,
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
  JobHandle* job = rig_->work(makeJob(work), [this, side](const JobOutcome& outcome) {
    const Result<SideTaken> taken = outcomeAs<SideTaken>(outcome);
    if (taken && taken->front) takeFrontCount(*taken->front);
    finishSide(side, taken ? Result<capture::SideSummary>(taken->summary) : taken.error());
  });
  connect(job, &JobHandle::told, side_, &SideProgress::hear);
  emit changed();
}

void CaptureWizard::finishSide(batch::Side side, const Result<capture::SideSummary>& summary) {
  const bool back = side == batch::Side::Back;
  if (!summary) return fail(summary.error(), safeWords());
  summary_[back ? 1 : 0] = *summary;
  side_->end();
  setState(back ? BatchState::Back : BatchState::Front);
  enter(back ? CapturePhase::Done : CapturePhase::Flip);
  for (const capture::ShotName& shot : summary->flagged)
    doubts_.found << tr("Camera %1 at position %2: %3")
                         .arg(QString::fromStdString(batch::cameraLetter(shot.camera)))
                         .arg(shot.stop + 1)
                         .arg(side_->problemsOf(shot).join(QStringLiteral(", ")));
  doubts_.found << listOf(summary->check.sentences);
  doubtCount(summary->check);
  if (back && summary_[0])
    doubts_.found << listOf(capture::compareSides(summary_[0]->check, summary_[1]->check));
  if (back && doubts().isEmpty()) return queueBatch();
  emit changed();
}

void CaptureWizard::doubtCount(const capture::SideCheck& check) {
  doubts_.count = countDoubt(check, batch_.counted());
  if (!doubts_.count.isEmpty()) doubts_.repeat = false;
}

void CaptureWizard::queueBatch() {
  if (const Result<void> kept = batch_.begin(description_->place()); !kept)
    return fail(kept.error(), {});
  const int seen = summary_[0] ? summary_[0]->check.sherds : 0;
  if (const Result<void> queued = batch_.queue(seen); !queued) return fail(queued.error(), {});
  recordPhotographs(*session_, batch_.number(), "capture");
  queued_ = true;
  doubts_ = {};
  enter(CapturePhase::Done);
  emit batchQueued(batch_.number());
}

void CaptureWizard::takeFrontCount(const capture::SideCheck& check) {
  if (summary_[0]) return;
  summary_[0].emplace().check = check;
  summary_[0]->kept = static_cast<int>(batch_.photographs(batch::Side::Front).size());
  if (phase_ != CapturePhase::Flip) return;
  doubts_.found << listOf(check.sentences);
  doubtCount(check);
  emit changed();
}

void CaptureWizard::fail(const Error& error, const QString& safe) {
  Error shown = error;
  if (!safe.isEmpty()) shown.what = tr("%1 %2").arg(wordsOf(shown.what), safe).toStdString();
  fault_ = shown;
  rig_->forgetHolders();
  side_->standStill();
  emit changed();
  if (error.code == ErrorCode::Missing) rig_->findHolders();
}

// The window was closed in the middle of this side: it looks as if Esc had just stopped it.
void CaptureWizard::goOnWithin(batch::Side side) {
  if (!side_->resume(batch_.photographs(side), rig_->source().stops, rig_->cameras())) return;
  setPhase(side == batch::Side::Front ? CapturePhase::ShootFront : CapturePhase::ShootBack);
  fail(
      Error{ErrorCode::Cancelled,
            tr("%1 was interrupted in the middle of this side.").arg(batch_.number()).toStdString(),
            {}},
      safeWords());
}

QString CaptureWizard::safeWords() const {
  return side_->saved() == 0
             ? tr("No photograph of this side has been taken.")
             : tr("The %n photograph(s) of this side so far are saved.", nullptr, side_->saved());
}

}  // namespace ostraka::ui
