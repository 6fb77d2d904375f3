#include "virtualrig/simulate_by_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/parallel.h"
#include "base/text.h"
#include "rendering/photograph.h"
#include "rendering/sheet_backdrop.h"
#include "virtualrig/batch_files.h"
#include "virtualrig/exif.h"
#include "virtualrig/shot_report.h"
#include "virtualrig/walk_around.h"

namespace ostraka::virtualrig {
namespace {

// A summer's morning: seconds since its midnight as EXIF writes a moment.
std::string clockTime(double seconds) {
  const int s = static_cast<int>(seconds);
  return formatted("2026:07:14 %02d:%02d:%02d", s / 3600 % 24, s / 60 % 60, s % 60);
}

// Draws places until a thing lies clear of the sherds and of other things: on the sheet, or, as
// cards and pencils do, across its border or beside it. Absent when it finds none.
std::optional<Eigen::Isometry3d> clearPlace(rendering::PropKind kind,
                                            const rendering::SheetSurface& sheet,
                                            const std::vector<Eigen::Vector2d>& taken,
                                            vessels::Random& random) {
  constexpr double kClear = 4;  // mm
  const bool inside = kind == rendering::PropKind::ScaleBar || kind == rendering::PropKind::Label;
  const Eigen::Vector2d half = 0.5 * rendering::propSize(kind).head<2>() +
                               Eigen::Vector2d::Constant(kClear),
                        paper = sheet.plate().sheet->max();
  for (int round = 0; round < 600; ++round) {
    const double turn = random.uniform(0, 2 * std::numbers::pi);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    if (inside) {
      pose.translation() << random.uniform(-1, 1) * (paper.x() - 34),
          random.uniform(-1, 1) * (paper.y() - 34), 0;
    } else {
      const double around = random.uniform(0, 2 * std::numbers::pi);
      pose.translation() << std::cos(around) * (paper.x() + random.uniform(15, 70)),
          std::sin(around) * (paper.y() + random.uniform(15, 70)), 0;
    }
    bool clear = true;
    for (const double sx : {-1.0, 1.0})
      for (const double sy : {-1.0, 1.0}) {
        const Eigen::Vector3d corner = pose * Eigen::Vector3d(sx * half.x(), sy * half.y(), 0);
        // Whole on the paper's blank part, or with all its corners beside the paper.
        clear = clear && (inside ? sheet.blank(corner.head<2>().cast<float>())
                                 : !sheet.holds(corner.head<2>().cast<float>()));
      }
    for (std::size_t i = 0; clear && i < taken.size(); ++i) {
      const Eigen::Vector3d p = pose.inverse() * Eigen::Vector3d(taken[i].x(), taken[i].y(), 0);
      clear = std::abs(p.x()) > half.x() || std::abs(p.y()) > half.y();
    }
    if (clear) return pose;
  }
  return std::nullopt;
}

class Photographer {
 public:
  Photographer(const SimulateOptions& options, const CameraModel& model, std::stop_token stop,
               ShotReport& report)
      : options_(options), model_(model), stop_(std::move(stop)), report_(report) {
    vessels::Random sheet_random(vessels::mixed(options.seed, 13)),
        table_random(vessels::mixed(options.seed, 14)),
        room_random(vessels::mixed(options.seed, 12));
    sheet_.emplace(options.hand_held->sheet, options.hand_held->bend_mm, sheet_random);
    table_.emplace(options.hand_held->table, table_random);
    lighting_ = makeLighting(options.hand_held->light, room_random);
    start_s_ = room_random.uniform(9 * 3600, 16 * 3600);
  }

  const rendering::SheetSurface& sheet() const { return *sheet_; }

  // As many things as were asked for, in an order that chance chooses, as far as there is room.
  std::vector<rendering::Prop> clutter(const std::vector<vessels::VirtualSherd>& sherds,
                                       const std::vector<Eigen::Isometry3d>& poses,
                                       vessels::Random& random) const {
    std::vector<Eigen::Vector2d> taken;
    for (std::size_t s = 0; s < sherds.size(); ++s)
      for (const Eigen::Vector3f& v : sherds[s].mesh.vertices)
        taken.push_back((poses[s] * v.cast<double>()).head<2>());
    std::vector<rendering::Prop> props;
    const int first = random.below(rendering::kPropKinds);
    for (int i = 0; i < options_.hand_held->clutter; ++i) {
      const auto kind = static_cast<rendering::PropKind>((first + i) % rendering::kPropKinds);
      std::optional<Eigen::Isometry3d> place = clearPlace(kind, *sheet_, taken, random);
      if (!place) continue;
      if (sheet_->holds(place->translation().head<2>().cast<float>())) {
        const rendering::Prop flat =
            rendering::makeProp(kind, Eigen::Isometry3d::Identity(), random);
        place = rendering::restingOn(*sheet_, *place, flat.mesh.vertices);
      }
      props.push_back(rendering::makeProp(kind, *place, random));
      for (const Eigen::Vector3f& v : props.back().mesh.vertices)
        taken.push_back(v.head<2>().cast<double>());
    }
    return props;
  }

  // The shots [first, last) of one side.
  void shootSide(const rendering::Scene& scene, const std::vector<FreeShot>& shots,
                 std::size_t first, std::size_t last) const {
    const rendering::SheetGround ground(*sheet_, *table_);
    const std::uint64_t seed = vessels::mixed(options_.seed, first == 0 ? 101 : 102);
    const rendering::AmbientField ambient = rendering::gatherAmbient(
        scene, lighting_, ground, seed,
        {.turning = false, .side = 8, .ground_side = 12, .threads = options_.threads});
    if (stop_.stop_requested()) return;
    const rendering::LightField field =
        rendering::castShadows(scene, lighting_, seed, options_.threads);
    parallelFor(last - first, options_.threads, [&](std::size_t i) {
      if (stop_.stop_requested() || report_.failed()) return;
      report_.done(shoot(scene, ambient, field, shots[first + i], first + i));
    });
  }

 private:
  Result<void> shoot(const rendering::Scene& scene, const rendering::AmbientField& ambient,
                     const rendering::LightField& field, const FreeShot& shot,
                     std::size_t number) const {
    const rendering::Lighting lighting = options_.hand_held->light == rendering::LightKind::Flash
                                             ? withFlash(lighting_, shot.camera_from_plate)
                                             : lighting_;
    const rendering::SheetBackdrop backdrop(scene, lighting, field, ambient, *sheet_, *table_);
    const double fstop = options_.fstop.value_or(model_.fnumber);
    const rendering::Focus focus{fstop > 0 ? model_.focal_mm / fstop : 0, shot.focus_mm};
    const rendering::View view{scene, lighting, field, ambient, backdrop, shot.camera_from_plate,
                               {},    focus};
    const rendering::Photograph taken =
        rendering::photograph(view, rendering::LensRays(shot.intrinsics), shot.sensor,
                              vessels::mixed(options_.seed, 9000 + number), stop_);
    if (stop_.stop_requested()) return Error::cancelled();
    const std::string side = batch::name(shot.side);
    const std::filesystem::path& folder = options_.output;
    if (Result<void> r =
            writePng(folder / "truth" / "masks" / (side + "_" + shot.name + ".png"), taken.labels);
        !r)
      return r;
    CameraNotes notes;
    notes.make = "Ostraka";
    notes.model = model_.model;
    notes.time = clockTime(start_s_ + shot.time_s);
    notes.exposure_s = std::clamp(taken.gain / 60, 1 / 4000.0, 0.25);
    notes.fnumber = fstop > 0 ? fstop : model_.fnumber;
    notes.focal_mm = model_.focal_mm;
    notes.focal_35mm = static_cast<int>(std::lround(36 * model_.focal_per_width));
    notes.width = shot.intrinsics.width;
    notes.height = shot.intrinsics.height;
    return writeJpeg(folder / side / (shot.name + ".jpg"), taken.image,
                     {.quality = model_.jpeg_quality,
                      .halved_colors = model_.halved_colors,
                      .exif = exifSegment(notes)});
  }

  const SimulateOptions& options_;
  const CameraModel& model_;
  std::stop_token stop_;
  ShotReport& report_;
  std::optional<rendering::SheetSurface> sheet_;
  std::optional<rendering::TableSurface> table_;
  rendering::Lighting lighting_;
  double start_s_ = 0;
};

std::vector<rig::PosedImage> posedImages(const std::vector<FreeShot>& shots,
                                         const Eigen::Isometry3d& table_from_plate) {
  std::vector<rig::PosedImage> images;
  int count = 0;
  for (const FreeShot& shot : shots) {
    if (!images.empty() && images.back().side != shot.side) count = 0;
    images.push_back({std::string(batch::name(shot.side)) + "/" + shot.name + ".jpg", shot.side,
                      count++, 0, shot.intrinsics, shot.camera_from_plate * table_from_plate});
  }
  return images;
}

}  // namespace

Result<void> photographByHand(const std::vector<vessels::VirtualSherd>& sherds,
                              const Layout& layout, const SimulateOptions& options,
                              Progress& progress, std::stop_token stop) {
  vessels::Random random(vessels::mixed(options.seed, 11));
  const CameraModel model = cameraModel(options.hand_held->camera, random);
  const std::vector<FreeShot> shots = walkAround(*options.hand_held, model, options.width, random);
  ShotReport report(progress, static_cast<std::int64_t>(shots.size()));
  const Photographer photographer(options, model, stop, report);

  Layout lying;
  for (std::size_t s = 0; s < sherds.size(); ++s) {
    const auto& vertices = sherds[s].mesh.vertices;
    lying.front.push_back(rendering::restingOn(photographer.sheet(), layout.front[s], vertices));
    lying.back.push_back(rendering::restingOn(photographer.sheet(), layout.back[s], vertices));
  }
  if (Result<void> r = rig::writeSheet(options.output / "plate.json", photographer.sheet().plate());
      !r)
    return r;
  const Eigen::Isometry3d table_from_plate = photographer.sheet().tableFromPlate();
  Layout truth = lying;
  for (Eigen::Isometry3d& pose : truth.front) pose = table_from_plate.inverse() * pose;
  for (Eigen::Isometry3d& pose : truth.back) pose = table_from_plate.inverse() * pose;
  if (Result<void> r =
          writeTruth(options.output / "truth", sherds, truth, posedImages(shots, table_from_plate));
      !r)
    return r;
  const std::size_t half = shots.size() / 2;
  vessels::Random clutter(vessels::mixed(options.seed, 15));
  photographer.shootSide(
      rendering::Scene(sherds, lying.front, photographer.clutter(sherds, lying.front, clutter)),
      shots, 0, half);
  if (!stop.stop_requested())
    photographer.shootSide(
        rendering::Scene(sherds, lying.back, photographer.clutter(sherds, lying.back, clutter)),
        shots, half, shots.size());
  if (stop.stop_requested()) return Error::cancelled();
  return report.result();
}

}  // namespace ostraka::virtualrig
