#include "evaluate/cloud.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include "base/median.h"
#include "base/parallel.h"
#include "cloud/nearest.h"
#include "evaluate/samples.h"

namespace ostraka::evaluate {
namespace {

constexpr double kSampleSpacing_mm = 0.15;
constexpr std::size_t kMostPoints = 200'000;
constexpr float kOutlier_mm = 2.0f, kCovered_mm = 0.25f;
constexpr double kCoverAbove_mm = 1.0;  // below it no camera sees the strip

// At most `most` of n indices, drawn at random.
std::vector<std::size_t> someOf(std::size_t n, std::size_t most, std::uint64_t seed) {
  std::vector<std::size_t> indices(n);
  for (std::size_t i = 0; i < n; ++i) indices[i] = i;
  if (n <= most) return indices;
  std::mt19937_64 random(seed);
  for (std::size_t i = 0; i < most; ++i) std::swap(indices[i], indices[i + random() % (n - i)]);
  indices.resize(most);
  return indices;
}

std::vector<int> nearestWithin(const KdTree& tree, const std::vector<Eigen::Vector3f>& queries,
                               float limit_mm, int threads) {
  std::vector<int> found(queries.size());
  parallelForRanges(queries.size(), 1024, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = tree.nearest(queries[i], limit_mm).index;
  });
  return found;
}

struct Truth {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3d> normals, exact;
};

Truth truthSamples(std::span<const TriangleMesh> meshes) {
  Truth truth;
  for (const TriangleMesh& mesh : meshes) {
    const SurfaceSamples samples =
        areaSamples(mesh, kSampleSpacing_mm, 3, std::numeric_limits<std::uint32_t>::max());
    for (const Eigen::Vector3d& p : samples.points) truth.points.push_back(p.cast<float>());
    truth.exact.insert(truth.exact.end(), samples.points.begin(), samples.points.end());
    truth.normals.insert(truth.normals.end(), samples.normals.begin(), samples.normals.end());
  }
  return truth;
}

struct Measured {
  double signed_mm, angle_deg, normal_z;
};

bool isFlat(double normal_z) {
  return normal_z > 0.8;
}
bool isStrip(double normal_z) {
  return std::abs(normal_z) < 0.5;
}

PartFigures figuresOf(const std::vector<Measured>& all,
                      const std::function<bool(double)>& belongs) {
  std::vector<double> distance, angle;
  for (const Measured& m : all) {
    if (!belongs(m.normal_z)) continue;
    distance.push_back(m.signed_mm);
    angle.push_back(m.angle_deg);
  }
  PartFigures part;
  part.points = distance.size();
  if (distance.empty()) return part;
  part.bias_mm = quantileOf(distance, 0.5);
  part.normal_deg = quantileOf(angle, 0.5);
  std::vector<double> deviation, size;
  for (const double x : distance) {
    deviation.push_back(std::abs(x - *part.bias_mm));
    size.push_back(std::abs(x));
  }
  part.sd_mm = 1.4826 * quantileOf(deviation, 0.5);
  part.within_90_mm = quantileOf(size, 0.9);
  return part;
}

void fillCover(const Truth& truth, const PointCloud& cloud, int threads, CloudFigures& figures) {
  const std::vector<std::size_t> few = someOf(truth.points.size(), kMostPoints, 5);
  std::vector<Eigen::Vector3f> queries;
  for (const std::size_t i : few) queries.push_back(truth.points[i]);
  const std::vector<int> found = nearestWithin(KdTree(cloud.points), queries, kCovered_mm, threads);
  double flat = 0, flat_covered = 0, strip = 0, strip_covered = 0;
  for (std::size_t k = 0; k < few.size(); ++k) {
    const double z = truth.normals[few[k]].z();
    const bool covered = found[k] >= 0;
    if (isFlat(z)) {
      flat += 1;
      flat_covered += covered;
    } else if (isStrip(z) && truth.exact[few[k]].z() > kCoverAbove_mm) {
      strip += 1;
      strip_covered += covered;
    }
  }
  if (flat > 0) figures.flat.covered_percent = 100 * flat_covered / flat;
  if (strip > 0) figures.strip.covered_percent = 100 * strip_covered / strip;
}

bool goalsMet(const PartFigures& flat, const PartFigures& strip) {
  return flat.points > 0 && strip.points > 0 && std::abs(*strip.bias_mm) <= 0.05 &&
         *strip.sd_mm <= 0.12 && *strip.normal_deg <= 20 &&
         strip.covered_percent.value_or(0) >= 70 && std::abs(*flat.bias_mm) <= 0.02 &&
         *flat.within_90_mm <= 0.12;
}

}  // namespace

Result<CloudFigures> evaluateCloud(const PointCloud& cloud,
                                   std::span<const TriangleMesh> truth_meshes,
                                   const CloudOptions& options) {
  if (cloud.empty()) return Error::unusable("The cloud has no points.");
  if (!cloud.hasNormals()) return Error::unusable("The cloud has no normals.");
  for (const TriangleMesh& mesh : truth_meshes)
    if (mesh.triangles.empty()) return Error::unusable("The true mesh has no faces.");
  const Truth truth = truthSamples(truth_meshes);
  const std::vector<std::size_t> kept = someOf(cloud.size(), kMostPoints, 4);
  std::vector<Eigen::Vector3f> queries;
  for (const std::size_t i : kept) queries.push_back(cloud.points[i]);
  const std::vector<int> found =
      nearestWithin(KdTree(truth.points), queries, kOutlier_mm, options.threads);
  CloudFigures figures;
  figures.points = kept.size();
  std::vector<Measured> measured;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    if (found[k] < 0) continue;
    const Eigen::Vector3d& normal = truth.normals[found[k]];
    const Eigen::Vector3d own = cloud.normals[kept[k]].cast<double>();
    const double cosine = own.dot(normal) / std::max(own.norm(), 1e-12);
    measured.push_back({(queries[k].cast<double>() - truth.exact[found[k]]).dot(normal),
                        std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi,
                        normal.z()});
  }
  if (measured.empty())
    return Error::unusable(
        "No point lies within 2 mm of the truth; is it the right frame, unit and side?");
  figures.outlier_percent =
      100 * static_cast<double>(kept.size() - measured.size()) / static_cast<double>(kept.size());
  figures.flat = figuresOf(measured, isFlat);
  figures.strip = figuresOf(measured, isStrip);
  fillCover(truth, cloud, options.threads, figures);
  figures.goals_met = goalsMet(figures.flat, figures.strip);
  return figures;
}

}  // namespace ostraka::evaluate
