#pragma once
#include <cmath>
#include <vector>

#include "block.h"
#include "texture/light.h"

namespace ostraka::texture {

/// More light from one side than from the other, 1 for what faces up, the same in each channel.
inline Light lamp() {
  Light light;
  Light::Terms terms;
  terms << 1, 0.2, -0.1, 0.3, 0.05, -0.06, 0.04, 0.08, -0.05;
  light.coefficients.colwise() = terms / terms.dot(Light::terms(Eigen::Vector3d::UnitZ()));
  return light;
}

/// Where a plate has turned by `turn` below the lights; the back lies on the front's place, turned
/// over about the x axis.
inline Eigen::Matrix3d lightFromMesh(batch::Side side, double turn) {
  const Eigen::AngleAxisd over(side == batch::Side::Back ? M_PI : 0, Eigen::Vector3d::UnitX());
  return (Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * over).toRotationMatrix();
}

/// The half axes of an ellipsoid about the origin, mm.
inline const Eigen::Vector3d kAxes(20, 15, 8);

inline Eigen::Vector3d normalAt(const Eigen::Vector3d& p) {
  return p.cwiseQuotient(kAxes.cwiseProduct(kAxes)).normalized();
}

inline TriangleMesh ellipsoid() {
  return block({2, 2, 2}, 0.2f, [](const Eigen::Vector3f& p) -> Eigen::Vector3f {
    return (p - Eigen::Vector3f::UnitZ()).normalized().cwiseProduct(kAxes.cast<float>());
  });
}

/// A grey that sends back two fifths of the light, by a camera at rest at this height over a plate
/// that has turned.
inline View photographed(batch::Side side, double turn, double elevation, const Light& light,
                         int number) {
  const Eigen::Matrix3d light_from_mesh = lightFromMesh(side, turn);
  const Eigen::Vector3d from = light_from_mesh.transpose() * 180 *
                               Eigen::Vector3d(std::cos(elevation), 0, std::sin(elevation));
  const rig::PosedImage image = lookingAt(from, {0, 0, 0});
  cv::Mat3b photograph(600, 800, cv::Vec3b(20, 20, 20));
  cv::Mat1b mask = cv::Mat1b::zeros(600, 800);
  const Eigen::Isometry3d mesh_from_camera = image.camera_from_plate.inverse();
  const Eigen::Vector3d origin = from.cwiseQuotient(kAxes);
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 800; ++x) {
      const Eigen::Vector2d ray = image.intrinsics.unproject({x, y});
      const Eigen::Vector3d along =
          mesh_from_camera.linear() * Eigen::Vector3d(ray.x(), ray.y(), 1);
      // |origin + t direction| = 1 where the axes are taken to 1.
      const Eigen::Vector3d direction = along.cwiseQuotient(kAxes);
      const double a = direction.squaredNorm(), b = origin.dot(direction);
      const double inside = b * b - a * (origin.squaredNorm() - 1);
      if (inside <= 0) continue;
      const Eigen::Vector3d p = from + (-b - std::sqrt(inside)) / a * along;
      const double level = 0.4 * light.on(light_from_mesh * normalAt(p))[0];
      mask(y, x) = 255;
      photograph(y, x) = cv::Vec3b::all(
          cv::saturate_cast<uchar>(255 * (1.055 * std::pow(level, 1 / 2.4) - 0.055)));
    }
  std::vector<Eigen::Vector3f> corners;
  for (int k = 0; k < 8; ++k)
    corners.emplace_back(k & 1 ? 20 : -20, k & 2 ? 15 : -15, k & 4 ? 8 : -8);
  View view = *cutOut(photograph, mask, image, Eigen::Isometry3d::Identity(), corners);
  view.light_from_mesh = light_from_mesh;
  view.photograph = number;
  return view;
}

/// Six stops of both sides, two cameras.
inline std::vector<View> turnedBelow(const Light& light) {
  std::vector<View> views;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
    for (const double elevation : {0.5, 1.0})
      for (int stop = 0; stop < 6; ++stop)
        views.push_back(
            photographed(side, stop * M_PI / 3, elevation, light, static_cast<int>(views.size())));
  return views;
}

}  // namespace ostraka::texture
