#pragma once
#include <QString>
#include <vector>

#include "ui/wizard/capture_facts.h"

namespace ostraka::ui {

class BatchInHand;
class CaptureWizard;
class PlatePictures;
class RigConnection;
class SideProgress;

/// What the capture says in each phase.
class CaptureText {
 public:
  explicit CaptureText(const CaptureWizard& wizard);  ///< which outlives it

  QString headline() const;     ///< readable from three metres
  QString instruction() const;  ///< one or two sentences
  QString button() const;       ///< of the one big button
  std::vector<CaptureFact> facts() const;

 private:
  void addSherdsToReshoot(std::vector<CaptureFact>& facts) const;
  void addFlip(std::vector<CaptureFact>& facts) const;
  void addDone(int front, int back, int photographs, std::vector<CaptureFact>& facts) const;
  void addLive(std::vector<CaptureFact>& facts) const;
  void addMarkersAndLight(const capture::PlateInspection& inspection,
                          std::vector<CaptureFact>& facts) const;

  const CaptureWizard& wizard_;
  const RigConnection& rig_;
  const SideProgress& side_;
  const PlatePictures& pictures_;
  const BatchInHand& batch_;
};

}  // namespace ostraka::ui
