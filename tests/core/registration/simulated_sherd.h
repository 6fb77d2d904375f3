#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "scan/scan.h"

namespace ostraka::registration {

/// A flat sherd, 5 mm thick, about 40 mm wide, with an oblique rough broken edge, as two scans. It
/// lies on the plate z = 0 in both; `truth` takes the back's plate frame to the front's.
struct SimulatedSherd {
  scan::Scan front, back;
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
};

struct SimulatedSherdOptions {
  unsigned seed = 1;  ///< of noise; the shape depends on `shape` alone
  double shape = 0;   ///< turns the phases of the relief: another break of the same outline
  double relief = 1;  ///< 0: a smooth round disc
  double noise_mm = 0.03;
  double hidden_mm = 1.2;  ///< the lowest part of the wall is not seen
};

inline double outlineRadius(double phi, double z, double shape, double relief) {
  return 20 * (1 + relief * (0.15 * std::cos(2 * phi) + 0.08 * std::sin(3 * phi) +
                             0.03 * std::cos(5 * phi))) +
         relief * (0.25 * z * std::sin(phi) + 0.25 * std::sin(23 * phi + 3 * shape + 0.4 * z) +
                   0.2 * std::cos(41 * phi + 0.9 * z - 5 * shape));
}

inline SimulatedSherd simulatedSherd(const SimulatedSherdOptions& options) {
  constexpr double kThick = 5, kStep = 0.4, kPi = 3.14159265358979323846;
  std::mt19937 random(options.seed);
  const auto noise = [&] {  // near enough to normal, the same on every machine
    double sum = 0;
    for (int k = 0; k < 12; ++k) sum += static_cast<double>(random()) / 4294967296.0;
    return options.noise_mm * (sum - 6);
  };
  SimulatedSherd sherd;
  sherd.front.id = "f";
  sherd.back.id = "b";
  sherd.truth.translate(Eigen::Vector3d(12, -7, kThick));
  sherd.truth.rotate(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()));
  sherd.truth.rotate(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
  const Eigen::Isometry3d back_from_front = sherd.truth.inverse();
  const auto add = [&](scan::Scan& scan, Eigen::Vector3d p, const Eigen::Vector3d& n) {
    p += noise() * n;
    const bool is_back = &scan == &sherd.back;
    scan.cloud.points.push_back((is_back ? back_from_front * p : p).cast<float>());
    scan.cloud.normals.push_back(
        (is_back ? Eigen::Vector3d(back_from_front.linear() * n) : n).cast<float>());
  };
  for (double x = -30; x <= 30; x += kStep)
    for (double y = -30; y <= 30; y += kStep) {
      const double phi = std::atan2(y, x), r = std::hypot(x, y);
      if (r < outlineRadius(phi, kThick, options.shape, options.relief))
        add(sherd.front, {x, y, kThick}, Eigen::Vector3d::UnitZ());
      if (r < outlineRadius(phi, 0, options.shape, options.relief))
        add(sherd.back, {x, y, 0}, -Eigen::Vector3d::UnitZ());
    }
  const auto wall = [&](double phi, double z) {
    const double r = outlineRadius(phi, z, options.shape, options.relief);
    return Eigen::Vector3d(r * std::cos(phi), r * std::sin(phi), z);
  };
  for (double z = 0; z <= kThick; z += kStep)
    for (double phi = 0; phi < 2 * kPi; phi += kStep / 21) {
      const Eigen::Vector3d p = wall(phi, z);
      const Eigen::Vector3d n =
          (wall(phi + 1e-4, z) - p).cross(wall(phi, z + 1e-4) - p).normalized();
      if (z > options.hidden_mm) add(sherd.front, p, n);
      if (z < kThick - options.hidden_mm) add(sherd.back, p, n);
    }
  return sherd;
}

/// RMS displacement of the back's points between two poses, as metrics.md has it.
inline double rms_mm(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                     const scan::Scan& back) {
  double sum = 0;
  for (const Eigen::Vector3f& p : back.cloud.points)
    sum += (a * p.cast<double>() - b * p.cast<double>()).squaredNorm();
  return std::sqrt(sum / static_cast<double>(back.cloud.size()));
}

/// The truth moved by mm and turned by rad about the sherd's middle.
inline Eigen::Isometry3d startOff(const SimulatedSherd& sherd, double mm, double rad) {
  Eigen::Isometry3d change = Eigen::Isometry3d::Identity();
  change.translate(Eigen::Vector3d(mm, -0.5 * mm, 0.7 * mm));
  change.rotate(Eigen::AngleAxisd(rad, Eigen::Vector3d(1, 0.5, 1).normalized()));
  return change * sherd.truth;
}

}  // namespace ostraka::registration
