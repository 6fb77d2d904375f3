#pragma once
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "capture/sequence.h"
#include "tests/core/capture/simulated_clock.h"

/// A rig of paper: quick pictures of a flat plate with real markers and painted sherds. Every
/// exposure carries its camera and the true angle in the file, so that a test can tell whose it is.
namespace ostraka::capture::testing {

struct FlatSherd {
  double x_mm = 0, y_mm = 0, radius_mm = 12;
};

struct FlatScene {
  std::vector<FlatSherd> sherds{{-60, 30, 14}, {20, 50, 18}, {40, -40, 12}};
  int width = 640;
  double shift_mm = 0;  ///< of the plate out of the pictures, to the right
  double blur_px = 0;
};

batch::Plate flatPlate();
/// The plate turned counter-clockwise, before a camera of this number; note goes into the file.
std::string flatPicture(const FlatScene& scene, int camera, double degrees,
                        const std::string& note);
/// What flatPicture was told; empty when there is none.
std::string noteOf(const std::string& jpeg);

/// The truth that devices of this rig share.
struct FlatTruth {
  FlatScene scene;
  double degrees = 0;  ///< where the table really stands
  std::string side = "front";
  std::atomic<int> exposures = 0;
  std::shared_ptr<devices::Clock> clock = std::make_shared<SimulatedClock>();
  /// Where the table really stands, when another table than FlatTurntable turns it.
  std::function<double()> turned_by = {};
  double stands_at() const { return turned_by ? turned_by() : degrees; }
};

/// "front camera 1 at 45.0", as the note of every exposure begins.
std::string exposureNote(const std::string& side, int camera, double degrees);

class FlatCamera final : public devices::Camera {
 public:
  FlatCamera(std::shared_ptr<FlatTruth> truth, int number)
      : truth_(std::move(truth)), number_(number) {}

  devices::CameraId id() const override;
  Result<std::vector<devices::CameraSetting>> settings() override {
    return std::vector<devices::CameraSetting>{{"exposure", exposure_time, {}, false}};
  }
  Result<devices::CameraSetting> set(const std::string& name, const std::string& value) override;
  Result<std::string> preview(std::stop_token) override;
  Result<void> getReady(std::stop_token) override;
  Result<void> trigger() override;
  Result<std::vector<devices::CameraFile>> fetch(double timeout_s, std::stop_token stop) override;
  Result<void> reopen(std::stop_token) override;
  Result<void> close() override { return {}; }

  /// What goes wrong at the next triggers, one each; then all is well.
  enum class Fault { None, Unplugged, Silent, Late, Truncated, Stale, Blurred, Gone };
  std::deque<Fault> faults;
  std::function<Fault()> chance;      ///< after them
  bool lags = false;                  ///< hands over what the trigger before made, at each trigger
  std::string exposure_time = "1/8";  ///< and again after it was pulled out
  bool has_dial = false;              ///< keeps its exposure whatever it is told
  int reopened = 0;

 private:
  std::shared_ptr<FlatTruth> truth_;
  int number_;
  bool plugged_ = true;
  std::vector<devices::CameraFile> buffer_, late_;
  std::string last_;
};

class FlatTurntable final : public devices::Turntable {
 public:
  explicit FlatTurntable(std::shared_ptr<FlatTruth> truth) : truth_(std::move(truth)) {}

  std::string name() const override { return "flat table"; }
  Result<void> home(std::stop_token) override;
  Result<void> zeroHere(std::stop_token) override;
  Result<void> moveTo(double degrees, std::stop_token stop) override;
  void stopNow() override {}
  std::optional<double> position_deg() const override { return count_; }
  Result<void> reopen(std::stop_token) override;
  void close() override {}
  void forgetPosition() { count_.reset(); }

  enum class Fault { None, UnpluggedBefore, UnpluggedMidway, Restarted, Slipped };
  std::deque<Fault> faults;
  bool has_switch = true;
  int turned = 0;

 private:
  std::shared_ptr<FlatTruth> truth_;
  std::optional<double> count_ = 0;
};

struct FlatRig {
  std::shared_ptr<FlatTruth> truth = std::make_shared<FlatTruth>();
  RigDevices devices;
  std::vector<FlatCamera*> cameras;
  FlatTurntable* table = nullptr;
};
FlatRig makeFlatRig(int cameras);

}  // namespace ostraka::capture::testing
