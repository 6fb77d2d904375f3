#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "stereo/sources.h"
#include "stereo/window.h"

namespace ostraka::stereo {

constexpr float kNoMatch = 2.0F;   ///< cost of a plane that no source supports
constexpr float kGrazing = 0.08F;  ///< cosine, 85 degrees: beyond it a window is a line

struct Plane {
  float depth;             ///< mm along the optical axis, at the pixel
  Eigen::Vector3f normal;  ///< camera frame, unit, towards the camera
};

struct CostOptions {
  int best_sources = 3;  ///< the cost is the mean over this many
};

/// How well planes at one view's pixels agree with the sources.
class PhotometricCost {
 public:
  PhotometricCost(std::span<const Frame* const> frames, int view, std::span<const Link> links,
                  const CostOptions& options)
      : frames_(frames),
        frame_(*frames[static_cast<std::size_t>(view)]),
        links_(links),
        options_(options) {}

  /// False where the pixel's window shows too little of the object.
  bool moveTo(const cv::Point& pixel) {
    ray_ = frame_.ray(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
    return cutWindow(frame_, pixel.x, pixel.y, window_);
  }
  const Eigen::Vector3f& ray() const { return ray_; }
  /// Sources as bits; those not in the set are left aside from now on.
  void use(std::uint32_t sources) { active_ = sources; }
  /// Mean dissimilarity of the best sources, 0..2.
  float cost(const Plane& plane) const;
  /// The `most` sources that fit this plane best.
  std::uint32_t bestSources(const Plane& plane, int most) const;

 private:
  std::span<const Frame* const> frames_;
  const Frame& frame_;
  std::span<const Link> links_;
  CostOptions options_;
  Eigen::Vector3f ray_;
  Window window_;
  std::uint32_t active_ = ~0U;

  struct SourceCosts {
    int count = 0;
    std::array<float, kMaxSources> costs;
    std::array<int, kMaxSources> sources;
  };
  SourceCosts bySource(const Plane& plane) const;
};

}  // namespace ostraka::stereo
