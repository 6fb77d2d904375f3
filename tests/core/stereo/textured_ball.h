#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "stereo/stereo.h"

namespace ostraka::stereo {

/// A ball with a rough pattern fixed to it, seen by a ring of cameras; everything about it is
/// known.
struct TexturedBall {
  Eigen::Vector3d centre{3.0, -2.0, 10.0};
  double radius_mm = 10.0;

  /// Sums of waves of 0.9 to 3 mm, 40 to 220.
  static double grey(const Eigen::Vector3d& p) {
    double sum = 0;
    for (int k = 0; k < 9; ++k) {
      const double a = 1.3 * k + 0.4, b = 2.1 * k + 0.9, wave = 2.1 + 0.55 * k;
      sum += std::sin(wave * (p.x() * std::cos(a) + p.y() * std::sin(a) * std::cos(b) +
                              p.z() * std::sin(a) * std::sin(b)) +
                      1.7 * k);
    }
    return std::min(220.0, std::max(40.0, 130.0 + 22.0 * sum));
  }
};

/// Photographs of 200 x 160 pixels, about 0.2 mm each, at 30 and 60 degrees of elevation, or of
/// `finer` times as many along each side; brightness changes from view to view as the light stands
/// still, and the pattern lies by shading_mm towards each stop's cameras.
inline std::vector<View> ballViews(const TexturedBall& ball, int stops, double shading_mm = 0,
                                   double finer = 1) {
  const int width = static_cast<int>(200 * finer), height = static_cast<int>(160 * finer);
  std::vector<View> views;
  for (int stop = 0; stop < stops; ++stop)
    for (const double elevation : {0.52, 1.05}) {
      const double turn = 2 * 3.14159265358979 * stop / stops;
      const Eigen::Vector3d away(std::cos(turn) * std::cos(elevation),
                                 std::sin(turn) * std::cos(elevation), std::sin(elevation));
      const Eigen::Vector3d eye = ball.centre + 200.0 * away;
      View view;
      view.camera.intrinsics = {
          width,       height,      900 * finer, 900 * finer, width / 2.0 - 0.5, height / 2.0 - 0.5,
          {0.02, 0, 0, 0, 0}};
      view.camera.stop = stop;
      view.camera.file = "stop" + std::to_string(stop);
      Eigen::Matrix3d r;
      r.row(2) = -away;
      r.row(0) = (-away).cross(Eigen::Vector3d::UnitZ()).normalized();
      r.row(1) = Eigen::Vector3d(r.row(2)).cross(Eigen::Vector3d(r.row(0)));
      view.camera.camera_from_plate.linear() = r;
      view.camera.camera_from_plate.translation() = -r * eye;
      view.photograph = cv::Mat(height, width, CV_8UC3, cv::Scalar(12, 12, 12));
      view.mask = cv::Mat1b(height, width, std::uint8_t{0});
      const double gain = 0.8 + 0.2 * std::cos(turn);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const Eigen::Vector2d n = view.camera.intrinsics.unproject({x, y});
          const Eigen::Vector3d ray = (r.transpose() * n.homogeneous()).normalized();
          const double b = ray.dot(ball.centre - eye);
          const double d2 = (ball.centre - eye).squaredNorm() - b * b;
          if (d2 >= ball.radius_mm * ball.radius_mm) continue;
          const Eigen::Vector3d p =
              eye + ray * (b - std::sqrt(ball.radius_mm * ball.radius_mm - d2));
          if (p.z() < ball.centre.z()) continue;  // only its upper half is there
          const Eigen::Vector3d lit =
              p - shading_mm * Eigen::Vector3d(std::cos(turn), std::sin(turn), 0);
          const auto grey = static_cast<std::uint8_t>(std::lround(gain * TexturedBall::grey(lit)));
          view.photograph.at<cv::Vec3b>(y, x) = {grey, grey, grey};
          view.mask(y, x) = 255;
        }
      views.push_back(std::move(view));
    }
  return views;
}

}  // namespace ostraka::stereo
