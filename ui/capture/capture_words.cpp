// What the wizard says in each phase.
#include "ui/capture/capture_wizard.h"
#include "ui/frame/project_session.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kMostNamed = 4;

}  // namespace

QString CaptureWizard::headline() const {
  if (!question().isEmpty()) return question();
  switch (phase_) {
    case CapturePhase::NoRig:
      return tr("No rig yet");
    case CapturePhase::Opening:
      return fault_ ? tr("The rig does not open") : tr("Opening the rig");
    case CapturePhase::Place:
      return tr("Lay the sherds on the plate");
    case CapturePhase::ShootFront:
      return !isBusy()             ? tr("Stopped")
             : prepared_.total > 0 ? tr("Taking calibration photographs")
                                   : tr("Photographing the fronts");
    case CapturePhase::Flip:
      return source_.turns_sherds ? tr("The virtual rig turns the sherds over")
                                  : tr("Turn each sherd over where it lies");
    case CapturePhase::ShootBack:
      return !isBusy() ? tr("Stopped") : tr("Photographing the backs");
    case CapturePhase::Done:
      return doubts_.isEmpty() ? tr("You may clear the plate.")
                               : tr("Check the plate before you clear it");
  }
  return {};
}

QString CaptureWizard::instruction() const {
  switch (phase_) {
    case CapturePhase::Place:
      return tr("Fronts up, a finger's width apart, the markers at the edge of the plate free.");
    case CapturePhase::ShootFront:
    case CapturePhase::ShootBack:
      return isBusy() ? tr("Hands off the turntable. Esc stops it at once.")
                      : tr("The turntable stands still. Saved photographs are kept.");
    case CapturePhase::Flip:
      return source_.turns_sherds ? tr("Nothing to do by hand: shoot the backs.")
                                  : tr("Shifting is fine, swapping is fine, losing one is not.");
    case CapturePhase::Done:
      return queued_
                 ? tr("%1 is in the queue; the next batch is one key away.").arg(batch_.number())
                 : tr("Space accepts anyway, R photographs the backs again.");
    case CapturePhase::NoRig:
    case CapturePhase::Opening:
      break;
  }
  return {};
}

QString CaptureWizard::buttonText() const {
  if (!question().isEmpty()) return tr("Done");
  if (fault_ && isBusy()) return tr("One moment");
  if (fault_ && !holders_.isEmpty()) return tr("Release camera");
  const bool shooting = phase_ == CapturePhase::ShootFront || phase_ == CapturePhase::ShootBack;
  if (fault_ && shooting && !shots_.empty())
    return tr("Resume at position %1").arg(qMin(stops_done_ + 1, stops()));
  if (fault_) return tr("Try again");
  switch (phase_) {
    case CapturePhase::Place:
      return tr("Shoot the fronts");
    case CapturePhase::Flip:
      return source_.turns_sherds ? tr("Shoot the backs") : tr("All turned: shoot the backs");
    case CapturePhase::Done:
      return queued_ ? tr("Next batch") : tr("Accept and queue");
    case CapturePhase::ShootFront:
    case CapturePhase::ShootBack:
      return prepared_.total > 0 ? tr("Calibration photograph %1 of %2")
                                       .arg(qMin(prepared_.done + 1, prepared_.total))
                                       .arg(prepared_.total)
                                 : tr("Position %1 of %2").arg(qMax(stop_, 0) + 1).arg(stops());
    case CapturePhase::Opening:
      return tr("Opening the rig…");
    case CapturePhase::NoRig:
      break;
  }
  return tr("One moment");
}

std::vector<CaptureFact> CaptureWizard::facts() const {
  std::vector<CaptureFact> facts;
  const auto remind = [&] {
    if (phase_ != CapturePhase::Place || wanted_again_.isEmpty()) return;
    QStringList shown = wanted_again_.mid(0, kMostNamed);
    if (shown.size() < wanted_again_.size()) shown << QStringLiteral("…");
    facts.push_back({true, tr("To be photographed again: %1. Lay them down with others, and type "
                              "their numbers (N) when the fronts are shot.")
                               .arg(shown.join(QStringLiteral(", ")))});
  };
  if (phase_ == CapturePhase::Flip && (summary_[0] || front_picture_)) {
    // After a start the fronts are known by their picture only.
    const int front = summary_[0] ? summary_[0]->check.sherds
                                  : static_cast<int>(front_picture_->inspection.sherds.size());
    const int now = live_ ? static_cast<int>(live_->inspection.sherds.size()) : -1;
    facts.push_back({now < 0 || now == front,
                     now < 0 ? tr("Front: %n sherd(s)", nullptr, front)
                             : tr("Front: %1 sherds, now %2 are seen").arg(front).arg(now)});
    if (batch_.counted() > 0 && batch_.counted() != front)
      facts.push_back({false, tr("You counted %1").arg(batch_.counted())});
  }
  if (phase_ == CapturePhase::Done && summary_[0] && summary_[1]) {
    const int front = summary_[0]->check.sherds, back = summary_[1]->check.sherds;
    facts.push_back({front == back, tr("Front %1, back %2").arg(front).arg(back)});
    facts.push_back(
        {true, tr("%n photograph(s) saved", nullptr, summary_[0]->kept + summary_[1]->kept)});
    if (queued_ && batch_.isComputed())
      facts.push_back(
          {true,
           tr("Its sherds are in the review (Ctrl+3): check them while they still lie here")});
    return facts;
  }
  if (!live_ || (phase_ != CapturePhase::Place && phase_ != CapturePhase::Flip)) {
    if (live_missing_) facts.push_back({true, tr("This camera has no live view.")});
    remind();
    return facts;
  }
  const capture::PlateInspection& inspection = live_->inspection;
  if (phase_ == CapturePhase::Place)
    facts.push_back({!inspection.sherds.empty() && inspection.too_close.empty(),
                     tr("%n sherd(s) seen", nullptr, static_cast<int>(inspection.sherds.size()))});
  if (phase_ == CapturePhase::Place && batch_.counted() > 0)
    facts.push_back({static_cast<int>(inspection.sherds.size()) == batch_.counted(),
                     tr("You counted %1").arg(batch_.counted())});
  if (phase_ == CapturePhase::Place && inspection.pixel_from_plate)
    facts.push_back({true, live_->room.places.empty()
                               ? tr("No room for more")
                               : tr("Room for about %n more", nullptr,
                                    static_cast<int>(live_->room.places.size()))});
  for (const auto& [a, b] : inspection.too_close)
    facts.push_back({false, a == b ? tr("%1 may be two sherds, too close together").arg(a + 1)
                                   : tr("%1 and %2 lie too close together").arg(a + 1).arg(b + 1)});
  for (std::size_t i = 0; i < inspection.sherds.size(); ++i)
    if (inspection.sherds[i].cut_off)
      facts.push_back({false, tr("%1 reaches out of the picture").arg(i + 1)});
  const int needed = capture::markersNeeded(inspection.markers_on_plate);
  facts.push_back(
      {inspection.markers_seen >= needed,
       inspection.markers_seen >= needed
           ? tr("Markers %1 of %2").arg(inspection.markers_seen).arg(inspection.markers_on_plate)
           : tr("Markers %1 of %2, %3 needed")
                 .arg(inspection.markers_seen)
                 .arg(inspection.markers_on_plate)
                 .arg(needed)});
  if (inspection.dark_share > 0.02)
    facts.push_back(
        {false, tr("%1 % of the sherds is too dark").arg(qRound(100 * inspection.dark_share))});
  if (inspection.bright_share > 0.02)
    facts.push_back(
        {false, tr("%1 % of the sherds is too bright").arg(qRound(100 * inspection.bright_share))});
  if (inspection.dark_share <= 0.02 && inspection.bright_share <= 0.02 &&
      !inspection.sherds.empty())
    facts.push_back({true, tr("Lighting OK")});
  remind();
  return facts;
}

}  // namespace ostraka::ui
