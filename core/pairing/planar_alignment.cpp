#include "pairing/planar_alignment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloud/bounds.h"

namespace ostraka::pairing {
namespace {

constexpr int kTurns = 120;  // 3 degrees: 0.8 mm at the border of a 30 mm sherd, well inside reach

/// 80 %: the data's worst sherds miss a part of the strip over up to a fifth of the outline.
double trimmedRms(std::vector<double> distances) {
  const std::size_t keep = std::max<std::size_t>(1, distances.size() * 4 / 5);
  std::nth_element(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(keep - 1),
                   distances.end());
  double sum = 0;
  for (std::size_t i = 0; i < keep; ++i) sum += distances[i] * distances[i];
  return std::sqrt(sum / static_cast<double>(keep));
}

/// Calls visit for about `samples` equally spaced indices of a line.
template <class Visit>
void eachSample(const std::vector<Eigen::Vector2d>& line, int samples, Visit visit) {
  const double step = std::max(1.0, static_cast<double>(line.size()) / samples);
  for (double at = 0; at < static_cast<double>(line.size()); at += step) {
    visit(line[static_cast<std::size_t>(at)]);
  }
}

struct NormalEquations {
  Eigen::Matrix4d h = Eigen::Matrix4d::Zero();
  Eigen::Vector4d g = Eigen::Vector4d::Zero();

  /// moved: the back's point in the front's plane; rows: turn, two shifts, logarithm of scale.
  void add(const Eigen::Vector2d& moved, const Eigen::Vector2d& pivot, const Eigen::Vector2d& n,
           double residual, double weight) {
    const Eigen::Vector2d arm = moved - pivot;
    const Eigen::Vector4d j(n.y() * arm.x() - n.x() * arm.y(), n.x(), n.y(), n.dot(arm));
    h += weight * j * j.transpose();
    g += weight * residual * j;
  }
};

}  // namespace

OutlineField::OutlineField(std::vector<Eigen::Vector2d> closed) : line_(std::move(closed)) {
  const std::size_t n = line_.size();
  double twice_area = 0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &p = line_[i], &q = line_[(i + 1) % n];
    const double cross = p.x() * q.y() - p.y() * q.x();
    twice_area += cross;
    moment += cross * (p + q);
    perimeter_ += (q - p).norm();
  }
  centroid_ = moment / (3 * twice_area);
  const std::size_t reach = std::max<std::size_t>(1, n / 200);
  normals_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d t = line_[(i + reach) % n] - line_[(i + n - reach) % n];
    normals_[i] = Eigen::Vector2d(t.y(), -t.x()).normalized();
  }
  fillRaster();
}

void OutlineField::fillRaster() {
  // 1/300 of the length: half a millimetre for a 50 mm sherd, a few neighbours to walk from there.
  cell_mm_ = perimeter_ / 300;
  auto [low, high] = boundsOf(line_);
  const double margin = 12 * cell_mm_;
  low_ = low.array() - margin;
  high.array() += margin;
  columns_ = static_cast<int>((high.x() - low_.x()) / cell_mm_) + 1;
  rows_ = static_cast<int>((high.y() - low_.y()) / cell_mm_) + 1;
  nearest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1);
  const auto at = [&](int r, int c) -> int& {
    return nearest_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                    static_cast<std::size_t>(c)];
  };
  for (std::size_t i = 0; i < line_.size(); ++i) {
    nearest_[cellOf(line_[i])] = static_cast<int>(i);
  }
  const auto offer = [&](int r, int c, int from_r, int from_c) {
    if (from_r < 0 || from_c < 0 || from_r >= rows_ || from_c >= columns_) return;
    const int index = at(from_r, from_c);
    if (index < 0) return;
    const Eigen::Vector2d centre = low_ + cell_mm_ * Eigen::Vector2d(c + 0.5, r + 0.5);
    const auto d = [&](int k) {
      return (line_[static_cast<std::size_t>(k)] - centre).squaredNorm();
    };
    if (at(r, c) < 0 || d(index) < d(at(r, c))) at(r, c) = index;
  };
  // Danielsson's sweeps: down and up, each with a pass to the right and to the left.
  for (int r = 0; r < rows_; ++r) {
    for (int c = 0; c < columns_; ++c) {
      for (int k = -1; k <= 1; ++k) offer(r, c, r - 1, c + k);
      offer(r, c, r, c - 1);
    }
    for (int c = columns_ - 1; c >= 0; --c) offer(r, c, r, c + 1);
  }
  for (int r = rows_ - 1; r >= 0; --r) {
    for (int c = columns_ - 1; c >= 0; --c) {
      for (int k = -1; k <= 1; ++k) offer(r, c, r + 1, c + k);
      offer(r, c, r, c + 1);
    }
    for (int c = 0; c < columns_; ++c) offer(r, c, r, c - 1);
  }
}

std::size_t OutlineField::cellOf(const Eigen::Vector2d& q) const {
  const double x = std::clamp((q.x() - low_.x()) / cell_mm_, 0.0, columns_ - 1.0);
  const double y = std::clamp((q.y() - low_.y()) / cell_mm_, 0.0, rows_ - 1.0);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(x);
}

double OutlineField::roughDistance(const Eigen::Vector2d& q) const {
  return (line_[static_cast<std::size_t>(nearest_[cellOf(q)])] - q).norm();
}

OutlineField::Foot OutlineField::nearest(const Eigen::Vector2d& q) const {
  const std::size_t n = line_.size();
  std::size_t best = static_cast<std::size_t>(nearest_[cellOf(q)]);
  double best_d = (line_[best] - q).squaredNorm();
  for (const std::size_t step : {std::size_t{1}, n - 1}) {
    for (std::size_t i = (best + step) % n; i != best; i = (i + step) % n) {
      const double d = (line_[i] - q).squaredNorm();
      if (d >= best_d) break;
      best = i, best_d = d;
    }
  }
  Foot foot;
  double foot_d = 1e300;
  for (const std::size_t i : {(best + n - 1) % n, best}) {
    const Eigen::Vector2d along = line_[(i + 1) % n] - line_[i];
    const double share =
        std::clamp((q - line_[i]).dot(along) / std::max(1e-18, along.squaredNorm()), 0.0, 1.0);
    const Eigen::Vector2d point = line_[i] + share * along;
    const double d = (q - point).squaredNorm();
    if (d < foot_d) {
      foot_d = d;
      foot = {point, normals_[best], 0, static_cast<int>(i)};
    }
  }
  foot.distance = std::sqrt(foot_d);
  return foot;
}

PlanarFit alignOutlines(const OutlineField& front, const OutlineField& back,
                        const PlanarPose& start, const PlanarAlignOptions& options) {
  PlanarFit fit{start, 0, {}};
  PlanarPose& pose = fit.pose;
  const int unknowns = options.scale == FreeScale::Yes ? 4 : 3;
  for (int round = 0; round < options.rounds; ++round) {
    const double share = options.rounds > 1 ? static_cast<double>(round) / (options.rounds - 1) : 1;
    const double reach =
        options.first_reach_mm *
        std::pow(options.last_reach_mm / options.first_reach_mm, std::min(1.0, 1.5 * share));
    const Eigen::Rotation2Dd turn(pose.angle_rad);
    const Eigen::Vector2d pivot = pose.apply(back.centroid());
    NormalEquations sum;
    const auto weigh = [&](double distance) {
      const double u = distance / reach;
      return 1 / ((1 + u * u) * (1 + u * u));
    };
    eachSample(back.line(), options.samples, [&](const Eigen::Vector2d& p) {
      const Eigen::Vector2d moved = pose.apply(p);
      const OutlineField::Foot foot = front.nearest(moved);
      sum.add(moved, pivot, foot.normal, foot.normal.dot(moved - foot.point), weigh(foot.distance));
    });
    eachSample(front.line(), options.samples, [&](const Eigen::Vector2d& p) {
      const OutlineField::Foot foot = back.nearest(pose.unapply(p));
      const Eigen::Vector2d normal = turn * foot.normal, moved = pose.apply(foot.point);
      sum.add(moved, pivot, normal, normal.dot(moved - p), weigh(pose.scale * foot.distance));
    });
    // A little damping: a circle's turn is not determined.
    sum.h.diagonal() += 1e-6 * Eigen::Vector4d(1, 1, 1, 1) * (1 + sum.h.diagonal().maxCoeff());
    Eigen::Vector4d step = Eigen::Vector4d::Zero();
    step.head(unknowns) =
        -sum.h.topLeftCorner(unknowns, unknowns).ldlt().solve(sum.g.head(unknowns));
    pose.angle_rad += step(0);
    pose.scale *= std::exp(step(3));
    pose.shift += pivot + step.segment<2>(1) - pose.apply(back.centroid());
  }
  eachSample(back.line(), options.samples, [&](const Eigen::Vector2d& p) {
    fit.distances_mm.push_back(front.nearest(pose.apply(p)).distance);
  });
  eachSample(front.line(), options.samples, [&](const Eigen::Vector2d& p) {
    fit.distances_mm.push_back(pose.scale * back.nearest(pose.unapply(p)).distance);
  });
  fit.rms_mm = trimmedRms(fit.distances_mm);
  return fit;
}

std::vector<PlanarPose> bestTurns(const OutlineField& front, const OutlineField& back, double scale,
                                  int max_count) {
  constexpr int kSamples = 100;
  const double cap_mm =
      front.perimeter() / 25;  // 6 mm for a 50 mm sherd: beyond, one is as bad as all
  std::vector<PlanarPose> poses(kTurns);
  std::vector<double> costs(kTurns, 0);
  for (std::size_t k = 0; k < kTurns; ++k) {
    PlanarPose& pose = poses[k];
    pose.angle_rad = 2 * std::numbers::pi * static_cast<double>(k) / kTurns;
    pose.scale = scale;
    pose.shift = front.centroid() - pose.apply(back.centroid());
    const Eigen::Matrix2d linear = scale * Eigen::Rotation2Dd(pose.angle_rad).toRotationMatrix();
    eachSample(back.line(), kSamples, [&](const Eigen::Vector2d& p) {
      const double d = std::min(cap_mm, front.roughDistance(linear * p + pose.shift));
      costs[k] += d * d;
    });
  }
  std::vector<std::size_t> valleys;
  for (std::size_t k = 0; k < kTurns; ++k) {
    const double before = costs[(k + kTurns - 1) % kTurns], after = costs[(k + 1) % kTurns];
    if (costs[k] <= before && costs[k] < after) valleys.push_back(k);
  }
  std::stable_sort(valleys.begin(), valleys.end(),
                   [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  if (valleys.size() > static_cast<std::size_t>(max_count))
    valleys.resize(static_cast<std::size_t>(max_count));
  std::vector<PlanarPose> best;
  for (const std::size_t k : valleys) best.push_back(poses[k]);
  return best;
}

}  // namespace ostraka::pairing
