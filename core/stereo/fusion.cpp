#include "stereo/fusion.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "base/parallel.h"

namespace ostraka::stereo {
namespace {

/// Of the best incidence among the views that agree: within it two views count as equal, so that no
/// gap opens where the best view changes.
constexpr float kNearlyBest = 0.96F;
constexpr float kMinIncidence = 0.15F;
/// Views agree where their surfaces lie this near, in pixels' widths on the object.
constexpr float kSurfacesAgree_px = 1.2F;
constexpr float kNormalsAgree_cos = 0.6F;
constexpr float kMostCost = 0.7F;

struct Opinion {
  bool looks = false;   // the view has a surface at this place
  bool behind = false;  // it sees through the point
  float offset_mm = 0;  // of its surface along the point's normal
  float weight = 0;
  Eigen::Vector3f normal;
};

float tangentOf(float incidence) {
  return std::sqrt(std::max(0.0F, 1 - incidence * incidence)) / std::max(incidence, kMinIncidence);
}

Opinion ask(const Frame& frame, const PlaneMap& map, const Eigen::Vector3f& p_plate,
            const Eigen::Vector3f& n_plate, float tolerance_mm) {
  Opinion opinion;
  const Eigen::Vector3f p = frame.toCamera(p_plate);
  if (p.z() <= 0) return opinion;
  const Eigen::Vector2f pixel = frame.project(p);
  if (!frame.holds(pixel)) return opinion;
  const int x = static_cast<int>(pixel.x() + 0.5F), y = static_cast<int>(pixel.y() + 0.5F);
  const int index = frame.index(y, x);
  if (index < 0) return opinion;
  const auto k = static_cast<std::size_t>(index);
  if (map.depth[k] <= 0 || map.cost[k] > kMostCost) return opinion;
  const Eigen::Vector3f n = frame.rotation * n_plate;
  const Eigen::Vector3f surface =
      map.depth[k] * frame.ray(static_cast<float>(x), static_cast<float>(y));
  const Eigen::Vector3f& m = map.normal[k];
  const float along = m.dot(p);
  if (along >= 0) return opinion;
  // where the view's own plane meets the ray through the point
  const Eigen::Vector3f met = p * (m.dot(surface) / along);
  opinion.offset_mm = (met - p).dot(n);
  opinion.behind = opinion.offset_mm < -3 * tolerance_mm;
  const float incidence = -n.dot(p) / p.norm();
  opinion.looks = std::abs(opinion.offset_mm) < tolerance_mm && incidence > kMinIncidence &&
                  m.dot(n) > kNormalsAgree_cos;
  opinion.weight = incidence * incidence * std::max(0.02F, 1.0F - map.cost[k]);
  opinion.normal = frame.rotation.transpose() * m;
  return opinion;
}

void fuseView(std::span<const Frame* const> frames, std::span<const PlaneMap> maps,
              std::size_t view, const FusionOptions& options, std::vector<SurfacePoint>& points,
              Agreement& agreement) {
  const Frame& frame = *frames[view];
  const PlaneMap& map = maps[view];
  for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
    const Eigen::Vector3f in_camera =
        map.depth[k] *
        frame.ray(static_cast<float>(frame.pixels[k].x), static_cast<float>(frame.pixels[k].y));
    const Eigen::Vector3f p = frame.rotation.transpose() * (in_camera - frame.translation);
    const bool counted = options.tile == nullptr || options.tile->owns(p);
    agreement.matched += counted ? 1 : 0;
    if (map.depth[k] <= 0 || map.cost[k] > kMostCost) continue;
    const Eigen::Vector3f n = frame.rotation.transpose() * map.normal[k];
    const float footprint = map.depth[k] / frame.fx;
    const float tolerance = kSurfacesAgree_px * footprint;
    const float own_incidence = n.dot((frame.centre - p).normalized());
    const float own_weight = own_incidence * own_incidence * std::max(0.02F, 1.0F - map.cost[k]);
    const float own_tangent = tangentOf(own_incidence);
    float tangents = own_weight * own_tangent, squares = tangents * own_tangent, products = 0;
    float weights = own_weight, offsets = 0;
    Eigen::Vector3f normals = own_weight * n;
    int agreeing = 1, against = 0;
    bool best = own_incidence > kMinIncidence;
    for (std::size_t j = 0; best && j < frames.size(); ++j) {
      if (j == view) continue;
      const float incidence = n.dot((frames[j]->centre - p).normalized());
      if (incidence < kMinIncidence) continue;
      const Opinion o = ask(*frames[j], maps[j], p, n, tolerance);
      against += o.behind ? 1 : 0;
      if (!o.looks) continue;
      ++agreeing;
      if (own_incidence < kNearlyBest * incidence) best = false;
      weights += o.weight;
      offsets += o.weight * o.offset_mm;
      const float tangent = tangentOf(incidence);
      tangents += o.weight * tangent;
      squares += o.weight * tangent * tangent;
      products += o.weight * tangent * o.offset_mm;
      normals += o.weight * o.normal;
    }
    if (agreeing < options.min_agreeing_views || against >= agreeing) continue;
    agreement.confirmed += counted ? 1 : 0;
    if (!best) continue;
    SurfacePoint point;
    point.slant = {tangents / weights, products - offsets * tangents / weights,
                   squares - tangents * tangents / weights};
    point.position = p + n * (offsets / weights);
    point.normal = normals.normalized();
    point.footprint_mm = footprint;
    point.confidence = std::clamp(
        (1.0F - map.cost[k]) * std::min(1.0F, 0.25F * static_cast<float>(agreeing)), 0.0F, 1.0F);
    point.view = static_cast<int>(view);
    point.agreeing = agreeing;
    points.push_back(point);
  }
}

}  // namespace

float neighbourhood_mm(const std::vector<SurfacePoint>& points, float wanted_mm) {
  constexpr float kMost_px = 32;
  std::vector<float> footprints;
  footprints.reserve(points.size());
  for (const SurfacePoint& point : points) footprints.push_back(point.footprint_mm);
  return std::min(wanted_mm, kMost_px * medianOf(footprints));
}

std::vector<SurfacePoint> fusePlanes(std::span<const Frame* const> frames,
                                     std::span<const PlaneMap> maps, const FusionOptions& options,
                                     Agreement& agreement) {
  std::vector<std::vector<SurfacePoint>> parts(frames.size());
  std::vector<Agreement> counts(frames.size());
  parallelFor(frames.size(), options.threads, [&](std::size_t view) {
    fuseView(frames, maps, view, options, parts[view], counts[view]);
  });
  agreement = {};
  for (const Agreement& count : counts) {
    agreement.matched += count.matched;
    agreement.confirmed += count.confirmed;
  }
  std::vector<SurfacePoint> points;
  for (const auto& part : parts) points.insert(points.end(), part.begin(), part.end());
  return points;
}

}  // namespace ostraka::stereo
