#include "stereo/same_light.h"

#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "base/parallel.h"
#include "cloud/nearest.h"
#include "stereo/photometric_cost.h"

namespace ostraka::stereo {
namespace {

constexpr std::size_t kPointsATask = 1000;
constexpr std::size_t kEvery = 3;         // one point of three is measured, all are moved
constexpr float kLeastIncidence = 0.35F;  // cosine, 70 degrees
constexpr float kAgree_px = 1.5F;         // a frame sees the point when its own plane is this near
constexpr float kMaxCost = 0.8F;          // more is no match
constexpr float kLeastCurvature = 1e-3F;  // of the cost: less has no depth
constexpr int kSteps = 2;                 // to each side of the point
constexpr float kStep_px = 0.4F;

/// How far a point lies from where frames of one light see it, along its normal.
struct Correction {
  float mm = 0;
  float weight = 0;  ///< the curvature of the cost; 0 = not known
};

struct Sight {
  cv::Point pixel;
  float incidence = 0;  ///< cosine; 0 = does not see the point
};

Sight sightOf(const Frame& frame, const PlaneMap& map, const SurfacePoint& point) {
  Sight sight;
  const float incidence = point.normal.dot((frame.centre - point.position).normalized());
  if (incidence < kLeastIncidence) return sight;
  const Eigen::Vector3f p = frame.toCamera(point.position);
  if (p.z() <= 0) return sight;
  const Eigen::Vector2f at = frame.project(p);
  if (!frame.holds(at)) return sight;
  sight.pixel = {static_cast<int>(at.x() + 0.5F), static_cast<int>(at.y() + 0.5F)};
  const int index = frame.index(sight.pixel.y, sight.pixel.x);
  if (index < 0) return sight;
  const auto k = static_cast<std::size_t>(index);
  if (map.depth[k] <= 0 || map.cost[k] >= kMaxCost) return sight;
  const Eigen::Vector3f surface = map.depth[k] * frame.ray(static_cast<float>(sight.pixel.x),
                                                           static_cast<float>(sight.pixel.y));
  const float off = (surface - p).dot(frame.rotation * point.normal);
  if (std::abs(off) < kAgree_px * point.footprint_mm) sight.incidence = incidence;
  return sight;
}

using Costs = std::array<double, 2 * kSteps + 1>;

/// The cost of the point's plane moved along its normal, between two frames.
std::optional<Costs> costsBetween(std::span<const Frame* const> frames, std::size_t from,
                                  std::size_t to, const cv::Point& pixel,
                                  const SurfacePoint& point) {
  const Frame& frame = *frames[from];
  const Link link = linkBetween(frame, *frames[to], static_cast<int>(to));
  CostOptions one;
  one.best_sources = 1;
  PhotometricCost photometric(frames, static_cast<int>(from), {&link, 1}, one);
  if (!photometric.moveTo(pixel)) return std::nullopt;
  const Eigen::Vector3f normal = frame.rotation * point.normal;
  const float along = normal.dot(photometric.ray());
  const Eigen::Vector3f p = frame.toCamera(point.position);
  Costs costs;
  for (int k = -kSteps; k <= kSteps; ++k) {
    const float moved = static_cast<float>(k) * kStep_px * point.footprint_mm;
    const float cost = photometric.cost({(normal.dot(p) + moved) / along, normal});
    if (cost >= kMaxCost) return std::nullopt;
    costs[static_cast<std::size_t>(k + kSteps)] = cost;
  }
  return costs;
}

Correction measured(std::span<const Frame* const> frames, std::span<const PlaneMap> maps,
                    const SurfacePoint& point, std::vector<Sight>& sights) {
  sights.resize(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) sights[i] = sightOf(*frames[i], maps[i], point);
  Costs sums{};
  double weights = 0;
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t j = 0; j < frames.size(); ++j) {
      // the squarer frame of each pair cuts the window
      if (i == j || sights[j].incidence <= 0 || frames[i]->light != frames[j]->light ||
          std::pair(sights[i].incidence, j) < std::pair(sights[j].incidence, i))
        continue;
      const auto costs = costsBetween(frames, i, j, sights[i].pixel, point);
      if (!costs) continue;
      const double weight = sights[j].incidence;
      for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += weight * (*costs)[k];
      weights += weight;
    }
  if (weights <= 0) return {};
  // The least-squares parabola a x^2 + b x + c through x = -2 ... 2.
  const double a = (2 * sums[0] - sums[1] - 2 * sums[2] - sums[3] + 2 * sums[4]) / 14;
  const double b = (-2 * sums[0] - sums[1] + sums[3] + 2 * sums[4]) / 10;
  if (a <= kLeastCurvature * weights || std::abs(b) > 2 * kSteps * a) return {};
  return {static_cast<float>(-b / (2 * a)) * kStep_px * point.footprint_mm, static_cast<float>(a)};
}

bool lightsDiffer(std::span<const Frame* const> frames) {
  std::set<int> lights;
  for (const Frame* frame : frames) lights.insert(frame->light);
  return lights.size() > 1 && lights.size() < frames.size();
}

}  // namespace

std::vector<SurfacePoint> settledInSameLight(std::span<const Frame* const> frames,
                                             std::span<const PlaneMap> maps,
                                             std::vector<SurfacePoint> points,
                                             const SameLightOptions& options) {
  if (!lightsDiffer(frames)) return points;
  std::vector<Correction> all((points.size() + kEvery - 1) / kEvery);
  parallelForRanges(all.size(), kPointsATask, options.threads,
                    [&](std::size_t begin, std::size_t end) {
                      std::vector<Sight> sights;
                      for (std::size_t i = begin; i < end; ++i)
                        all[i] = measured(frames, maps, points[i * kEvery], sights);
                    });
  std::vector<Correction> known;
  std::vector<Eigen::Vector3f> places, normals;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].weight <= 0) continue;
    known.push_back(all[i]);
    places.push_back(points[i * kEvery].position);
    normals.push_back(points[i * kEvery].normal);
  }
  const KdTree tree(places);
  const float reach_mm = neighbourhood_mm(points, options.reach_mm);
  parallelForRanges(
      points.size(), kPointsATask, options.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
          tree.within(points[i].position, reach_mm, near);
          float sum = 0, weights = 0;
          for (const Neighbour& n : near) {
            const auto k = static_cast<std::size_t>(n.index);
            const float like = normals[k].dot(points[i].normal);
            if (like < 0.5F) continue;  // another face
            const float d2 = n.squared_distance / (reach_mm * reach_mm);
            const float weight = known[k].weight * like * like * like * like * std::exp(-2 * d2);
            sum += weight * known[k].mm;
            weights += weight;
          }
          if (weights > 0) points[i].position += sum / weights * points[i].normal;
        }
      });
  return points;
}

}  // namespace ostraka::stereo
