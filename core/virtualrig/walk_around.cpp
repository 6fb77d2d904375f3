#include "virtualrig/walk_around.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.h"
#include "virtualrig/setup.h"

namespace ostraka::virtualrig {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double bounded(vessels::Random& random, double sd, double most) {
  return std::clamp(random.normal() * sd, -most, most);
}

Eigen::Vector3f tinted(double strength, double warmth) {
  const auto s = static_cast<float>(strength), t = static_cast<float>(warmth);
  return {s * (1 + t), s, s * (1 - t)};
}

// Elevations of one side: low, middle and high ones in turn, as people learn to do it.
double elevation(int i, vessels::Random& random) {
  static constexpr std::array<double, 4> kRounds{31, 66, 50, 27};
  return std::clamp(kRounds[static_cast<std::size_t>(i % 4)] + 4.5 * random.normal(), 22.0, 72.0) *
         kDegree;
}

rendering::Sensor sensorOfShot(rendering::Sensor sensor, double scale, vessels::Random& random) {
  sensor.exposure = std::pow(2, 0.12 * random.normal());
  for (const int c : {0, 2})
    sensor.balance[c] = static_cast<float>(std::exp(0.03 * random.normal()));
  const double shake = std::min(2.2, std::abs(0.7 * random.normal())) * scale,
               way = random.uniform(0, 2 * std::numbers::pi);
  sensor.motion_px = shake * Eigen::Vector2d(std::cos(way), std::sin(way));
  return sensor;
}

}  // namespace

CameraModel cameraModel(rendering::CameraKind kind, vessels::Random& random) {
  CameraModel m;
  m.sensor.exposure_aim = 0.76;
  switch (kind) {
    case rendering::CameraKind::Phone:
      m.focal_per_width = 1291.0 / 1600;
      m.distortion = {{0.045, -0.085, 0.0003, -0.0004, 0.03}};
      m.focal_mm = 4.2;
      m.fnumber = 2.2;
      m.sensor.shot_noise = 1.5e-4;
      m.sensor.read_noise = 0.0008;
      m.sensor.sharpening = 0.45;
      m.model = "Virtual telephone";
      break;
    case rendering::CameraKind::Dslr:  // 35 mm on APS-C
      m.focal_per_width = 52.5 / 36;
      m.distortion = {{-0.085, 0.06, 0.0002, 0.0001, 0}};
      m.focal_mm = 35;
      m.fnumber = 11;
      m.breathing = 0.0015;
      m.drift_px = 0.6;
      m.sensor.shot_noise = 4e-5;
      m.sensor.sharpening = 0.25;
      m.jpeg_quality = 96;
      m.halved_colors = false;
      m.model = "Virtual DSLR";
      break;
    case rendering::CameraKind::Compact:
      m.focal_per_width = 32.0 / 36;
      m.distortion = {{-0.13, 0.09, -0.0005, 0.0006, 0}};
      m.focal_mm = 6.7;
      m.fnumber = 4;
      m.breathing = 0.003;
      m.drift_px = 2;
      m.sensor.shot_noise = 3e-4;
      m.sensor.read_noise = 0.0012;
      m.sensor.vignette = 0.3;
      m.sensor.sharpening = 0.35;
      m.jpeg_quality = 92;
      m.model = "Virtual compact camera";
      break;
  }
  m.focal_per_width *= random.uniform(0.985, 1.015);
  for (std::size_t k = 0; k < 5; ++k) m.distortion[k] *= random.uniform(0.7, 1.2);
  return m;
}

std::vector<FreeShot> walkAround(const rendering::HandHeldOptions& options,
                                 const CameraModel& model, int width, vessels::Random& random) {
  // A telephone of 27 mm sees A4 from 26-33 cm; others stand where they see as much.
  const double scale = width / 1600.0, reach = rig::sheetSize(options.sheet).norm() /
                                               rig::sheetSize(rig::SheetSize::A4).norm() *
                                               model.focal_per_width / (1291.0 / 1600);
  int number = 1000 + random.below(8000);
  double time = 0;
  std::vector<FreeShot> shots;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const double start = random.uniform(0, 2 * std::numbers::pi), way = random.chance(0.5) ? 1 : -1;
    for (int i = 0; i < options.photographs; ++i) {
      FreeShot shot;
      shot.name = formatted("IMG_%04d", number++);
      shot.side = side;
      rig::Intrinsics& k = shot.intrinsics;
      k.width = width;
      k.height = width * 3 / 4;
      k.fx = k.fy = model.focal_per_width * width * (1 + bounded(random, model.breathing, 0.012));
      k.cx = 0.5 * (k.width - 1) + bounded(random, model.drift_px, 9) * scale;
      k.cy = 0.5 * (k.height - 1) + bounded(random, model.drift_px, 9) * scale;
      k.distortion = model.distortion;
      const double step = 2 * std::numbers::pi / options.photographs;
      const double azimuth = start + way * step * (i + random.uniform(-0.35, 0.35));
      const double up = elevation(i, random), away = reach * random.uniform(260, 330);
      const Eigen::Vector3d eye =
          away * Eigen::Vector3d(std::cos(up) * std::cos(azimuth), std::cos(up) * std::sin(azimuth),
                                 std::sin(up));
      const Eigen::Vector3d aim(bounded(random, 10, 22), bounded(random, 8, 16), 0);
      shot.camera_from_plate = lookingAt(eye, aim, bounded(random, 3, 7) * kDegree);
      shot.sensor = sensorOfShot(model.sensor, scale, random);
      shot.focus_mm = (shot.camera_from_plate * aim).z() * (1 + bounded(random, 0.02, 0.05));
      shot.time_s = time;
      time += random.uniform(4, 17);
      shots.push_back(std::move(shot));
    }
    number += 1 + random.below(9);  // what went wrong was deleted
    time += random.uniform(120, 600);
  }
  return shots;
}

rendering::Lighting makeLighting(rendering::LightKind kind, vessels::Random& random) {
  rendering::Lighting lighting;
  lighting.ground_mm = 235;  // A3 and what lies beside it
  const double azimuth = random.uniform(0, 2 * std::numbers::pi);
  const double away = azimuth + random.uniform(2, 4);  // the second light's
  rendering::Light& key = lighting.lights[0];
  rendering::Light& fill = lighting.lights[1];
  for (rendering::Light& light : lighting.lights)
    light = rendering::softbox(0, 1, 1000, 100, 100, Eigen::Vector3f::Zero());
  switch (kind) {
    case rendering::LightKind::Window:
      key = rendering::softbox(azimuth, random.uniform(0.5, 0.7), 1100, random.uniform(330, 480),
                               random.uniform(280, 380), tinted(random.uniform(0.5, 0.68), -0.02));
      key.radius = 0.33f;
      fill = rendering::softbox(away, 0.6, 1800, 500, 500, tinted(random.uniform(0.03, 0.1), 0.05));
      fill.radius = 0.28f;
      lighting.sky = tinted(random.uniform(0.16, 0.26), 0.04);
      lighting.shadow_reach = 5;
      break;
    case rendering::LightKind::Lamp:
      key = rendering::softbox(azimuth, random.uniform(0.6, 1.05), random.uniform(420, 620), 24, 24,
                               tinted(0.6, 0.09));
      key.radius = 0.045f;
      key.hard = true;
      fill =
          rendering::softbox(away, 1.1, 1900, 300, 300, tinted(random.uniform(0.05, 0.12), 0.06));
      fill.radius = 0.16f;
      lighting.sky = tinted(random.uniform(0.07, 0.13), 0.05);
      lighting.shadow_reach = 3;
      break;
    case rendering::LightKind::Flash:
      key = rendering::softbox(azimuth, 1.5, 300, 5, 5, tinted(0.5, -0.03));
      key.radius = 0.02f;
      key.hard = true;
      fill = rendering::softbox(away, 1.1, 1900, 300, 300, tinted(random.uniform(0.1, 0.2), 0.08));
      fill.radius = 0.16f;
      lighting.sky = tinted(random.uniform(0.08, 0.14), 0.06);
      break;
    case rendering::LightKind::Overcast:
      key = rendering::softbox(azimuth, 1.1, 4000, 2200, 2200,
                               tinted(random.uniform(0.08, 0.16), -0.03));
      key.radius = 0.5f;
      lighting.sky = tinted(0.5, -0.03);
      lighting.shadow_reach = 4;
      break;
    case rendering::LightKind::Sun:
      key = rendering::softbox(azimuth, random.uniform(0.45, 1.05), 20'000, 93, 93,
                               tinted(random.uniform(0.65, 0.85), 0.04));
      key.radius = 0.0047f;
      key.hard = true;
      lighting.sky = tinted(random.uniform(0.12, 0.2), -0.16);
      break;
  }
  return lighting;
}

rendering::Lighting withFlash(const rendering::Lighting& lighting,
                              const Eigen::Isometry3d& camera_from_plate) {
  const Eigen::Isometry3d plate_from_camera = camera_from_plate.inverse();
  rendering::Lighting out = lighting;
  rendering::Light& flash = out.lights[0];
  flash.centre = plate_from_camera * Eigen::Vector3d(-12, -9, 0);  // beside the lens, above it
  flash.half_u = 5 * plate_from_camera.linear().col(0);
  flash.half_v = 5 * plate_from_camera.linear().col(1);
  return out;
}

}  // namespace ostraka::virtualrig
