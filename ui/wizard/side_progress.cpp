#include "ui/wizard/side_progress.h"

#include <algorithm>
#include <utility>

#include "batch/batch.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {

int SideProgress::saved() const {
  return static_cast<int>(std::count_if(shots_.begin(), shots_.end(),
                                        [](const TakenShot& shot) { return !shot.refused; }));
}

QStringList SideProgress::problemsOf(const capture::ShotName& shot) const {
  const auto at = std::find_if(shots_.begin(), shots_.end(), [&](const TakenShot& taken) {
    return taken.stop == shot.stop && taken.camera == shot.camera;
  });
  return at == shots_.end() ? QStringList() : at->problems;
}

void SideProgress::forget() {
  shots_.clear();
  retaking_.clear();
  stop_ = -1;
  stops_done_ = 0;
  emit changed();
}

void SideProgress::begin(std::vector<capture::ShotName> retake) {
  retaking_ = std::move(retake);
  shots_.clear();
  stops_done_ = 0;
  stop_ = -1;
  prepared_ = {};
  emit changed();
}

// Some of those that were asked for again may not be put aside yet.
void SideProgress::goOn() {
  std::erase_if(shots_, [](const TakenShot& shot) { return shot.refused; });
  stop_ = -1;
  prepared_ = {};
  emit changed();
}

bool SideProgress::resume(std::vector<TakenShot> shots, int stops, int cameras) {
  shots_ = std::move(shots);
  if (shots_.empty()) return false;
  for (stops_done_ = 0; stops_done_ < stops; ++stops_done_)
    if (std::count_if(shots_.begin(), shots_.end(),
                      [this](const TakenShot& shot) { return shot.stop == stops_done_; }) < cameras)
      break;
  emit changed();
  return true;
}

void SideProgress::hear(const std::any& told) {
  if (const auto* photographs = std::any_cast<PreparedPhotographs>(&told)) {
    prepared_ = *photographs;
    return emit preparing();
  }
  if (std::exchange(prepared_, {}).total > 0) emit preparing();  // the headline, too
  follow(std::any_cast<const capture::CaptureEvent&>(told));
}

void SideProgress::follow(const capture::CaptureEvent& event) {
  using Kind = capture::CaptureEventKind;
  if (event.stop >= 0) stop_ = event.stop;
  if (event.kind == Kind::StopDone) stops_done_ = std::max(stops_done_, event.stop + 1);
  if (event.kind == Kind::ShotKept || event.kind == Kind::ShotRefused) keep(event);
  if (event.kind == Kind::Trouble) emit said(wordsOf(event.trouble));
  if (event.kind == Kind::PressShutter)
    emit said(CaptureWizard::tr("Press the shutter of camera %1.")
                  .arg(QString::fromStdString(batch::cameraLetter(event.camera))));
  emit changed();
}

void SideProgress::keep(const capture::CaptureEvent& event) {
  TakenShot shot{event.stop,
                 event.camera,
                 event.take,
                 QString::fromStdString(event.file.string()),
                 listOf(event.check.sentences()),
                 event.kind == capture::CaptureEventKind::ShotRefused};
  if (shot.refused && !event.trouble.empty()) shot.problems << wordsOf(event.trouble);
  if (!shot.refused) std::erase(retaking_, capture::ShotName{event.stop, event.camera});
  std::erase_if(shots_, [&](const TakenShot& old) {
    return old.stop == shot.stop && old.camera == shot.camera;
  });
  shots_.push_back(std::move(shot));
}

}  // namespace ostraka::ui
