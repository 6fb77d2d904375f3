#include "evaluate/model.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "base/median.h"
#include "cloud/nearest.h"
#include "evaluate/surface.h"

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

// The rigid transform that takes `from` to `to` with the least squares (Kabsch 1976).
Eigen::Isometry3d fitRigid(const Points& from, const Points& to) {
  const auto n = static_cast<double>(from.size());
  Eigen::Vector3d mean_from = Eigen::Vector3d::Zero(), mean_to = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    mean_from += from[i] / n;
    mean_to += to[i] / n;
  }
  Eigen::Matrix3d cross = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i)
    cross += (to[i] - mean_to) * (from[i] - mean_from).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d flip = Eigen::Matrix3d::Identity();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) flip(2, 2) = -1;
  Eigen::Isometry3d to_from_from = Eigen::Isometry3d::Identity();
  to_from_from.linear() = svd.matrixU() * flip * svd.matrixV().transpose();
  to_from_from.translation() = mean_to - to_from_from.linear() * mean_from;
  return to_from_from;
}

// 8000 points of the model onto the truth, the farthest 5 % left out, at most 60 rounds
// (metrics.md).
Eigen::Isometry3d alignByIcp(Points points, const Surface& truth, int threads) {
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
  for (int round = 0; round < kRounds; ++round) {
    Points placed;
    for (const Eigen::Vector3d& p : points) placed.push_back(truth_from_model * p);
    const std::vector<SurfacePoint> found = truth.closest(placed, threads);
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
  const auto low = [](const Points& points) {
    Eigen::Vector3d v = points[0];
    for (const Eigen::Vector3d& p : points) v = v.cwiseMin(p);
    return v;
  };
  const auto high = [](const Points& points) {
    Eigen::Vector3d v = points[0];
    for (const Eigen::Vector3d& p : points) v = v.cwiseMax(p);
    return v;
  };
  return ((low(a) - high(b)).array() > gap_mm).any() || ((low(b) - high(a)).array() > gap_mm).any();
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

// The column of each row, -1 for none, with the greatest sum of gains: shortest augmenting paths
// over a square cost matrix (Jonker and Volgenant 1987).
std::vector<int> assign(const Eigen::MatrixXd& gain) {
  const int rows = static_cast<int>(gain.rows()), columns = static_cast<int>(gain.cols());
  const int n = std::max(rows, columns);
  const auto cost = [&](int r, int c) { return r < rows && c < columns ? -gain(r, c) : 0.0; };
  std::vector<double> u(n + 1), v(n + 1);
  std::vector<int> row_of(n + 1, 0), way(n + 1, 0);
  for (int r = 1; r <= n; ++r) {
    row_of[0] = r;
    std::vector<double> least(n + 1, std::numeric_limits<double>::infinity());
    std::vector<bool> used(n + 1, false);
    int at = 0;
    do {
      used[at] = true;
      double delta = std::numeric_limits<double>::infinity();
      int next = 0;
      for (int c = 1; c <= n; ++c) {
        if (used[c]) continue;
        const double reduced = cost(row_of[at] - 1, c - 1) - u[row_of[at]] - v[c];
        if (reduced < least[c]) {
          least[c] = reduced;
          way[c] = at;
        }
        if (least[c] < delta) {
          delta = least[c];
          next = c;
        }
      }
      for (int c = 0; c <= n; ++c) {
        if (used[c]) {
          u[row_of[c]] += delta;
          v[c] -= delta;
        } else {
          least[c] -= delta;
        }
      }
      at = next;
    } while (row_of[at] != 0);
    for (; at != 0; at = way[at]) row_of[at] = row_of[way[at]];
  }
  std::vector<int> column_of(rows, -1);
  for (int c = 1; c <= columns; ++c)
    if (row_of[c] >= 1 && row_of[c] <= rows) column_of[row_of[c] - 1] = c - 1;
  return column_of;
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
  if (model.vertices.empty()) return Error::unusable("The model has no points.");
  progress.report(0, 3);
  const Surface true_surface(truth);
  TriangleMesh placed = model;
  Points samples = samplesOf(placed, options.sample_spacing_mm, 11);
  ModelFigures figures;
  if (options.align == Align::Icp) {
    const Eigen::Isometry3d move = alignByIcp(samples, true_surface, options.threads);
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
  const std::vector<double> d = distances(true_surface.closest(samples, options.threads));
  if (stop.stop_requested()) return Error::cancelled();
  progress.report(2, 3);
  const Points true_samples = samplesOf(truth, options.sample_spacing_mm, 12);
  const std::vector<double> g = distances(Surface(placed).closest(true_samples, options.threads));
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
  Eigen::MatrixXd overlap = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(truth.size()),
                                                  static_cast<Eigen::Index>(models.size()));
  for (std::size_t t = 0; t < truth.size(); ++t) {
    if (truth[t].mesh.triangles.empty())
      return Error::unusable("The true mesh has no faces.", truth[t].name);
    const Points samples = samplesOf(truth[t].mesh, 1.0, 6);
    for (std::size_t m = 0; m < models.size(); ++m)
      overlap(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(m)) =
          overlapOf(model_samples[m], samples);
    if (stop.stop_requested()) return Error::cancelled();
  }
  const std::vector<int> model_of = assign(overlap);
  BatchEvaluation batch;
  std::vector<bool> used(models.size(), false);
  QuietProgress quiet;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    progress.report(static_cast<std::int64_t>(t), static_cast<std::int64_t>(truth.size()));
    SherdFigures sherd;
    sherd.sherd = truth[t].name;
    const int m = model_of[t];
    if (m >= 0 && overlap(static_cast<Eigen::Index>(t), m) > 0.25) {
      used[m] = true;
      sherd.model = models[m].name;
      sherd.overlap = overlap(static_cast<Eigen::Index>(t), m);
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
