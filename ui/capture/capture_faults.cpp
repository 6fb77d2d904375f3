// What the wizard does when a device fails, and how it helps.
#include "ui/capture/capture_wizard.h"
#include "ui/frame/project_session.h"

namespace ostraka::ui {

void CaptureWizard::fail(const Error& error, const QString& safe) {
  Error shown = error;
  if (!safe.isEmpty())
    shown.what = tr("%1 %2").arg(QString::fromStdString(shown.what), safe).toStdString();
  fault_ = shown;
  holders_.clear();
  stop_ = -1;
  emit changed();
  if (error.code == ErrorCode::Missing) askWhoHolds();
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
      tr("Making the desktop let go of the camera"),
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
