#include "virtualrig/simulate.h"

#include <algorithm>

#include "base/message.h"
#include "base/parallel.h"
#include "files/new_folder.h"
#include "rendering/photograph.h"
#include "virtualrig/batch_files.h"
#include "virtualrig/shot_report.h"
#include "virtualrig/simulate_by_hand.h"
#include "virtualrig/virtual_scan.h"

namespace ostraka::virtualrig {
namespace {

// Standard deviation. At 480 pixels a blur of 1.3 makes markers' edges 3.3 pixels wide instead of
// 2.5, one of 2.2 makes them 3.6, and more hardly more: their black is that narrow. The chain calls
// 1.4 times a blur.
constexpr double kLeastBlur_px = 2.2;

// What a fault does to one photograph.
struct Mishap {
  bool missing = false;
  double kept_share = 1;
  double extra_blur_px = 0;
  rendering::Hand hand;
};

Mishap mishapOf(const SimulateOptions& options, batch::Side side, int camera, int stop) {
  Mishap m;
  if (!options.fault) return m;
  const bool front = side == batch::Side::Front;
  switch (*options.fault) {
    case Fault::Blur:
      if (front && camera == 1 && stop >= 2 && stop <= 4)
        m.extra_blur_px = std::max(kLeastBlur_px, 3.2 * options.width / 1600.0);
      break;
    case Fault::Missing:
      m.missing = (front && camera == 0 && stop == 1) || (front && camera == 2 && stop == 3) ||
                  (!front && camera == 1 && stop == 2);
      break;
    case Fault::Shadow:
      if (front && stop == 2)
        m.hand = Eigen::Vector2f(40.f - 30.f * static_cast<float>(camera), 35.f);
      break;
    case Fault::Truncated:
      if (front && camera == 2 && stop == 1) m.kept_share = 0.45;
      if (!front && camera == 0 && stop == 3) m.kept_share = 0.7;
      break;
    case Fault::Moved:
    case Fault::Covered:
      break;
  }
  return m;
}

class Studio {
 public:
  Studio(const SimulateOptions& options, const VirtualRig& rig, const rendering::Lighting& lighting,
         const rendering::PlateSurface& plate, std::stop_token stop, ShotReport& report)
      : options_(options),
        rig_(rig),
        lighting_(lighting),
        plate_(plate),
        stop_(std::move(stop)),
        report_(report) {
    for (const rig::Intrinsics& k : rig.intrinsics) lenses_.emplace_back(k);
  }

  // The stops [first, last) of one side, with the sherds lying as given.
  void shootStops(const std::vector<vessels::VirtualSherd>& sherds,
                  const std::vector<Eigen::Isometry3d>& poses, batch::Side side, int first,
                  int last) {
    const rendering::Scene scene(sherds, poses);
    const std::uint64_t seed =
        vessels::mixed(options_.seed, side == batch::Side::Front ? 101 : 102);
    const rendering::AmbientField ambient =
        rendering::gatherAmbient(scene, lighting_, plate_, seed, {.threads = options_.threads});
    std::vector<rendering::Lighting> lightings;
    std::vector<rendering::LightField> fields;
    for (int s = first; s < last && !stop_.stop_requested(); ++s) {
      lightings.push_back(rendering::turned(lighting_, rig_.angles_rad[s]));
      fields.push_back(rendering::castShadows(scene, lightings.back(), vessels::mixed(seed, s),
                                              options_.threads));
    }
    if (stop_.stop_requested()) return;
    parallelFor(static_cast<std::size_t>((last - first) * rig_.cameras()), options_.threads,
                [&](std::size_t i) {
                  const int s = static_cast<int>(i) / rig_.cameras(),
                            camera = static_cast<int>(i) % rig_.cameras();
                  if (stop_.stop_requested() || report_.failed()) return;
                  const rendering::Hand hand = mishapOf(options_, side, camera, first + s).hand;
                  const rendering::PlateBackdrop backdrop(lightings[s], fields[s], ambient, plate_,
                                                          rig_.angles_rad[first + s], hand);
                  const rendering::View view{scene,     lightings[s],
                                             fields[s], ambient,
                                             backdrop,  rig_.cameraFromPlate(camera, first + s),
                                             hand,      focusOf(camera)};
                  report_.done(shoot(view, side, camera, first + s));
                });
  }

  void shootEmptyPlate() {
    const std::vector<vessels::VirtualSherd> none;
    const rendering::Scene scene(none, {});
    const rendering::AmbientField ambient = rendering::gatherAmbient(
        scene, lighting_, plate_, options_.seed, {.threads = options_.threads});
    const rendering::LightField field =
        rendering::castShadows(scene, lighting_, options_.seed, options_.threads);
    const rendering::PlateBackdrop backdrop(lighting_, field, ambient, plate_, 0);
    parallelFor(lenses_.size(), options_.threads, [&](std::size_t c) {
      const int camera = static_cast<int>(c);
      const rendering::View view{scene,   lighting_,      field,
                                 ambient, backdrop,       rig_.cameraFromPlate(camera, 0),
                                 {},      focusOf(camera)};
      const rendering::Photograph shot = rendering::photograph(
          view, lenses_[c], sensor_, vessels::mixed(options_.seed, 7000 + c), stop_);
      report_.done(writeJpeg(options_.output / "calib" / ("empty_cam" + std::to_string(c) + ".jpg"),
                             shot.image));
    });
  }

  void shootBoards() {
    vessels::Random random(vessels::mixed(options_.seed, 5));
    std::vector<std::vector<Eigen::Isometry3d>> poses;
    for (const rig::Intrinsics& k : rig_.intrinsics) poses.push_back(boardPoses(k, random));
    const rendering::BoardSurface board;
    parallelFor(lenses_.size() * poses[0].size(), options_.threads, [&](std::size_t i) {
      if (stop_.stop_requested() || report_.failed()) return;
      const std::size_t camera = i / poses[0].size(), n = i % poses[0].size();
      const cv::Mat image =
          rendering::photographBoard(board, lenses_[camera], poses[camera][n], sensor_,
                                     vessels::mixed(options_.seed, 8000 + i));
      const std::string file = "cam" + std::to_string(camera) + "_cal" + (n < 10 ? "0" : "") +
                               std::to_string(n) + ".jpg";
      report_.done(writeJpeg(options_.output / "calib" / file, image));
    });
  }

 private:
  // Focused by hand on the plate's middle, on a sensor of 23.5 mm width.
  rendering::Focus focusOf(int camera) const {
    if (options_.fstop.value_or(0) <= 0) return {};
    const rig::Intrinsics& k = rig_.intrinsics[static_cast<std::size_t>(camera)];
    return {k.fx / k.width * 23.5 / *options_.fstop,
            rig_.cameraFromPlate(camera, 0).translation().z()};
  }

  Result<void> shoot(const rendering::View& view, batch::Side side, int camera,
                     int stop_index) const {
    const Mishap mishap = mishapOf(options_, side, camera, stop_index);
    rendering::Sensor sensor = sensor_;
    sensor.blur_px = std::hypot(sensor.blur_px, mishap.extra_blur_px);
    const auto id = static_cast<std::uint64_t>((side == batch::Side::Front ? 0 : 1000) +
                                               stop_index * rig_.cameras() + camera);
    const rendering::Photograph shot =
        rendering::photograph(view, lenses_[static_cast<std::size_t>(camera)], sensor,
                              vessels::mixed(options_.seed, 9000 + id), stop_);
    if (stop_.stop_requested()) return Error::cancelled();
    const std::string file = photographName(side, camera, stop_index);
    std::string mask = file.substr(0, file.size() - 4) + ".png";
    mask[mask.find('/')] = '_';
    if (Result<void> r = writePng(options_.output / "truth" / "masks" / mask, shot.labels); !r)
      return r;
    if (mishap.missing) return {};
    return writeJpeg(options_.output / file, shot.image, {.halved_colors = false},
                     mishap.kept_share);
  }

  const SimulateOptions& options_;
  const VirtualRig& rig_;
  const rendering::Lighting& lighting_;
  const rendering::PlateSurface& plate_;
  std::stop_token stop_;
  ShotReport& report_;
  rendering::Sensor sensor_;
  std::vector<rendering::LensRays> lenses_;
};

// A push of the first sherd by 4 mm and 6 degrees about its own middle, away from its neighbour.
std::vector<Eigen::Isometry3d> pushed(std::vector<Eigen::Isometry3d> poses) {
  Eigen::Isometry3d& pose = poses.front();
  Eigen::Vector3d away = -pose.translation();
  double nearest = 1e9;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Eigen::Vector3d from = pose.translation() - poses[i].translation();
    if (from.head<2>().norm() >= nearest) continue;
    nearest = from.head<2>().norm();
    away = from;
  }
  away.z() = 0;
  pose.linear() =
      Eigen::AngleAxisd(0.105, Eigen::Vector3d::UnitZ()).toRotationMatrix() * pose.linear();
  pose.translation() += 4 * away.normalized();
  return poses;
}

Result<void> fill(const SimulateOptions& options, Progress& progress, std::stop_token stop) {
  const Result<std::vector<vessels::VirtualSherd>> sherds = makeSherds(options);
  if (!sherds) return sherds.error();
  vessels::Random layout_random(vessels::mixed(options.seed, 2)),
      rig_random(vessels::mixed(options.seed, 3)), room_random(vessels::mixed(options.seed, 4));
  const Result<Layout> layout = layOut(*sherds, options, layout_random);
  if (!layout) return layout.error();
  if (stop.stop_requested()) return Error::cancelled();
  if (options.hand_held) return photographByHand(*sherds, *layout, options, progress, stop);
  const VirtualRig rig = options.rig ? asVirtual(*options.rig, options.width)
                                     : makeRig(options.width, options.stops, rig_random);
  const int stops = static_cast<int>(rig.angles_rad.size());
  const rendering::Lighting lighting = rendering::makeLighting(room_random);
  progress.note(NoteLevel::Info,
                "virtualrig: " + std::to_string(sherds->size()) + " sherds made and laid down");
  if (options.scans_only) return writeScans(*sherds, *layout, rig, options, progress, stop);
  if (Result<void> r = writePlateAndBoard(options.output); !r) return r;
  if (Result<void> r = writeTruth(options.output / "truth", *sherds, *layout, posedImages(rig)); !r)
    return r;

  ShotReport report(progress, rig.cameras() * (2 * stops + (options.rig ? 1 : 13)));
  rendering::PlateSurface plate(options.plate, options.seed);
  rendering::PlateSurface covered = plate;
  if (options.fault == Fault::Covered) covered.coverMarkers(8);
  Studio front(options, rig, lighting, covered, stop, report);
  const int push = options.fault == Fault::Moved ? stops / 2 : stops;
  front.shootStops(*sherds, layout->front, batch::Side::Front, 0, push);
  if (push < stops)
    front.shootStops(*sherds, pushed(layout->front), batch::Side::Front, push, stops);
  Studio studio(options, rig, lighting, plate, stop, report);
  studio.shootStops(*sherds, layout->back, batch::Side::Back, 0, stops);
  studio.shootEmptyPlate();
  if (!options.rig) studio.shootBoards();
  if (stop.stop_requested()) return Error::cancelled();
  return report.result();
}

}  // namespace

Result<void> SimulateOptions::check() const {
  const auto bad = [](const Message& what) { return Error::unusable(what); };
  if (meshes.size() > 40) return bad("meshes may hold 40 files at most.");
  if (!meshes.empty() && (scans_only || near_duplicates > 0 || !radii_mm.empty()))
    return bad(
        "meshes are photographed as they are: no scans_only, no near_duplicates, no radii_mm.");
  if (sherds < 1 || sherds > 40) return bad(message("sherds must be between 1 and 40."));
  if (width < 160 || width > 8192 || width % 4 != 0)
    return bad(message("width must be between 160 and 8192 pixels and divisible by 4."));
  if (output.empty()) return bad("output must name a folder.");
  if (stops < 2 || stops > 72) return bad("stops must be between 2 and 72.");
  if (gloss && !(*gloss >= 0 && *gloss <= 1)) return bad("gloss must be between 0 and 1.");
  if (fstop && *fstop != 0 && !(*fstop >= 1 && *fstop <= 64))
    return bad("fstop must be 0, for none, or be between 1 and 64.");
  if (near_duplicates < 0 || 2 * near_duplicates > sherds)
    return bad(message("near_duplicates are groups of two: at most half the number of sherds."));
  if (touching < 0 || 2 * touching > sherds)
    return bad("touching counts pairs: at most half the number of sherds.");
  if (scans_only && fault)
    return bad("fault is about photographs, and scans_only makes none; leave one of them out.");
  if (hand_held) {
    if (scans_only || fault || rig)
      return bad("hand_held takes photographs without a rig: no scans_only, no fault, no rig.");
    if (Result<void> r = hand_held->check(); !r) return r;
  }
  if (!radii_mm.empty() && static_cast<int>(radii_mm.size()) != sherds)
    return bad("radii_mm must hold one radius per sherd.");
  for (const double radius : radii_mm)
    if (!(radius >= 8 && radius <= 60)) return bad("radii_mm must be between 8 and 60 mm.");
  if (rig && (rig->cameras.empty() || rig->stop_angles_rad.size() < 4))
    return bad(message("The rig needs a camera and at least four positions; recalibrate it."));
  return {};
}

Result<void> simulateBatch(const SimulateOptions& options, Progress& progress,
                           std::stop_token stop) {
  if (Result<void> r = options.check(); !r) return r;
  Result<NewFolder> folder = NewFolder::begin(options.output);
  if (!folder) return folder.error();
  SimulateOptions beside = options;
  beside.output = folder->path();
  Result<void> made = fill(beside, progress, std::move(stop));
  if (made) made = folder->finish();
  if (made || made.error().code != ErrorCode::CannotWrite) return made;
  return Error{ErrorCode::CannotWrite, made.error().what, options.output.string()};
}

Result<void> simulateCalibration(const SimulateOptions& options, Progress& progress,
                                 std::stop_token stop) {
  if (Result<void> r = options.check(); !r) return r;
  vessels::Random rig_random(vessels::mixed(options.seed, 3)),
      room_random(vessels::mixed(options.seed, 4));
  const VirtualRig rig = makeRig(options.width, options.stops, rig_random);
  const rendering::Lighting lighting = rendering::makeLighting(room_random);
  const rendering::PlateSurface plate(options.plate, options.seed);
  if (Result<void> r = writePlateAndBoard(options.output); !r) return r;
  ShotReport report(progress, 13 * kCameras);
  Studio studio(options, rig, lighting, plate, stop, report);
  studio.shootEmptyPlate();
  studio.shootBoards();
  if (stop.stop_requested()) return Error::cancelled();
  return report.result();
}

}  // namespace ostraka::virtualrig
