#include "evaluate/model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/median.h"
#include "cloud/nearest.h"
#include "cloud/surface.h"
#include "evaluate/samples.h"
#include "pairing/assignment.h"

namespace ostraka::evaluate {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Points samplesOf(const TriangleMesh& mesh, double spacing_mm, std::uint64_t seed) {
  if (!mesh.triangles.empty()) return areaSamples(mesh, spacing_mm, seed).points;
  Points points;
  for (const Eigen::Vector3f& v : mesh.vertices) points.push_back(v.cast<double>());
  return points;
}

std::vector<double> distances(const std::vector<SurfacePoint>& found) {
  std::vector<double> d;
  for (const SurfacePoint& point : found) d.push_back(point.distance_mm);
  return d;
}

bool hasArea(const TriangleMesh& mesh) {
  return std::ranges::any_of(mesh.triangles, [&](const std::array<int, 3>& t) {
    const Eigen::Vector3f& a = mesh.vertices[t[0]];
    return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).squaredNorm() > 0;
  });
}

// The rigid transform that takes `from` to `to` with the least squares.
Eigen::Isometry3d fitRigid(const Points& from, const Points& to) {
  const auto matrix = [](const Points& points) {
    return Eigen::Map<const Eigen::Matrix3Xd>(points[0].data(), 3,
                                              static_cast<Eigen::Index>(points.size()));
  };
  return Eigen::Isometry3d(Eigen::umeyama(matrix(from), matrix(to), false));
}

// 8000 points of the model onto the truth, the farthest 5 % left out, at most 60 rounds
// (metrics.md).
Eigen::Isometry3d alignByIcp(Points points, const Surface& truth, int threads,
                             const std::stop_token& stop) {
  constexpr std::size_t kPoints = 8000;
  constexpr int kRounds = 60;
  if (points.size() > kPoints) {
    std::mt19937_64 random(3);
    for (std::size_t i = 0; i < kPoints; ++i)
      std::swap(points[i], points[i + random() % (points.size() - i)]);
    points.resize(kPoints);
  }
  Eigen::Isometry3d truth_from_model = Eigen::Isometry3d::Identity();
  double last = 1e9;
  for (int round = 0; round < kRounds && !stop.stop_requested(); ++round) {
    Points placed;
    for (const Eigen::Vector3d& p : points) placed.push_back(truth_from_model * p);
    const std::vector<SurfacePoint> found = truth.closest(placed, threads, stop);
    const double limit = quantileOf(distances(found), 0.95);
    Points from, to;
    double squared = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].distance_mm > limit) continue;
      from.push_back(placed[i]);
      to.push_back(found[i].point);
      squared += found[i].distance_mm * found[i].distance_mm;
    }
    truth_from_model = fitRigid(from, to) * truth_from_model;
    const double rms = std::sqrt(squared / static_cast<double>(from.size()));
    if (last - rms < 1e-5) break;
    last = rms;
  }
  return truth_from_model;
}

bool boxesApart(const Points& a, const Points& b, double gap_mm) {
  const auto boxOf = [](const Points& points) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& p : points) box.extend(p);
    return box;
  };
  const Eigen::AlignedBox3d box = boxOf(a);
  const Eigen::Vector3d gap = Eigen::Vector3d::Constant(gap_mm);
  return !Eigen::AlignedBox3d(box.min() - gap, box.max() + gap).intersects(boxOf(b));
}

KdTree treeOf(const Points& points) {
  std::vector<Eigen::Vector3f> copy;
  for (const Eigen::Vector3d& p : points) copy.push_back(p.cast<float>());
  return KdTree(copy);
}

double shareWithin(const Points& points, const KdTree& tree, float limit_mm) {
  const auto near = std::count_if(points.begin(), points.end(), [&](const Eigen::Vector3d& p) {
    return tree.nearest(p.cast<float>(), limit_mm).index >= 0;
  });
  return static_cast<double>(near) / static_cast<double>(points.size());
}

double overlapOf(const Points& a, const Points& b) {
  if (a.empty() || b.empty() || boxesApart(a, b, 3)) return 0;
  return 0.5 * shareWithin(a, treeOf(b), 1.5f) + 0.5 * shareWithin(b, treeOf(a), 1.5f);
}

void fillMeans(BatchEvaluation& batch) {
  double n = 0, completeness = 0;
  for (const SherdFigures& sherd : batch.sherds) {
    if (!sherd.model) continue;
    n += 1;
    batch.accuracy_mm += sherd.figures.accuracy_mm;
    batch.mean_mm += sherd.figures.mean_mm;
    batch.sd_mm += sherd.figures.sd_mm;
    completeness += sherd.figures.completeness_percent;
  }
  batch.missing = static_cast<int>(static_cast<double>(batch.sherds.size()) - n);
  if (!batch.sherds.empty())
    batch.completeness_missing_as_zero_percent =
        completeness / static_cast<double>(batch.sherds.size());
  if (n == 0) return;
  batch.accuracy_mm /= n;
  batch.mean_mm /= n;
  batch.sd_mm /= n;
  batch.completeness_percent = completeness / n;
  batch.goals_met = batch.accuracy_mm <= 0.20 && batch.mean_mm <= 0.09 &&
                    batch.completeness_missing_as_zero_percent >= 95;
}

}  // namespace

Result<ModelFigures> compareModel(const TriangleMesh& model, const TriangleMesh& truth,
                                  const ModelOptions& options, Progress& progress,
                                  std::stop_token stop) {
  if (truth.triangles.empty()) return Error::unusable("The true mesh has no faces.");
  if (!hasArea(truth)) return Error::unusable("The true mesh has no area.");
  if (model.vertices.empty()) return Error::unusable("The model has no points.");
  progress.report(0, 3);
  const Surface true_surface(truth);
  TriangleMesh placed = model;
  Points samples = samplesOf(placed, options.sample_spacing_mm, 11);
  ModelFigures figures;
  if (options.align == Align::Icp) {
    const Eigen::Isometry3d move = alignByIcp(samples, true_surface, options.threads, stop);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : samples) middle += p / static_cast<double>(samples.size());
    figures.aligned_by_mm = (move * middle - middle).norm();
    figures.aligned_by_deg =
        std::acos(std::clamp((move.linear().trace() - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
    placed = transformed(placed, move);
    for (Eigen::Vector3d& p : samples) p = move * p;
  }
  if (stop.stop_requested()) return Error::cancelled();
  progress.report(1, 3);
  const std::vector<double> d = distances(true_surface.closest(samples, options.threads, stop));
  if (stop.stop_requested()) return Error::cancelled();
  progress.report(2, 3);
  const Points true_samples = samplesOf(truth, options.sample_spacing_mm, 12);
  const std::vector<double> g =
      distances(Surface(placed).closest(true_samples, options.threads, stop));
  if (stop.stop_requested()) return Error::cancelled();
  progress.report(3, 3);
  double sum = 0, squared = 0;
  for (const double x : d) {
    sum += x;
    squared += x * x;
    figures.max_mm = std::max(figures.max_mm, x);
  }
  const auto n = static_cast<double>(d.size());
  figures.mean_mm = sum / n;
  figures.rms_mm = std::sqrt(squared / n);
  figures.sd_mm = std::sqrt(std::max(0.0, squared / n - figures.mean_mm * figures.mean_mm));
  figures.accuracy_mm = quantileOf(d, 0.9);
  figures.truth_to_model_p90_mm = quantileOf(g, 0.9);
  const auto near = std::count_if(g.begin(), g.end(),
                                  [&](double x) { return x <= options.completeness_within_mm; });
  figures.completeness_percent = 100 * static_cast<double>(near) / static_cast<double>(g.size());
  figures.model_samples = d.size();
  figures.truth_samples = g.size();
  figures.faces = model.triangles.size();
  return figures;
}

Result<BatchEvaluation> evaluateBatch(const std::vector<NamedMesh>& models,
                                      const std::vector<NamedMesh>& truth,
                                      const ModelOptions& options, Progress& progress,
                                      std::stop_token stop) {
  std::vector<Points> model_samples;
  for (const NamedMesh& model : models) model_samples.push_back(samplesOf(model.mesh, 1.0, 5));
  std::vector<pairing::Evidence> overlaps;  // a truth is the front, a model the back
  for (std::size_t t = 0; t < truth.size(); ++t) {
    if (truth[t].mesh.triangles.empty())
      return Error::unusable("The true mesh has no faces.", truth[t].name);
    const Points samples = samplesOf(truth[t].mesh, 1.0, 6);
    for (std::size_t m = 0; m < models.size(); ++m)
      overlaps.push_back({.front = static_cast<int>(t),
                          .back = static_cast<int>(m),
                          .log_likelihood = overlapOf(model_samples[m], samples)});
    if (stop.stop_requested()) return Error::cancelled();
  }
  const Result<pairing::Assignment> assignment = pairing::assignPairs(
      overlaps, static_cast<int>(truth.size()), static_cast<int>(models.size()), {});
  if (!assignment) return assignment.error();
  std::vector<int> model_of(truth.size(), -1);
  for (const pairing::Decision& pair : assignment->pairs) model_of[pair.front] = pair.back;
  BatchEvaluation batch;
  std::vector<bool> used(models.size(), false);
  QuietProgress quiet;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    progress.report(static_cast<std::int64_t>(t), static_cast<std::int64_t>(truth.size()));
    SherdFigures sherd;
    sherd.sherd = truth[t].name;
    const int m = model_of[t];
    const double overlap = m < 0 ? 0 : overlaps[t * models.size() + m].log_likelihood;
    if (overlap > 0.25) {
      used[m] = true;
      sherd.model = models[m].name;
      sherd.overlap = overlap;
      const Result<ModelFigures> figures =
          compareModel(models[m].mesh, truth[t].mesh, options, quiet, stop);
      if (!figures) return figures.error();
      sherd.figures = *figures;
    }
    batch.sherds.push_back(std::move(sherd));
  }
  progress.report(static_cast<std::int64_t>(truth.size()), static_cast<std::int64_t>(truth.size()));
  for (std::size_t m = 0; m < models.size(); ++m)
    if (!used[m]) batch.superfluous.push_back(models[m].name);
  fillMeans(batch);
  return batch;
}

}  // namespace ostraka::evaluate
