// What the wizard does when a device fails, and how it helps.
#include <algorithm>

#include "ui/capture/capture_wizard.h"
#include "ui/frame/project_session.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

void CaptureWizard::fail(const Error& error, const QString& safe) {
  Error shown = error;
  if (!safe.isEmpty()) shown.what = tr("%1 %2").arg(wordsOf(shown.what), safe).toStdString();
  fault_ = shown;
  holders_.clear();
  stop_ = -1;
  emit changed();
  if (error.code == ErrorCode::Missing) askWhoHolds();
}

// The window was closed in the middle of this side: it looks as if Esc had just stopped it.
void CaptureWizard::goOnWithin(batch::Side side) {
  shots_ = batch_.photographs(side);
  if (shots_.empty()) return;
  phase_ = side == batch::Side::Front ? CapturePhase::ShootFront : CapturePhase::ShootBack;
  for (stops_done_ = 0; stops_done_ < stops(); ++stops_done_)
    if (std::count_if(shots_.begin(), shots_.end(), [this](const TakenShot& shot) {
          return shot.stop == stops_done_;
        }) < cameras())
      break;
  fail(
      Error{ErrorCode::Cancelled,
            tr("%1 was interrupted in the middle of this side.").arg(batch_.number()).toStdString(),
            {}},
      safeWords());
  emit shotsChanged();
}

QString CaptureWizard::safeWords() const {
  const auto safe = static_cast<int>(std::count_if(
      shots_.begin(), shots_.end(), [](const TakenShot& shot) { return !shot.refused; }));
  return tr("The %n photograph(s) of this side so far are saved.", nullptr, safe);
}

// Desktops open cameras as soon as they are plugged in; then the one button is to release them.
void CaptureWizard::askWhoHolds() {
  if (session_ == nullptr || !source_.holders) return;
  JobHandle* job = start(makeJob(tr("Looking for what holds the camera"),
                                 [holders = source_.holders](Progress&, std::stop_token)
                                     -> Result<std::vector<std::string>> { return holders(); }));
  connect(job, &JobHandle::finished, this, [this](const JobOutcome& outcome) {
    const auto found = outcomeAs<std::vector<std::string>>(outcome);
    if (!found || found->empty() || !fault_ || isBusy()) return;
    holders_.clear();
    for (const std::string& holder : *found) holders_ << QString::fromStdString(holder);
    emit changed();
  });
}

void CaptureWizard::releaseCameras() {
  holders_.clear();
  work_ = start(makeJob(
      tr("Releasing the camera from the desktop"),
      [release = source_.release](Progress&, std::stop_token stop) { return release(stop); }));
  connect(work_, &JobHandle::finished, this, [this](const JobOutcome& outcome) {
    work_ = nullptr;
    if (takeWaitingRig()) return;
    if (const Result<void> released = outcomeAs<void>(outcome); !released)
      return fail(released.error(), {});
    next();  // what failed is tried again
  });
  emit changed();
}

}  // namespace ostraka::ui
