#pragma once
#include <atomic>
#include <memory>
#include <optional>

#include "ui/wizard/rig_source.h"

/// A rig without pictures: what the wizard asks of it is written down, and it answers as a test
/// says.
namespace ostraka::ui {

struct FakeRig {
  int opened = 0, prepared = 0, opened_for = 0;
  std::vector<batch::Side> placed, shot;
  std::vector<capture::SideOptions> asked;
  std::atomic<int> stopped = 0;
  std::optional<Error> refuse_open, refuse_shoot;
  int front = 9, back = 9;                  ///< sherds counted
  std::vector<capture::ShotName> flagged;   ///< of the next side
  bool cut_off = false;                     ///< what is flagged
  bool ask = false;                         ///< opening asks a person to do something
  std::atomic<bool> wait_for_stop = false;  ///< the next side runs until it is stopped
  int released = 0;                         ///< how often the desktop was asked to let go
  std::vector<std::string> holders;         ///< of a camera, until they are asked to let go
  bool stubborn = false;                    ///< they do not
  std::string preview;                      ///< what the cameras see; empty: no live picture
};

class FakeTable final : public devices::Turntable {
 public:
  explicit FakeTable(FakeRig& rig) : rig_(rig) {}
  std::string name() const override { return "a table"; }
  Result<void> home(std::stop_token) override { return {}; }
  Result<void> zeroHere(std::stop_token) override { return {}; }
  Result<void> moveTo(double, std::stop_token) override { return {}; }
  void stopNow() override { ++rig_.stopped; }
  std::optional<double> position_deg() const override { return 0.0; }
  Result<void> reopen(std::stop_token) override { return {}; }
  void close() override {}

 private:
  FakeRig& rig_;
};

class FakeCamera final : public devices::Camera {
 public:
  explicit FakeCamera(FakeRig& rig) : rig_(rig) {}
  devices::CameraId id() const override { return {"folder", "a camera", "1", ""}; }
  Result<std::vector<devices::CameraSetting>> settings() override {
    return std::vector<devices::CameraSetting>();
  }
  Result<devices::CameraSetting> set(const std::string&, const std::string&) override {
    return devices::CameraSetting();
  }
  Result<std::string> preview(std::stop_token) override {
    if (!rig_.preview.empty()) return rig_.preview;
    return Error{ErrorCode::Missing, "This camera has no live picture.", "camera"};
  }
  Result<void> getReady(std::stop_token) override { return {}; }
  Result<void> trigger() override { return {}; }
  Result<std::vector<devices::CameraFile>> fetch(double, std::stop_token) override {
    return std::vector<devices::CameraFile>();
  }
  Result<void> reopen(std::stop_token) override { return {}; }
  Result<void> close() override { return {}; }

 private:
  FakeRig& rig_;
};

inline RigSource sourceOf(FakeRig& rig) {
  RigSource source;
  source.words = QStringLiteral("ready");
  source.open = [&rig](int batch, const devices::AskPerson& ask,
                       std::stop_token stop) -> Result<std::shared_ptr<capture::RigDevices>> {
    ++rig.opened;
    rig.opened_for = batch;
    if (rig.refuse_open) return *rig.refuse_open;
    if (rig.ask && !ask("Switch the table on.", stop)) return Error::cancelled();
    auto devices = std::make_shared<capture::RigDevices>();
    devices->plate.dictionary = "DICT_4X4_100";
    devices->turntable = std::make_unique<FakeTable>(rig);
    for (int camera = 0; camera < 3; ++camera)
      devices->cameras.push_back(std::make_unique<FakeCamera>(rig));
    devices->side_placed = [&rig](batch::Side side) { rig.placed.push_back(side); };
    return devices;
  };
  source.prepare = [&rig](const std::filesystem::path&, int, Progress&,
                          std::stop_token) -> Result<void> {
    ++rig.prepared;
    return {};
  };
  source.shoot = [&rig](capture::RigDevices&, const capture::SideOptions& options,
                        const capture::OnCaptureEvent& on_event, Progress&,
                        std::stop_token stop) -> Result<capture::SideSummary> {
    rig.asked.push_back(options);
    while (rig.wait_for_stop && !stop.stop_requested()) {
    }
    if (stop.stop_requested()) return Error::cancelled();
    rig.shot.push_back(options.side);
    capture::CaptureEvent event;
    event.side = options.side;
    event.stop = 0;
    event.camera = 1;
    event.take = 1;
    event.kind = capture::CaptureEventKind::ShotKept;
    if (!rig.flagged.empty()) event.check.problems.push_back(capture::ShotProblem::Blurred);
    on_event(event);
    if (rig.refuse_shoot) return *std::exchange(rig.refuse_shoot, std::nullopt);
    capture::SideSummary summary;
    summary.kept = options.stops * 3;
    summary.flagged = std::exchange(rig.flagged, {});
    summary.cut_off = std::exchange(rig.cut_off, false);
    summary.check.counted = true;
    summary.check.sherds = options.side == batch::Side::Front ? rig.front : rig.back;
    return summary;
  };
  source.check = [&rig](const auto&, const auto&, const auto&, std::stop_token) {
    capture::SideCheck check;
    check.counted = true;
    check.sherds = rig.front;
    return check;
  };
  source.holders = [&rig] { return rig.holders; };
  source.release = [&rig](std::stop_token) -> Result<void> {
    ++rig.released;
    if (rig.stubborn) return Error{ErrorCode::Failed, "It does not let go.", "D3200"};
    rig.holders.clear();
    rig.refuse_open.reset();
    return {};
  };
  return source;
}

}  // namespace ostraka::ui
