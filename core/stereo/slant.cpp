#include "stereo/slant.h"

#include <algorithm>

#include "base/parallel.h"
#include "cloud/nearest.h"

namespace ostraka::stereo {
namespace {

constexpr std::size_t kSlantTask = 1000;
constexpr std::size_t kTellers = 5;  // one point of so many tells its neighbourhood
constexpr float kLargest_px = 0.5F;  // factor, in pixels' widths: more is no relief
constexpr float kDoubt = 0.05F;      // share by which the factor is drawn towards 0

}  // namespace

std::vector<SurfacePoint> withoutSlant(std::vector<SurfacePoint> points,
                                       const SlantOptions& options) {
  std::vector<Eigen::Vector3f> places;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < points.size(); i += kTellers)
    if (points[i].slant.variance > 0) {
      places.push_back(points[i].position);
      chosen.push_back(i);
    }
  if (places.empty()) return points;
  const KdTree tree(places);
  const float reach_mm = neighbourhood_mm(points, options.reach_mm);
  std::vector<float> moves(points.size(), 0.0F);  // the points stay until all are known
  parallelForRanges(
      points.size(), kSlantTask, options.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
          const SurfacePoint& point = points[i];
          tree.within(point.position, reach_mm, near);
          float covariance = 0, variance = 0;
          for (const Neighbour& n : near) {
            const SurfacePoint& other = points[chosen[static_cast<std::size_t>(n.index)]];
            const float like = other.normal.dot(point.normal);
            if (like < 0.5F) continue;  // another face
            const float weight = like * like * like * like;
            covariance += weight * other.slant.covariance;
            variance += weight * other.slant.variance;
          }
          if (variance <= 0) continue;
          const float largest = kLargest_px * point.footprint_mm;
          const float factor = covariance / (variance * (1 + kDoubt));
          moves[i] = -std::clamp(factor, -largest, largest) * point.slant.mean;
        }
      });
  for (std::size_t i = 0; i < points.size(); ++i) points[i].position += moves[i] * points[i].normal;
  return points;
}

}  // namespace ostraka::stereo
