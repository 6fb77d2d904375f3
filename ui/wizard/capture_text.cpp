#include "ui/wizard/capture_text.h"

#include "ui/wizard/batch_in_hand.h"
#include "ui/wizard/capture_wizard.h"
#include "ui/wizard/plate_pictures.h"
#include "ui/wizard/rig_connection.h"
#include "ui/wizard/side_progress.h"

namespace ostraka::ui {
namespace {

constexpr int kMostNamed = 4;

}  // namespace

CaptureText::CaptureText(const CaptureWizard& wizard)
    : wizard_(wizard),
      rig_(*wizard.rig()),
      side_(*wizard.side()),
      pictures_(*wizard.pictures()),
      batch_(wizard.batch()) {}

QString CaptureText::headline() const {
  if (rig_.isStopping()) return CaptureWizard::tr("Stopping…");
  if (!rig_.question().isEmpty()) return rig_.question();
  switch (wizard_.phase()) {
    case CapturePhase::NoRig:
      return CaptureWizard::tr("No rig yet");
    case CapturePhase::Opening:
      return wizard_.fault() ? CaptureWizard::tr("The rig does not open")
                             : CaptureWizard::tr("Opening the rig");
    case CapturePhase::Place:
      return CaptureWizard::tr("Lay the sherds on the plate");
    case CapturePhase::ShootFront:
      return !rig_.isBusy()               ? CaptureWizard::tr("Stopped")
             : side_.prepared().total > 0 ? CaptureWizard::tr("Taking calibration photographs")
                                          : CaptureWizard::tr("Photographing the fronts");
    case CapturePhase::Flip:
      return rig_.source().turns_sherds ? CaptureWizard::tr("The virtual rig turns the sherds over")
                                        : CaptureWizard::tr("Turn each sherd over where it lies");
    case CapturePhase::ShootBack:
      return !rig_.isBusy() ? CaptureWizard::tr("Stopped")
                            : CaptureWizard::tr("Photographing the backs");
    case CapturePhase::Done:
      return wizard_.doubts().isEmpty() ? CaptureWizard::tr("You may clear the plate.")
                                        : CaptureWizard::tr("Check the plate before you clear it");
  }
  return {};
}

QString CaptureText::instruction() const {
  switch (wizard_.phase()) {
    case CapturePhase::Place:
      return CaptureWizard::tr(
          "Fronts up, two centimetres apart, the markers at the edge of the plate free.");
    case CapturePhase::ShootFront:
    case CapturePhase::ShootBack:
      return rig_.isBusy()
                 ? CaptureWizard::tr("Hands off the turntable. Esc stops it at once.")
                 : CaptureWizard::tr("The turntable stands still. Saved photographs are kept.");
    case CapturePhase::Flip:
      return rig_.source().turns_sherds
                 ? CaptureWizard::tr("Nothing to do by hand: shoot the backs.")
                 : CaptureWizard::tr("Shifting is fine, swapping is fine, losing one is not.");
    case CapturePhase::Done:
      if (wizard_.isQueued() && batch_.isComputed())
        return CaptureWizard::tr("%1 is processed; the next batch is one key away.")
            .arg(batch_.number());
      return wizard_.isQueued()
                 ? CaptureWizard::tr("%1 is in the queue; the next batch is one key away.")
                       .arg(batch_.number())
                 : CaptureWizard::tr("Space accepts anyway, R photographs the backs again.");
    case CapturePhase::NoRig:
    case CapturePhase::Opening:
      break;
  }
  return {};
}

QString CaptureText::button() const {
  const CapturePhase phase = wizard_.phase();
  if (wizard_.asksToRepeat()) return CaptureWizard::tr("Keep the photographs");
  if (!rig_.question().isEmpty()) return CaptureWizard::tr("Done");
  if (wizard_.fault() && rig_.isBusy()) return CaptureWizard::tr("One moment");
  if (wizard_.fault() && !rig_.holders().isEmpty()) return CaptureWizard::tr("Release camera");
  const bool shooting = phase == CapturePhase::ShootFront || phase == CapturePhase::ShootBack;
  if (wizard_.fault() && shooting && !side_.shots().empty())
    return CaptureWizard::tr("Resume at position %1")
        .arg(qMin(side_.stopsDone() + 1, rig_.source().stops));
  if (wizard_.fault()) return CaptureWizard::tr("Try again");
  switch (phase) {
    case CapturePhase::Place:
      return CaptureWizard::tr("Shoot the fronts");
    case CapturePhase::Flip:
      return rig_.source().turns_sherds ? CaptureWizard::tr("Shoot the backs")
                                        : CaptureWizard::tr("All turned: shoot the backs");
    case CapturePhase::Done:
      return wizard_.isQueued() ? CaptureWizard::tr("Next batch")
                                : CaptureWizard::tr("Accept and queue");
    case CapturePhase::ShootFront:
    case CapturePhase::ShootBack:
      return side_.prepared().total > 0
                 ? CaptureWizard::tr("Calibration photograph %1 of %2")
                       .arg(qMin(side_.prepared().done + 1, side_.prepared().total))
                       .arg(side_.prepared().total)
                 : CaptureWizard::tr("Position %1 of %2")
                       .arg(qMax(side_.currentStop(), 0) + 1)
                       .arg(rig_.source().stops);
    case CapturePhase::Opening:
      return CaptureWizard::tr("Opening the rig…");
    case CapturePhase::NoRig:
      break;
  }
  return CaptureWizard::tr("One moment");
}

std::vector<CaptureFact> CaptureText::facts() const {
  const CapturePhase phase = wizard_.phase();
  const auto &front = wizard_.summary(batch::Side::Front),
             &back = wizard_.summary(batch::Side::Back);
  std::vector<CaptureFact> facts;
  if (phase == CapturePhase::Flip && (front || pictures_.front())) addFlip(facts);
  if (phase == CapturePhase::Done && front && back) {
    addDone(front->check.sherds, back->check.sherds, front->kept + back->kept, facts);
    return facts;
  }
  if (pictures_.live() && (phase == CapturePhase::Place || phase == CapturePhase::Flip))
    addLive(facts);
  else if (pictures_.isLiveMissing())
    facts.push_back({true, CaptureWizard::tr("This camera has no live view.")});
  if (phase == CapturePhase::Place) addSherdsToReshoot(facts);
  return facts;
}

void CaptureText::addSherdsToReshoot(std::vector<CaptureFact>& facts) const {
  const QStringList& again = wizard_.sherdsToReshoot();
  if (again.isEmpty()) return;
  QStringList shown = again.mid(0, kMostNamed);
  if (shown.size() < again.size()) shown << QStringLiteral("…");
  facts.push_back(
      {true, CaptureWizard::tr("To be photographed again: %1. Lay them down with others, and type "
                               "their numbers (N) when the fronts are shot.")
                 .arg(shown.join(QStringLiteral(", ")))});
}

void CaptureText::addFlip(std::vector<CaptureFact>& facts) const {
  const auto& summary = wizard_.summary(batch::Side::Front);
  // After a start the fronts are known by their picture only.
  const int front = summary ? summary->check.sherds
                            : static_cast<int>(pictures_.front()->inspection.sherds.size());
  const auto& live = pictures_.live();
  const int now = live ? static_cast<int>(live->inspection.sherds.size()) : -1;
  facts.push_back(
      {now < 0 || now == front,
       now < 0 ? CaptureWizard::tr("Front: %n sherd(s)", nullptr, front)
               : CaptureWizard::tr("Front: %1 sherds, now %2 are seen").arg(front).arg(now)});
  if (batch_.counted() > 0 && batch_.counted() != front)
    facts.push_back({false, CaptureWizard::tr("You counted %1").arg(batch_.counted())});
}

void CaptureText::addDone(int front, int back, int photographs,
                          std::vector<CaptureFact>& facts) const {
  facts.push_back({front == back, CaptureWizard::tr("Front %1, back %2").arg(front).arg(back)});
  facts.push_back({true, CaptureWizard::tr("%n photograph(s) saved", nullptr, photographs)});
  if (wizard_.isQueued() && batch_.isComputed())
    facts.push_back(
        {true, CaptureWizard::tr(
                   "Its sherds are in the review (Ctrl+3): check them while they still lie here")});
}

void CaptureText::addLive(std::vector<CaptureFact>& facts) const {
  const bool placing = wizard_.phase() == CapturePhase::Place;
  const PlatePicture& live = *pictures_.live();
  const capture::PlateInspection& inspection = live.inspection;
  if (placing)
    facts.push_back({!inspection.sherds.empty() && inspection.too_close.empty(),
                     CaptureWizard::tr("%n sherd(s) seen", nullptr,
                                       static_cast<int>(inspection.sherds.size()))});
  if (placing && batch_.counted() > 0)
    facts.push_back({static_cast<int>(inspection.sherds.size()) == batch_.counted(),
                     CaptureWizard::tr("You counted %1").arg(batch_.counted())});
  if (placing && inspection.pixel_from_plate)
    facts.push_back({true, live.room.places.empty()
                               ? CaptureWizard::tr("No room for more")
                               : CaptureWizard::tr("Room for about %n more", nullptr,
                                                   static_cast<int>(live.room.places.size()))});
  for (const auto& [a, b] : inspection.too_close)
    facts.push_back(
        {false, a == b
                    ? CaptureWizard::tr("%1 may be two sherds, too close together").arg(a + 1)
                    : CaptureWizard::tr("%1 and %2 lie too close together").arg(a + 1).arg(b + 1)});
  for (std::size_t i = 0; i < inspection.sherds.size(); ++i)
    if (inspection.sherds[i].cut_off)
      facts.push_back({false, CaptureWizard::tr("%1 reaches out of the picture").arg(i + 1)});
  addMarkersAndLight(inspection, facts);
}

void CaptureText::addMarkersAndLight(const capture::PlateInspection& inspection,
                                     std::vector<CaptureFact>& facts) const {
  const int needed = capture::markersNeeded(inspection.markers_on_plate);
  facts.push_back(
      {inspection.markers_seen >= needed, inspection.markers_seen >= needed
                                              ? CaptureWizard::tr("Markers %1 of %2")
                                                    .arg(inspection.markers_seen)
                                                    .arg(inspection.markers_on_plate)
                                              : CaptureWizard::tr("Markers %1 of %2, %3 needed")
                                                    .arg(inspection.markers_seen)
                                                    .arg(inspection.markers_on_plate)
                                                    .arg(needed)});
  if (inspection.dark_share > 0.02)
    facts.push_back({false, CaptureWizard::tr("%1 % of the sherds is too dark")
                                .arg(qRound(100 * inspection.dark_share))});
  if (inspection.bright_share > 0.02)
    facts.push_back({false, CaptureWizard::tr("%1 % of the sherds is too bright")
                                .arg(qRound(100 * inspection.bright_share))});
  if (inspection.dark_share <= 0.02 && inspection.bright_share <= 0.02 &&
      !inspection.sherds.empty())
    facts.push_back({true, CaptureWizard::tr("Lighting OK")});
}

}  // namespace ostraka::ui
