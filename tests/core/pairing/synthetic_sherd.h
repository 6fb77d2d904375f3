#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "scan/scan.h"

namespace ostraka::test {

/// A flat slab with an outline r(phi) = size (1 + waves), seen from above and from below.
struct SlabSherd {
  double size_mm = 18, thickness_mm = 6;
  std::vector<double> waves, phases;

  explicit SlabSherd(unsigned seed, double size = 18) : size_mm(size) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(-1, 1);
    for (int k = 2; k < 9; ++k) {
      waves.push_back(0.25 * share(random) / k);
      phases.push_back(std::numbers::pi * share(random));
    }
  }

  double radius(double phi) const {
    double r = 1;
    for (std::size_t k = 0; k < waves.size(); ++k) {
      r += waves[k] * std::cos((static_cast<double>(k) + 2) * phi + phases[k]);
    }
    return size_mm * r;
  }

  Eigen::Vector2d at(double phi) const {
    return radius(phi) * Eigen::Vector2d(std::cos(phi), std::sin(phi));
  }

  std::vector<Eigen::Vector2d> outline(int n) const {
    std::vector<Eigen::Vector2d> line;
    for (int i = 0; i < n; ++i) line.push_back(at(2 * std::numbers::pi * i / n));
    return line;
  }

  /// One face (side +1 above, -1 below) and the whole wall, in the sherd's own frame.
  PointCloud seenFrom(int side) const {
    PointCloud cloud;
    const auto add = [&](double x, double y, double z, const Eigen::Vector3d& normal) {
      cloud.points.push_back(Eigen::Vector3d(x, y, z).cast<float>());
      cloud.normals.push_back(normal.cast<float>());
    };
    const double step = 0.5, reach = 2 * size_mm;
    for (double x = -reach; x < reach; x += step) {
      for (double y = -reach; y < reach; y += step) {
        if (std::hypot(x, y) < radius(std::atan2(y, x))) {
          add(x, y, side * thickness_mm / 2, Eigen::Vector3d(0, 0, side));
        }
      }
    }
    const int around = static_cast<int>(2 * std::numbers::pi * size_mm / step);
    for (int i = 0; i < around; ++i) {
      const double phi = 2 * std::numbers::pi * i / around;
      const Eigen::Vector2d p = at(phi), along = at(phi + 1e-4) - at(phi - 1e-4);
      const Eigen::Vector3d normal = Eigen::Vector3d(along.y(), -along.x(), 0).normalized();
      for (double z = -thickness_mm / 2; z <= thickness_mm / 2; z += step)
        add(p.x(), p.y(), z, normal);
    }
    return cloud;
  }
};

/// A sherd laid on the plate: its scan, and the pose that put it there.
struct LaidScan {
  scan::Scan scan;
  Eigen::Isometry3d plate_from_sherd;
};

inline LaidScan laid(const SlabSherd& sherd, int side, double turn_rad, double x_mm, double y_mm) {
  LaidScan out;
  out.plate_from_sherd = Eigen::Translation3d(x_mm, y_mm, sherd.thickness_mm / 2) *
                         Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ());
  if (side < 0) {
    out.plate_from_sherd =
        out.plate_from_sherd * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
  }
  out.scan.cloud = transformed(sherd.seenFrom(side), out.plate_from_sherd);
  return out;
}

}  // namespace ostraka::test
