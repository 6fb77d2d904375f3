#include "stereo/photometric_cost.h"

#include <algorithm>

namespace ostraka::stereo {
namespace {

constexpr float kOutsideCost = 1.2F;  // a source whose mask the window leaves: worse than chance

}  // namespace

/// The dissimilarity in each active source that can see the plane.
PhotometricCost::SourceCosts PhotometricCost::bySource(const Plane& plane) const {
  SourceCosts found;
  const float along = plane.normal.dot(ray_);
  if (along > -kGrazing * ray_.norm()) return found;
  const Eigen::Vector3f x = plane.depth * ray_;
  // derivative of the plane's point by the pixel's coordinates
  const Eigen::Vector3f xu =
      plane.depth / frame_.fx * (Eigen::Vector3f::UnitX() - ray_ * (plane.normal.x() / along));
  const Eigen::Vector3f xv =
      plane.depth / frame_.fy * (Eigen::Vector3f::UnitY() - ray_ * (plane.normal.y() / along));
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if ((active_ >> k & 1U) == 0) continue;
    const Link& link = links_[k];
    const Frame& other = *frames_[static_cast<std::size_t>(link.source)];
    const Eigen::Vector3f p = link.rotation * x + link.translation;
    if (p.z() <= 0) continue;
    // the source must see the plane's outer face, too
    const Eigen::Vector3f n = link.rotation * plane.normal;
    const float facing = n.dot(p);
    if (facing > 0 || facing * facing < kGrazing * kGrazing * p.squaredNorm()) continue;
    const Eigen::Vector2f centre = other.project(p);
    if (!other.holds(centre)) continue;
    const Eigen::Vector3f pu = link.rotation * xu, pv = link.rotation * xv;
    const float sx = other.fx / p.z(), sy = other.fy / p.z();
    const float tx = p.x() / p.z(), ty = p.y() / p.z();
    const AffineMap map{centre.x(),
                        centre.y(),
                        sx * (pu.x() - tx * pu.z()),
                        sx * (pv.x() - tx * pv.z()),
                        sy * (pu.y() - ty * pu.z()),
                        sy * (pv.y() - ty * pv.z())};
    const float d = dissimilarity(window_, other, map);
    const auto place = static_cast<std::size_t>(found.count++);
    found.costs[place] = d < 0 ? kOutsideCost : d;
    found.sources[place] = static_cast<int>(k);
  }
  return found;
}

float PhotometricCost::cost(const Plane& plane) const {
  auto [count, costs, sources] = bySource(plane);
  if (count == 0) return kNoMatch;
  const int best = std::min(count, options_.best_sources);
  std::partial_sort(costs.begin(), costs.begin() + best, costs.begin() + count);
  float sum = 0;
  for (int k = 0; k < best; ++k) sum += costs[static_cast<std::size_t>(k)];
  // a source that is not there counts as one by chance
  return (sum + static_cast<float>(options_.best_sources - best)) /
         static_cast<float>(options_.best_sources);
}

std::uint32_t PhotometricCost::bestSources(const Plane& plane, int most) const {
  auto [count, costs, sources] = bySource(plane);
  if (count < most) return ~0U;  // the plane is seen by few: leave all of them their say
  std::uint32_t chosen = 0;
  for (int taken = 0; taken < most; ++taken) {
    const auto best = static_cast<std::size_t>(
        std::min_element(costs.begin(), costs.begin() + count) - costs.begin());
    chosen |= 1U << static_cast<unsigned>(sources[best]);
    costs[best] = 2 * kNoMatch;
  }
  return chosen;
}

}  // namespace ostraka::stereo
