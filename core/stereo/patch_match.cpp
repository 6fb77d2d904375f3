#include "stereo/patch_match.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ostraka::stereo {
namespace {

constexpr int kMaxSources = 16;
constexpr float kNoMatch = 2.0F;      // cost of a plane that no source supports
constexpr float kOutsideCost = 1.2F;  // a source whose mask the window leaves: worse than chance
constexpr float kGrazing = 0.08F;     // cosine, 85 degrees: beyond it a window is a line

/// Uniform numbers in [0, 1) from a seed alone: SplitMix64 (Steele et al., OOPSLA 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  float operator()() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return static_cast<float>((z ^ (z >> 31U)) >> 40U) * 0x1p-24F;
  }
  Eigen::Vector3f inCube() {
    const float a = (*this)(), b = (*this)(), c = (*this)();
    return {2 * a - 1, 2 * b - 1, 2 * c - 1};
  }

 private:
  std::uint64_t state_;
};

std::uint64_t mixed(std::uint64_t seed, std::uint64_t a, std::uint64_t b) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL * (a + 1) + 0xc2b2ae3d27d4eb4fULL * (b + 1);
  z = (z ^ (z >> 29U)) * 0xbf58476d1ce4e5b9ULL;
  return z ^ (z >> 32U);
}

struct Plane {
  float depth;
  Eigen::Vector3f normal;
};

/// Everything that judging planes at one pixel needs.
class Judge {
 public:
  Judge(std::span<const Frame* const> frames, int view, std::span<const Link> links,
        const SweepOptions& options)
      : frames_(frames),
        frame_(*frames[static_cast<std::size_t>(view)]),
        links_(links),
        options_(options) {}

  bool moveTo(const cv::Point& pixel) {
    ray_ = frame_.ray(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
    return cutWindow(frame_, pixel.x, pixel.y, options_.window, window_);
  }
  const Eigen::Vector3f& ray() const { return ray_; }
  /// Sources as bits; those not in the set are left aside from now on.
  void use(std::uint32_t sources) { active_ = sources; }
  float cost(const Plane& plane) const;
  /// The `most` sources that fit this plane best.
  std::uint32_t bestSources(const Plane& plane, int most) const;

 private:
  std::span<const Frame* const> frames_;
  const Frame& frame_;
  std::span<const Link> links_;
  const SweepOptions& options_;
  Eigen::Vector3f ray_;
  Window window_;
  std::uint32_t active_ = ~0U;

  int judge(const Plane& plane, std::array<float, kMaxSources>& costs,
            std::array<int, kMaxSources>& sources) const;
};

/// The dissimilarity in each active source that can see the plane; returns their number.
int Judge::judge(const Plane& plane, std::array<float, kMaxSources>& costs,
                 std::array<int, kMaxSources>& sources) const {
  const float along = plane.normal.dot(ray_);
  if (along > -kGrazing * ray_.norm()) return 0;
  const Eigen::Vector3f x = plane.depth * ray_;
  // derivative of the plane's point by the pixel's coordinates
  const Eigen::Vector3f xu =
      plane.depth / frame_.fx * (Eigen::Vector3f::UnitX() - ray_ * (plane.normal.x() / along));
  const Eigen::Vector3f xv =
      plane.depth / frame_.fy * (Eigen::Vector3f::UnitY() - ray_ * (plane.normal.y() / along));
  int count = 0;
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
    const auto place = static_cast<std::size_t>(count++);
    costs[place] = d < 0 ? kOutsideCost : d;
    sources[place] = static_cast<int>(k);
  }
  return count;
}

float Judge::cost(const Plane& plane) const {
  std::array<float, kMaxSources> costs;
  std::array<int, kMaxSources> sources;
  const int count = judge(plane, costs, sources);
  if (count == 0) return kNoMatch;
  const int best = std::min(count, options_.best_sources);
  std::partial_sort(costs.begin(), costs.begin() + best, costs.begin() + count);
  float sum = 0;
  for (int k = 0; k < best; ++k) sum += costs[static_cast<std::size_t>(k)];
  // a source that is not there counts as one by chance
  return (sum + static_cast<float>(options_.best_sources - best)) /
         static_cast<float>(options_.best_sources);
}

std::uint32_t Judge::bestSources(const Plane& plane, int most) const {
  std::array<float, kMaxSources> costs;
  std::array<int, kMaxSources> sources;
  const int count = judge(plane, costs, sources);
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

/// So alike that judging the second again is wasted: a tenth of a pixel, two degrees.
bool alike(const Plane& a, const Plane& b, float unit_mm) {
  return std::abs(a.depth - b.depth) < 0.05F * unit_mm && a.normal.dot(b.normal) > 0.9994F;
}

struct Offset {
  int x, y;
};
/// Of the other colour of the checkerboard, so that a half-sweep reads only what it does not write.
constexpr std::array<Offset, 8> kNeighbours{
    {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-5, 0}, {5, 0}, {0, -5}, {0, 5}}};

/// A neighbour's plane continued to this ray.
bool continued(const Eigen::Vector3f& from_ray, const Plane& from, const Eigen::Vector3f& ray,
               Plane& plane) {
  const float along = from.normal.dot(ray);
  if (along > -kGrazing * ray.norm()) return false;
  plane = {from.depth * from.normal.dot(from_ray) / along, from.normal};
  return true;
}

}  // namespace

std::vector<std::vector<Link>> chooseSources(std::span<const Frame* const> frames,
                                             const Eigen::Vector3f& middle,
                                             const DenseOptions& options) {
  constexpr double ideal_rad = 0.35, spread_rad = 0.3;  // 20 degrees: depth against foreshortening
  std::vector<std::vector<Link>> all(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Eigen::Vector3f own = (frames[i]->centre - middle).normalized();
    struct Candidate {
      double score;
      std::size_t frame;
      Eigen::Vector3f direction;
    };
    std::vector<Candidate> candidates;
    for (std::size_t j = 0; j < frames.size(); ++j) {
      const Eigen::Vector3f other = (frames[j]->centre - middle).normalized();
      const double angle = std::acos(std::clamp(static_cast<double>(own.dot(other)), -1.0, 1.0));
      if (j == i || angle < options.min_source_angle_rad || angle > options.max_source_angle_rad)
        continue;
      const double off = (angle - ideal_rad) / spread_rad;
      candidates.push_back({std::exp(-0.5 * off * off), j, other});
    }
    while (!candidates.empty() && static_cast<int>(all[i].size()) < options.max_sources) {
      const auto best =
          std::max_element(candidates.begin(), candidates.end(),
                           [](const auto& a, const auto& b) { return a.score < b.score; });
      const Frame& source = *frames[best->frame];
      Link link;
      link.source = static_cast<int>(best->frame);
      link.rotation = source.rotation * frames[i]->rotation.transpose();
      link.translation = source.translation - link.rotation * frames[i]->translation;
      all[i].push_back(link);
      const Eigen::Vector3f taken = best->direction;
      candidates.erase(best);
      for (Candidate& c : candidates)  // two sources in the same place say the same thing
        c.score *=
            1.0 -
            0.5 * std::exp(-0.5 *
                           std::pow(std::acos(std::min(1.0F, taken.dot(c.direction))) / 0.15, 2));
    }
  }
  return all;
}

void startPlanes(const Frame& frame, std::span<const DepthRange> ranges, std::uint64_t seed,
                 PlaneMap& planes) {
  planes.resize(frame.pixels.size());
  const Eigen::Vector3f up = frame.rotation.col(2);
  for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
    Random random(mixed(seed, k, 0));
    const Eigen::Vector3f ray =
        frame.ray(static_cast<float>(frame.pixels[k].x), static_cast<float>(frame.pixels[k].y));
    planes.depth[k] = ranges[k].near + random() * (ranges[k].far - ranges[k].near);
    Eigen::Vector3f normal = random() < 0.33F
                                 ? Eigen::Vector3f(up + 0.2F * random.inCube())
                                 : Eigen::Vector3f(-ray.normalized() + random.inCube());
    normal.normalize();
    if (normal.dot(ray) > -kGrazing * ray.norm()) normal = -ray.normalized();
    planes.normal[k] = normal;
  }
}

void refinePlanes(const Frame& coarse, const PlaneMap& coarse_planes, const Frame& frame,
                  PlaneMap& planes) {
  planes.resize(frame.pixels.size());
  for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
    const cv::Point p = frame.pixels[k];
    int found = -1, nearest = 1 << 20;
    for (int v = p.y / 2 - 2; v <= p.y / 2 + 2; ++v)
      for (int u = p.x / 2 - 2; u <= p.x / 2 + 2; ++u) {
        if (u < 0 || v < 0 || u >= coarse.width || v >= coarse.height) continue;
        const int index = coarse.index(v, u);
        const int dx = 4 * u + 1 - 2 * p.x, dy = 4 * v + 1 - 2 * p.y;
        if (index < 0 || dx * dx + dy * dy >= nearest) continue;
        nearest = dx * dx + dy * dy;
        found = index;
      }
    if (found < 0) continue;
    const auto f = static_cast<std::size_t>(found);
    const cv::Point from = coarse.pixels[f];
    const Eigen::Vector3f ray = frame.ray(static_cast<float>(p.x), static_cast<float>(p.y));
    Plane plane;
    if (continued(coarse.ray(static_cast<float>(from.x), static_cast<float>(from.y)),
                  {coarse_planes.depth[f], coarse_planes.normal[f]}, ray, plane)) {
      planes.depth[k] = plane.depth;
      planes.normal[k] = plane.normal;
    }
  }
}

void sweepPlanes(std::span<const Frame* const> frames, int view, std::span<const Link> links,
                 std::span<const DepthRange> ranges, const SweepOptions& options,
                 PlaneMap& planes) {
  const Frame& frame = *frames[static_cast<std::size_t>(view)];
  Judge judge(frames, view, links, options);
  const auto planeAt = [&](std::size_t k) { return Plane{planes.depth[k], planes.normal[k]}; };
  std::vector<std::uint32_t> active(frame.pixels.size(), ~0U);
  for (int half = 0; half < 2 * options.rounds + 1; ++half) {
    // half-sweep 0 only judges what is there already
    const float scale =
        options.first_perturbation * std::pow(0.5F, static_cast<float>((half - 1) / 2));
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
      const cv::Point p = frame.pixels[k];
      if (half > 0 && ((p.x + p.y) & 1) != (half & 1)) continue;
      const DepthRange range = ranges[k];
      if (!judge.moveTo(p)) {
        planes.cost[k] = kNoMatch;
        continue;
      }
      judge.use(active[k]);
      if (half == 0) {
        if (planes.depth[k] > 0) {
          if (options.max_active_sources > 0)
            active[k] = judge.bestSources(planeAt(k), options.max_active_sources);
          planes.cost[k] = judge.cost(planeAt(k));
        }
        continue;
      }
      Plane best = planeAt(k);
      float best_cost = planes.cost[k];
      const auto offer = [&](const Plane& plane) {
        if (plane.depth < range.near || plane.depth > range.far) return;
        if (alike(plane, best, 3.0F * plane.depth / frame.fx)) return;
        const float cost = judge.cost(plane);
        if (cost < best_cost) {
          best_cost = cost;
          best = plane;
        }
      };
      for (const Offset& o : kNeighbours) {
        const int nx = p.x + o.x, ny = p.y + o.y;
        if (nx < 0 || ny < 0 || nx >= frame.width || ny >= frame.height) continue;
        const int index = frame.index(ny, nx);
        if (index < 0) continue;
        const auto n = static_cast<std::size_t>(index);
        if (planes.depth[n] <= 0 || planes.cost[n] >= kNoMatch) continue;
        Plane plane;
        if (continued(frame.ray(static_cast<float>(nx), static_cast<float>(ny)), planeAt(n),
                      judge.ray(), plane))
          offer(plane);
      }
      if (best.depth > 0) {
        Random random(mixed(options.seed, k, static_cast<std::uint64_t>(half)));
        // a pixel's width seen under about 20 degrees: the depth that moves a match by one pixel
        const float unit = 3.0F * best.depth / frame.fx;
        const float far = best.depth + (2 * random() - 1) * scale * unit;
        const Eigen::Vector3f tilted = (best.normal + 0.6F * scale * random.inCube()).normalized();
        offer({far, best.normal});
        offer({best.depth, tilted});
        offer({best.depth + (random() - 0.5F) * scale * unit,
               (best.normal + 0.2F * scale * random.inCube()).normalized()});
        if (best_cost > 0.5F && scale > 0.5F)
          offer({range.near + random() * (range.far - range.near), tilted});
      }
      planes.depth[k] = best.depth;
      planes.normal[k] = best.normal;
      planes.cost[k] = best_cost;
    }
  }
}

}  // namespace ostraka::stereo
