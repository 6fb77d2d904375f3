#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "stereo/fusion.h"
#include "stereo/patch_match.h"
#include "textured_ball.h"

namespace ostraka::stereo {

/// The pixels inside the frame's mask become those to work on.
inline void workOnMask(Frame& frame) {
  frame.pixels.clear();
  frame.index = cv::Mat1i(frame.height, frame.width, -1);
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      if (frame.coverage(y, x) < 0.5F) continue;
      frame.index(y, x) = static_cast<int>(frame.pixels.size());
      frame.pixels.emplace_back(x, y);
    }
}

/// The plane that touches the ball where the pixel's ray meets it first; depth 0: it passes by.
inline Plane touching(const TexturedBall& ball, const Frame& frame, const cv::Point& pixel) {
  const Eigen::Vector3d centre = frame.toCamera(ball.centre.cast<float>()).cast<double>();
  const Eigen::Vector3d ray =
      frame.ray(static_cast<float>(pixel.x), static_cast<float>(pixel.y)).cast<double>();
  const double along = ray.dot(centre), squared = ray.squaredNorm();
  const double under =
      along * along - squared * (centre.squaredNorm() - ball.radius_mm * ball.radius_mm);
  if (under <= 0) return {0, Eigen::Vector3f(0, 0, -1)};
  const double depth = (along - std::sqrt(under)) / squared;
  return {static_cast<float>(depth), ((depth * ray - centre) / ball.radius_mm).cast<float>()};
}

/// Frames of the ball, and for each the planes that are true.
struct BallFrames {
  explicit BallFrames(int stops) {
    for (const View& view : ballViews(ball, stops)) {
      frames.push_back(std::move(buildPyramid(view, 1).front()));
      workOnMask(frames.back());
    }
    for (const Frame& frame : frames) {
      all.push_back(&frame);
      PlaneMap& map = truth.emplace_back();
      map.resize(frame.pixels.size());
      for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
        const Plane plane = touching(ball, frame, frame.pixels[k]);
        map.depth[k] = plane.depth;
        map.normal[k] = plane.normal;
        map.cost[k] = 0.1F;
      }
    }
  }
  BallFrames(const BallFrames&) = delete;
  BallFrames& operator=(const BallFrames&) = delete;
  /// Outwards, mm.
  double off(const Eigen::Vector3f& p_plate) const {
    return (p_plate.cast<double>() - ball.centre).norm() - ball.radius_mm;
  }

  TexturedBall ball;
  std::vector<Frame> frames;
  std::vector<const Frame*> all;
  std::vector<PlaneMap> truth;
};

}  // namespace ostraka::stereo
