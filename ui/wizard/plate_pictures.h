#pragma once
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <filesystem>
#include <optional>
#include <vector>

#include "ui/jobs/job.h"
#include "ui/wizard/capture_facts.h"

namespace ostraka::ui {

class BatchInHand;
class ProjectSession;
class RigConnection;

/// What a camera of the rig shows of the plate: live, while sherds are laid and turned, and as it
/// photographed the fronts.
class PlatePictures final : public QObject {
  Q_OBJECT

 public:
  /// Both outlive it.
  PlatePictures(RigConnection* rig, const BatchInHand* batch, QObject* parent);

  void setSession(ProjectSession* session);
  void setLive(bool on);  ///< live pictures are taken only while somebody looks
  void setPhase(CapturePhase phase) { phase_ = phase; }
  void preview();  ///< again, though the camera gave no live picture before
  void setCamera(int camera);
  void forget();
  /// uncounted: photographs of the fronts by camera, whose sherds nobody has counted yet.
  void readFront(std::vector<std::vector<std::filesystem::path>> uncounted);

  const std::optional<PlatePicture>& live() const { return live_; }
  const std::optional<PlatePicture>& front() const { return front_; }
  int camera() const { return camera_; }
  bool isLiveMissing() const { return live_missing_; }  ///< the camera has none

 signals:
  void changed();  ///< live() or front()
  void cameraChanged();
  void liveTurnedOn();
  void codesSeen(const QStringList& codes);  ///< while sherds are placed or turned over
  void frontCounted(const ostraka::capture::SideCheck& check);

 private:
  bool isUseful() const { return phase_ == CapturePhase::Place || phase_ == CapturePhase::Flip; }
  void takeLive();
  void showLive(const JobOutcome& outcome);

  RigConnection* rig_;
  const BatchInHand* batch_;
  QPointer<ProjectSession> session_;
  QPointer<JobHandle> front_job_;
  QTimer timer_;
  CapturePhase phase_ = CapturePhase::NoRig;
  bool live_on_ = false, live_missing_ = false;
  int camera_ = -1;
  std::optional<PlatePicture> live_, front_;
};

}  // namespace ostraka::ui
