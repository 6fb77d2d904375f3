#include "stereo/patch_match.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ostraka::stereo {
namespace {

constexpr std::size_t kPollEvery = 2000;  // pixels, some 20 ms

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

/// The best plane so far at one pixel.
struct Hypothesis {
  const PhotometricCost& photometric;
  DepthRange range;
  Plane best;
  float best_cost;
  /// A pixel's width seen under about 20 degrees, of the depth: what moves a match by one pixel.
  float relative_unit;

  void test(const Plane& plane) {
    if (plane.depth < range.near || plane.depth > range.far) return;
    if (alike(plane, best, relative_unit * plane.depth)) return;
    const float cost = photometric.cost(plane);
    if (cost >= best_cost) return;
    best_cost = cost;
    best = plane;
  }
};

void testNeighbours(const Frame& frame, const PlaneMap& planes, const cv::Point& p,
                    Hypothesis& hypothesis) {
  for (const Offset& o : kNeighbours) {
    const int x = p.x + o.x, y = p.y + o.y;
    if (x < 0 || y < 0 || x >= frame.width || y >= frame.height) continue;
    const int index = frame.index(y, x);
    if (index < 0) continue;
    const auto n = static_cast<std::size_t>(index);
    if (planes.depth[n] <= 0 || planes.cost[n] >= kNoMatch) continue;
    Plane plane;
    if (continued(frame.ray(static_cast<float>(x), static_cast<float>(y)),
                  {planes.depth[n], planes.normal[n]}, hypothesis.photometric.ray(), plane))
      hypothesis.test(plane);
  }
}

void testPerturbed(Random random, float scale, Hypothesis& hypothesis) {
  if (hypothesis.best.depth <= 0) return;
  const float unit = scale * hypothesis.relative_unit * hypothesis.best.depth;
  const float moved = hypothesis.best.depth + (2 * random() - 1) * unit;
  const Eigen::Vector3f tilted =
      (hypothesis.best.normal + 0.6F * scale * random.inCube()).normalized();
  hypothesis.test({moved, hypothesis.best.normal});
  hypothesis.test({hypothesis.best.depth, tilted});
  hypothesis.test({hypothesis.best.depth + (random() - 0.5F) * unit,
                   (hypothesis.best.normal + 0.2F * scale * random.inCube()).normalized()});
  if (hypothesis.best_cost < 0.5F || scale < 0.5F) return;
  const DepthRange& range = hypothesis.range;  // still lost: anywhere
  hypothesis.test({range.near + random() * (range.far - range.near), tilted});
}

}  // namespace

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

void propagate(std::span<const Frame* const> frames, int view, std::span<const Link> links,
               std::span<const DepthRange> ranges, const PropagationOptions& options,
               PlaneMap& planes, const std::stop_token& stop) {
  const Frame& frame = *frames[static_cast<std::size_t>(view)];
  PhotometricCost photometric(frames, view, links, options.cost);
  std::vector<std::uint32_t> active(frame.pixels.size(), ~0U);
  for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
    if (k % kPollEvery == 0 && stop.stop_requested()) return;
    planes.cost[k] = kNoMatch;
    if (planes.depth[k] <= 0 || !photometric.moveTo(frame.pixels[k])) continue;
    const Plane plane{planes.depth[k], planes.normal[k]};
    photometric.use(~0U);
    if (options.max_active_sources > 0)
      active[k] = photometric.bestSources(plane, options.max_active_sources);
    photometric.use(active[k]);
    planes.cost[k] = photometric.cost(plane);
  }
  for (int half = 0; half < 2 * options.rounds; ++half) {
    const float scale = options.first_perturbation * std::pow(0.5F, static_cast<float>(half / 2));
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
      if (k % kPollEvery == 0 && stop.stop_requested()) return;
      const cv::Point p = frame.pixels[k];
      if (((p.x + p.y + half) & 1) == 0 || !photometric.moveTo(p)) continue;
      photometric.use(active[k]);
      Hypothesis hypothesis{photometric,
                            ranges[k],
                            {planes.depth[k], planes.normal[k]},
                            planes.cost[k],
                            3.0F / frame.fx};
      testNeighbours(frame, planes, p, hypothesis);
      testPerturbed(Random(mixed(options.seed, k, static_cast<std::uint64_t>(half + 1))), scale,
                    hypothesis);
      planes.depth[k] = hypothesis.best.depth;
      planes.normal[k] = hypothesis.best.normal;
      planes.cost[k] = hypothesis.best_cost;
    }
  }
}

}  // namespace ostraka::stereo
