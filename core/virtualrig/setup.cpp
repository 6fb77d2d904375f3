#include "virtualrig/setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/parallel.h"
#include "rendering/plate_surface.h"
#include "rig/plate_print.h"
#include "vessels/given_mesh.h"
#include "virtualrig/layout.h"

namespace ostraka::virtualrig {
namespace {

constexpr std::optional<double> kShinyByHand = 0.3;  // share of what people bring to a table

struct Order {
  vessels::VesselForm form = vessels::VesselForm::Bowl;
  double wall_mm = 6;
  std::uint64_t vessel_seed = 0, clay_seed = 0;
  vessels::BreakPlan plan;
  int group = -1;
};

// A place on the vessel where a piece of this part and size can lie.
void choosePlace(Order& order, vessels::Random& random) {
  vessels::Random vessel_random(order.vessel_seed);
  const vessels::Vessel vessel = vessels::Vessel::make(order.form, order.wall_mm, vessel_random);
  const double reach = 1.35 * order.plan.radius_mm;
  if (order.plan.part == vessels::SherdPart::Rim) {
    order.plan.s_mm = vessel.length() - order.plan.radius_mm * random.uniform(0.35, 0.7);
  } else if (order.plan.part == vessels::SherdPart::Base) {
    order.plan.s_mm = vessel.heel() * random.uniform(0.5, 0.95);
  } else {
    const double low = vessel.heel() + reach, high = vessel.length() - reach - 3;
    order.plan.s_mm = low < high ? random.uniform(low, high) : 0.5 * (low + high);
  }
}

// Sizes spread as in a bag of sherds, shrunk together when their area would not fit on the plate.
std::vector<double> drawRadii(int count, const FreeArea& free, vessels::Random& random) {
  std::vector<double> radii;
  double area = 0;
  for (int i = 0; i < count; ++i) {
    const double rank = count > 1 ? static_cast<double>(i) / (count - 1) : 0.4;
    radii.push_back(38 - 25 * rank + random.uniform(-2, 2));
    area += radii.back() * radii.back();
  }
  const double most = 0.36 * free.area() / std::numbers::pi;  // still found by trying
  if (area > most)
    for (double& r : radii) r *= std::sqrt(most / area);
  return radii;
}

std::optional<double> shinyShare(const SimulateOptions& options) {
  return options.hand_held && !options.gloss ? kShinyByHand : options.gloss;
}

Result<std::vector<vessels::VirtualSherd>> givenMeshes(const SimulateOptions& options) {
  vessels::Random random(vessels::mixed(options.seed, 1));
  std::vector<vessels::VirtualSherd> sherds;
  for (const std::filesystem::path& file : options.meshes) {
    Result<vessels::VirtualSherd> sherd = vessels::sherdOfMesh(file);
    if (!sherd) return sherd.error();
    sherd->clay = vessels::makeClay(options.plain, random);
    if (const std::optional<double> shiny = shinyShare(options))
      vessels::widen(sherd->clay, *shiny, random);
    sherds.push_back(std::move(*sherd));
  }
  return sherds;
}

}  // namespace

Eigen::Isometry3d lookingAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                            double roll) {
  const Eigen::Vector3d z = (target - eye).normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized(), y = z.cross(x);
  Eigen::Matrix3d camera_from_room;
  camera_from_room << x.transpose(), y.transpose(), z.transpose();
  camera_from_room =
      Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()).toRotationMatrix() * camera_from_room;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = camera_from_room;
  pose.translation() = -camera_from_room * eye;
  return pose;
}

Eigen::Isometry3d VirtualRig::cameraFromPlate(int camera, int stop) const {
  return camera_from_room[camera] * Eigen::AngleAxisd(angles_rad[stop], Eigen::Vector3d::UnitZ());
}

VirtualRig makeRig(int width, int stops, vessels::Random& random) {
  VirtualRig rig;
  rig.intrinsics.resize(kCameras);
  rig.camera_from_room.resize(kCameras);
  const double scale = width / 1600.0;
  const int height = width * 3 / 4;
  const std::array<double, kCameras> elevation{24.5, 44, 64}, focal{2670, 2750, 2460},
      distance{641, 660, 643};
  for (int c = 0; c < kCameras; ++c) {
    rig::Intrinsics& k = rig.intrinsics[c];
    k.width = width;
    k.height = height;
    k.fx = k.fy = focal[c] * random.uniform(0.96, 1.0) * scale;
    k.cx = (799.5 + random.uniform(-6, 6) + 0.5) * scale - 0.5;  // a pixel's centre is its integer
    k.cy = (599.5 + random.uniform(-6, 6) + 0.5) * scale - 0.5;
    k.distortion = {{random.uniform(-0.08, 0.05), random.uniform(-0.02, 0.02),
                     random.uniform(-5e-4, 5e-4), random.uniform(-5e-4, 5e-4), 0}};
    const double up = (elevation[c] + random.uniform(-2, 2)) * std::numbers::pi / 180;
    const double azimuth = (-98 + 10 * c + random.uniform(-4, 4)) * std::numbers::pi / 180;
    const double away = distance[c] * random.uniform(1.0, 1.03);
    const Eigen::Vector3d eye(away * std::cos(up) * std::cos(azimuth),
                              away * std::cos(up) * std::sin(azimuth), away * std::sin(up));
    // The plate's near edge looks larger: aim so that its near and far edge are as far from the
    // middle.
    const double far = std::hypot(away, 165.0),
                 skew = std::atan2(165 * std::sin(up), away - 165 * std::cos(up)) -
                        std::atan2(165 * std::sin(up), away + 165 * std::cos(up));
    const double towards = far * std::tan(skew / 2) / std::sin(up);
    const Eigen::Vector3d target(towards * std::cos(azimuth) + random.uniform(-4, 4),
                                 towards * std::sin(azimuth) + random.uniform(-4, 4), 0);
    rig.camera_from_room[c] = lookingAt(eye, target, random.uniform(-0.01, 0.01));
  }
  for (int s = 0; s < stops; ++s)  // a hand-turned plate misses its marks by a third of a degree
    rig.angles_rad.push_back(2 * std::numbers::pi * s / stops +
                             (s > 0 ? random.uniform(-0.3, 0.3) * std::numbers::pi / 180 : 0));
  return rig;
}

VirtualRig asVirtual(const rig::Rig& rig, int width) {
  VirtualRig out;
  for (const rig::RigCamera& camera : rig.cameras) {
    const double scale = static_cast<double>(width) / rig.cameras.front().intrinsics.width;
    rig::Intrinsics k = camera.intrinsics;
    k.width = static_cast<int>(std::lround(k.width * scale));
    k.height = static_cast<int>(std::lround(k.height * scale));
    k.fx *= scale;
    k.fy *= scale;
    k.cx = (k.cx + 0.5) * scale - 0.5;
    k.cy = (k.cy + 0.5) * scale - 0.5;
    out.intrinsics.push_back(k);
    out.camera_from_room.push_back(camera.camera_from_turntable);
  }
  out.angles_rad = rig.stop_angles_rad;
  return out;
}

std::vector<Eigen::Isometry3d> boardPoses(const rig::Intrinsics& camera, vessels::Random& random) {
  const batch::Board board = rig::standardBoard();
  const Eigen::Vector3d middle(board.squares_x * board.square_mm / 2,
                               board.squares_y * board.square_mm / 2, 0);
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 12; ++i) {
    const double distance = i % 3 == 0 ? random.uniform(400, 480) : random.uniform(500, 640);
    const double u = ((i % 4) - 1.5) / 3 * 0.56 + random.uniform(-0.05, 0.05);
    const double v = ((i / 4) - 1.0) / 2 * 0.52 + random.uniform(-0.05, 0.05);
    const double tilt = random.uniform(0.25, 0.65), about = random.uniform(0, 2 * std::numbers::pi);
    const Eigen::Vector3d axis(std::cos(about), std::sin(about), 0);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = (Eigen::AngleAxisd(tilt, axis) *
                     Eigen::AngleAxisd(random.uniform(-0.35, 0.35), Eigen::Vector3d::UnitZ()))
                        .toRotationMatrix();
    const Eigen::Vector3d centre(distance * u * camera.width / camera.fx,
                                 distance * v * camera.height / camera.fy, distance);
    pose.translation() = centre - pose.linear() * middle;
    poses.push_back(pose);
  }
  return poses;
}

Result<std::vector<vessels::VirtualSherd>> makeSherds(const SimulateOptions& options) {
  if (!options.meshes.empty()) return givenMeshes(options);
  vessels::Random random(vessels::mixed(options.seed, 1));
  const std::vector<double> radii = options.radii_mm.empty()
                                        ? drawRadii(options.sherds, freeArea(options), random)
                                        : options.radii_mm;
  std::vector<Order> orders(static_cast<std::size_t>(options.sherds));
  for (int i = 0; i < options.sherds; ++i) {
    Order& order = orders[i];
    // Near-duplicates stand at the end of the list, in twos, like the sherd before.
    const int from_end = options.sherds - 1 - i;
    if (from_end < 2 * options.near_duplicates && from_end % 2 == 0) {
      order = orders[i - 1];
      order.plan.relief_seed = random.next();
      continue;
    }
    order.form = static_cast<vessels::VesselForm>(random.below(3));
    order.wall_mm = random.uniform(3.6, 8.2) * std::clamp(radii[i] / 26, 0.75, 1.1);
    order.vessel_seed = random.next();
    order.clay_seed = random.next();
    const double part = random.uniform();
    order.plan.part = part < 0.6    ? vessels::SherdPart::Wall
                      : part < 0.85 ? vessels::SherdPart::Rim
                                    : vessels::SherdPart::Base;
    order.plan.radius_mm = radii[i];
    order.plan.relief_mm = random.uniform(0.35, 0.7);
    order.plan.tilt_rad = random.uniform(0.25, 0.5);
    order.plan.outline_seed = random.next();
    order.plan.relief_seed = random.next();
    if (from_end < 2 * options.near_duplicates) order.group = from_end / 2;
    if (order.form == vessels::VesselForm::Jug && order.plan.part != vessels::SherdPart::Base &&
        radii[i] > 30)
      order.form = vessels::VesselForm::Jar;
    choosePlace(order, random);
  }
  const std::optional<double> shiny = shinyShare(options);
  std::vector<vessels::VirtualSherd> sherds(orders.size());
  parallelFor(orders.size(), options.threads, [&](std::size_t i) {
    vessels::Random vessel_random(orders[i].vessel_seed), clay_random(orders[i].clay_seed);
    const vessels::Vessel vessel =
        vessels::Vessel::make(orders[i].form, orders[i].wall_mm, vessel_random);
    sherds[i] = vessels::breakOut(vessel, orders[i].plan);
    sherds[i].clay = vessels::makeClay(options.plain, clay_random);
    if (shiny) vessels::widen(sherds[i].clay, *shiny, clay_random);
    sherds[i].lookalike_group = orders[i].group;
  });
  return sherds;
}

}  // namespace ostraka::virtualrig
