#include "virtualrig/virtual_camera.h"

#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>

#include "base/message.h"
#include "images/jpeg_image.h"
#include "rendering/photograph.h"
#include "virtualrig/batch_files.h"

namespace ostraka::virtualrig {
namespace {

using devices::Camera;
using devices::CameraFile;
using devices::CameraId;
using devices::CameraSetting;

constexpr double kRadians = std::numbers::pi / 180;
constexpr int kPreviewWidth = 960;  // small enough for a picture a second, large enough for markers

SimulateOptions simulateOptions(const VirtualDevicesOptions& options,
                                const std::filesystem::path& output) {
  SimulateOptions simulate = options;
  simulate.output = output;
  return simulate;
}

// The room with its plate, shared by the devices.
class VirtualPlace {
 public:
  VirtualPlace(const VirtualDevicesOptions& options, std::vector<vessels::VirtualSherd> sherds,
               Layout layout)
      : options_(options),
        sherds_(std::move(sherds)),
        layout_(std::move(layout)),
        plate_(options.plate, options.seed) {
    vessels::Random room_random(vessels::mixed(options.seed, 4));
    lighting_ = rendering::makeLighting(room_random);
    for (const bool small : {false, true}) {
      vessels::Random rig_random(vessels::mixed(options.seed, 3));
      const int width = small ? std::min(options.width, kPreviewWidth) : options.width;
      rig_ = makeRig(width, options.stops, rig_random);
      for (const rig::Intrinsics& k : rig_.intrinsics)
        (small ? small_lenses_ : lenses_).emplace_back(k);
    }
    lay(batch::Side::Front);
  }

  void lay(batch::Side side) {
    const std::lock_guard lock(guard_);
    if (scene_ && side == side_) return;
    side_ = side;
    scene_ = std::make_shared<const rendering::Scene>(
        sherds_, side == batch::Side::Front ? layout_.front : layout_.back);
    ambient_.reset();
    light_.reset();
  }

  void turn(double degrees) { degrees_ = degrees; }
  double degrees() const { return degrees_; }
  batch::Side side() const {
    const std::lock_guard lock(guard_);
    return side_;
  }
  devices::Clock& clock() const { return *options_.clock; }
  const VirtualDevicesOptions& options() const { return options_; }
  // Other sherds, another lens: another camera, so that no batch gets the back of another one.
  std::string serial(int camera) const {
    return batch::kVirtualSerial + batch::cameraLetter(camera) + " (seed " +
           std::to_string(options_.seed) + ", " + std::to_string(options_.sherds) + " sherds, " +
           std::to_string(options_.width) + " px" +
           (options_.near_duplicates > 0 ? ", near-duplicates" : "") +
           (options_.touching > 0 ? ", touching" : "") + ")";
  }

  std::string picture(int camera, double degrees, bool small, std::stop_token stop) {
    const Moment now = moment(degrees);
    const rendering::PlateBackdrop backdrop(now.lighting, *now.light, *now.ambient, plate_,
                                            now.angle_rad);
    const rendering::View view{*now.scene,
                               now.lighting,
                               *now.light,
                               *now.ambient,
                               backdrop,
                               rig_.camera_from_room[static_cast<std::size_t>(camera)] *
                                   Eigen::AngleAxisd(now.angle_rad, Eigen::Vector3d::UnitZ())};
    const auto c = static_cast<std::size_t>(camera);
    const auto id = static_cast<std::uint64_t>((now.side == batch::Side::Front ? 0 : 1000) +
                                               now.shot * kCameras + camera);
    const rendering::Photograph taken =
        rendering::photograph(view, (small ? small_lenses_ : lenses_)[c], {},
                              vessels::mixed(options_.seed, 9000 + id), stop);
    return stop.stop_requested() ? std::string()
                                 : images::encodedJpeg(taken.image, {.halved_colors = false});
  }

 private:
  // What the cameras see at one moment; shared, so that the next one may begin.
  struct Moment {
    batch::Side side;
    int shot;  // the stop, or a number beyond all stops
    double angle_rad;
    rendering::Lighting lighting;
    std::shared_ptr<const rendering::Scene> scene;
    std::shared_ptr<const rendering::AmbientField> ambient;
    std::shared_ptr<const rendering::LightField> light;
  };

  Moment moment(double degrees) {
    const std::lock_guard lock(guard_);
    const double turned = std::remainder(degrees, 360), step = 360.0 / options_.stops;
    const int near =
        (static_cast<int>(std::lround(turned / step)) + options_.stops) % options_.stops;
    const bool at_stop = std::abs(std::remainder(turned - near * step, 360)) < 1e-6;
    const int shot = at_stop ? near : 100'000 + static_cast<int>(std::lround(turned * 100));
    const double angle =
        at_stop ? rig_.angles_rad[static_cast<std::size_t>(near)] : turned * kRadians;
    const std::uint64_t seed =
        vessels::mixed(options_.seed, side_ == batch::Side::Front ? 101 : 102);
    const rendering::Lighting lighting = rendering::turned(lighting_, angle);
    if (!ambient_)
      ambient_ = std::make_shared<const rendering::AmbientField>(rendering::gatherAmbient(
          *scene_, lighting_, plate_, seed, {.threads = options_.threads}));
    if (!light_ || shot != light_shot_) {
      light_ = std::make_shared<const rendering::LightField>(rendering::castShadows(
          *scene_, lighting, vessels::mixed(seed, static_cast<std::uint64_t>(shot)),
          options_.threads));
      light_shot_ = shot;
    }
    return {side_, shot, angle, lighting, scene_, ambient_, light_};
  }

  const VirtualDevicesOptions options_;
  const std::vector<vessels::VirtualSherd> sherds_;
  const Layout layout_;
  const rendering::PlateSurface plate_;
  rendering::Lighting lighting_;
  VirtualRig rig_;  // intrinsics of the previews; places and angles are the same for all widths
  std::vector<rendering::LensRays> lenses_, small_lenses_;
  std::atomic<double> degrees_ = 0;
  mutable std::mutex guard_;  // of what follows
  batch::Side side_ = batch::Side::Front;
  std::shared_ptr<const rendering::Scene> scene_;
  std::shared_ptr<const rendering::AmbientField> ambient_;
  std::shared_ptr<const rendering::LightField> light_;
  int light_shot_ = -1;
};

class VirtualCamera final : public Camera {
 public:
  VirtualCamera(std::shared_ptr<VirtualPlace> place, int number)
      : place_(std::move(place)), number_(number) {}

  CameraId id() const override {
    return {"virtual", "Virtual camera", place_->serial(number_), "virtual"};
  }
  Result<std::vector<CameraSetting>> settings() override {
    return std::vector<CameraSetting>{{"iso", "100", {"100"}, true},
                                      {"aperture", "f/11", {"f/11"}, true},
                                      {"exposure", "1/8", {"1/8"}, true},
                                      {"white_balance", "fixed", {"fixed"}, true},
                                      {"focus", "manual", {"manual"}, true}};
  }
  Result<CameraSetting> set(const std::string& name, const std::string& value) override {
    const Result<std::vector<CameraSetting>> all = settings();
    for (const CameraSetting& setting : *all)
      if (setting.name == name && setting.value == value) return setting;
    return Error::unusable(message("The virtual camera has no setting %1 of %2.", name, value),
                           id().serial);
  }
  Result<std::string> preview(std::stop_token stop) override {
    const Sight sight{place_->side(), place_->degrees()};
    if (preview_.empty() || sight.side != previewed_.side || sight.degrees != previewed_.degrees) {
      preview_ = place_->picture(number_, sight.degrees, true, stop);
      previewed_ = sight;
    }
    if (preview_.empty()) return Error::cancelled();
    return preview_;
  }
  Result<void> getReady(std::stop_token) override {
    exposed_.reset();
    return {};
  }
  Result<void> trigger() override {
    exposed_ = place_->degrees();
    return {};
  }
  bool fileIsOfItsTrigger() const override { return true; }
  Result<std::vector<CameraFile>> fetch(double, std::stop_token stop) override {
    if (!exposed_)
      return Error::missing(message("The camera has taken no photograph."), id().serial);
    const double degrees = *exposed_;
    exposed_.reset();
    std::string bytes = place_->picture(number_, degrees, false, stop);
    if (bytes.empty()) return Error::cancelled();
    return std::vector<CameraFile>{{"VIRT0001.JPG", std::move(bytes)}};
  }
  Result<void> reopen(std::stop_token) override { return {}; }
  Result<void> close() override { return {}; }

 private:
  struct Sight {
    batch::Side side = batch::Side::Front;
    double degrees = 0;
  };
  std::shared_ptr<VirtualPlace> place_;
  int number_;
  std::optional<double> exposed_;
  std::string preview_;
  Sight previewed_;
};

class VirtualTurntable final : public devices::Turntable {
 public:
  explicit VirtualTurntable(std::shared_ptr<VirtualPlace> place) : place_(std::move(place)) {}

  std::string name() const override { return "Virtual turntable"; }
  Result<void> home(std::stop_token stop) override { return moveTo(0, stop); }
  Result<void> zeroHere(std::stop_token) override { return {}; }  // the plate is glued on
  Result<void> moveTo(double degrees, std::stop_token stop) override {
    halted_ = false;
    const double speed = place_->options().turn_deg_s;
    while (std::abs(degrees - place_->degrees()) > 0) {
      constexpr double kStep_s = 0.05;
      const double left = degrees - place_->degrees();
      if (speed <= 0 || std::abs(left) <= speed * kStep_s) {
        if (speed > 0 && !place_->clock().sleep(std::abs(left) / speed, stop))
          return Error::cancelled();
        place_->turn(degrees);
        break;
      }
      if (!place_->clock().sleep(kStep_s, stop) || halted_) return Error::cancelled();
      place_->turn(place_->degrees() + std::copysign(speed * kStep_s, left));
    }
    return stop.stop_requested() ? Result<void>(Error::cancelled()) : Result<void>();
  }
  void stopNow() override { halted_ = true; }
  std::optional<double> position_deg() const override { return place_->degrees(); }
  Result<void> reopen(std::stop_token) override { return {}; }
  void close() override {}

 private:
  std::shared_ptr<VirtualPlace> place_;
  std::atomic<bool> halted_ = false;
};

}  // namespace

Result<capture::RigDevices> openVirtualRig(const VirtualDevicesOptions& options) {
  const SimulateOptions simulate = simulateOptions(options, "virtual");
  if (const Result<void> checked = simulate.check(); !checked) return checked.error();
  Result<std::vector<vessels::VirtualSherd>> sherds = makeSherds(simulate);
  if (!sherds) return sherds.error();
  vessels::Random layout_random(vessels::mixed(options.seed, 2));
  Result<Layout> layout = layOut(*sherds, simulate, layout_random);
  if (!layout) return layout.error();
  const auto place =
      std::make_shared<VirtualPlace>(options, std::move(*sherds), std::move(*layout));
  capture::RigDevices devices;
  devices.turntable = std::make_unique<VirtualTurntable>(place);
  for (int c = 0; c < kCameras; ++c)
    devices.cameras.push_back(std::make_unique<VirtualCamera>(place, c));
  devices.plate = rendering::standardPlate();
  devices.settle_s = options.settle_s;
  devices.clock = options.clock;
  devices.side_placed = [place](batch::Side side) { place->lay(side); };
  return devices;
}

Result<void> writeVirtualCalibration(const VirtualDevicesOptions& options,
                                     const std::filesystem::path& batch, Progress& progress,
                                     std::stop_token stop) {
  std::error_code absent;
  // The last file that simulateCalibration writes stands for all.
  if (std::filesystem::exists(batch / "calib" / "cam2_cal11.jpg", absent)) return {};
  return simulateCalibration(simulateOptions(options, batch), progress, std::move(stop));
}

}  // namespace ostraka::virtualrig
