#include "drawing/rim.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "base/median.h"
#include "cloud/nearest.h"
#include "drawing/revolution.h"

namespace ostraka::drawing {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double kLipReach_mm = 3.5;      // of the lip's surface from the edge's points
constexpr double kRoundness = 0.01;       // how far thrown mouths are from a circle, relative sd
constexpr double kCluster_mm = 10;        // over which unevenness of a wall hangs together
constexpr double kCircleWeight = 8;       // of a point of the lip against one of the walls
constexpr double kOffCircle_mm = 0.7;     // where a lip's edge ends and a break begins
constexpr double kRing_mm = 0.6;          // of the lip's profile
constexpr double kTop_mm = 0.35;          // below the highest: what the rim's circle is read from
constexpr double kSmallestMouth_mm = 20;  // findRimArcs takes no smaller circle for a lip

// t quantile for 97.5 % (Cornish-Fisher expansion about the normal's).
double tQuantile(double freedom) {
  const double n = std::max(2.0, freedom);
  return 1.96 + 2.37 / n + 2.82 / (n * n) + 2.56 / (n * n * n);
}

// The lip: surface near the edge's stretch that is none of the faces and looks up.
std::vector<Vector3d> lipOf(const Walls& walls, const RimArc& arc, const Vector3d& up) {
  std::vector<Eigen::Vector3f> edge;
  for (const Vector3d& p : arc.points) edge.push_back(p.cast<float>());
  const KdTree tree(edge);
  // The ends of the stretch lead into breaks: their last millimetres are left out.
  const int last = static_cast<int>(edge.size()) - 1;
  std::vector<Vector3d> lip;
  for (std::size_t i = 0; i < walls.smooth.vertices.size(); ++i) {
    if (walls.smooth.normals[i].dot(up.cast<float>()) < 0.5f) continue;
    const Neighbour n = tree.nearest(walls.smooth.vertices[i], static_cast<float>(kLipReach_mm));
    if (n.index < 2 || n.index > last - 2) continue;
    lip.push_back(walls.smooth.vertices[i].cast<double>());
  }
  return lip;
}

Eigen::Isometry3d frameOf(const Vector3d& axis, const Vector3d& through) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const Vector3d z = axis.normalized();
  const Vector3d x = z.unitOrthogonal();
  frame.linear() << x.transpose(), z.cross(x).transpose(), z.transpose();
  frame.translation() = -frame.linear() * through;
  return frame;
}

class Estimator {
 public:
  Estimator(const Walls& walls, const RimArc& arc) : walls_(walls), arc_(arc) {}

  std::optional<RimEstimate> run() {
    if (walls_.points.size() < 100) return std::nullopt;
    findDirections();
    if (!findBestStart()) return std::nullopt;
    // Once more with the lip as the axis has it.
    lip_ = lipOf(walls_, arc_, best_.axis_from_model.linear().row(2).transpose());
    if (lip_.size() < 20) return std::nullopt;
    best_ = Revolution(gather(1), best_.axis_from_model).solve(60);
    return describe();
  }

 private:
  // chord_: along the lip; up_: from the sherd's middle to the lip, across the chord; out_: away
  // from the axis, at the lip.
  void findDirections() {
    chord_ = (arc_.points.back() - arc_.points.front()).normalized();
    middle_ = arc_.points[arc_.points.size() / 2];
    up_ = middle_ - walls_.centre;
    up_ = (up_ - chord_ * up_.dot(chord_)).normalized();
  }

  std::vector<ProfilePoint> gather(std::size_t stride) const {
    std::vector<ProfilePoint> points;
    for (std::size_t i = 0; i < walls_.points.size(); i += stride)
      points.push_back({walls_.points[i].p, walls_.points[i].face, 3, 1});
    // The lip's ends lead into breaks. Its circle must hold against thousands of wall points.
    for (std::size_t i = 2; i + 2 < arc_.points.size(); ++i)
      points.push_back(
          {arc_.points[i], Revolution::kCircle, 0, kCircleWeight / static_cast<double>(stride)});
    return points;
  }

  bool findBestStart() {
    lip_ = lipOf(walls_, arc_, up_);
    if (lip_.size() < 20) return false;
    const std::size_t stride = std::max<std::size_t>(1, walls_.points.size() / 400);
    double least = std::numeric_limits<double>::max();
    for (const double lean : {-0.5, 0.0, 0.5})
      for (const double side : {1.0, -1.0})
        for (const double radius : {25.0, 60.0, 140.0}) {
          const Vector3d axis = Eigen::AngleAxisd(lean, chord_) * up_;
          const Vector3d inward = side * chord_.cross(axis).normalized();
          const Revolution::Fit fit =
              Revolution(gather(stride), frameOf(axis, middle_ + radius * inward)).solve(12);
          const double reach = (fit.axis_from_model * middle_).head<2>().norm();
          if (fit.cost >= least || reach < 8 || reach > 600) continue;
          least = fit.cost;
          best_ = fit;
        }
    if (least == std::numeric_limits<double>::max()) return false;
    // An axis has no up by itself: the lip is.
    if (best_.axis_from_model.linear().row(2).dot(up_.transpose()) < 0)
      best_.axis_from_model =
          Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()) * best_.axis_from_model;
    best_ = Revolution(gather(1), best_.axis_from_model).solve(40);
    return true;
  }

  // Mean radius and height of the lip's highest points under a frame; `top` picks them.
  struct Rim {
    double radius = 0, height = 0;
  };
  Rim rimUnder(const Eigen::Isometry3d& frame, const std::vector<std::size_t>& top) const {
    Rim rim;
    for (const std::size_t i : top) {
      const Vector3d q = frame * lip_[i];
      rim.radius += q.head<2>().norm() / static_cast<double>(top.size());
      rim.height += q.z() / static_cast<double>(top.size());
    }
    return rim;
  }

  // A lip's surface is turned like the rest of the vessel; a break's is not. Median over rings of
  // the scatter in height.
  double lipScatter(const Eigen::Isometry3d& frame) const {
    std::map<int, std::vector<double>> rings;
    for (const Vector3d& p : lip_) {
      const Vector3d q = frame * p;
      rings[static_cast<int>(std::floor(q.head<2>().norm() / kRing_mm))].push_back(q.z());
    }
    std::vector<double> scatter;
    for (const auto& [ring, heights] : rings) {
      if (heights.size() < 8) continue;
      const double middle = medianOf(std::vector(heights));
      std::vector<double> off;
      for (const double z : heights) off.push_back(std::abs(z - middle));
      scatter.push_back(1.4826 * medianOf(std::move(off)));
    }
    return scatter.empty() ? kLipReach_mm : medianOf(std::move(scatter));
  }

  // Per degree of the turn the highest lip point and those just below it.
  std::vector<std::size_t> topOf(const Eigen::Isometry3d& frame, double radius) const {
    std::map<int, double> highest;
    std::vector<int> bins;
    for (const Vector3d& p : lip_) {
      const Vector3d q = frame * p;
      bins.push_back(static_cast<int>(std::floor(std::atan2(q.y(), q.x()) * radius / 2)));
      const auto [at, fresh] = highest.try_emplace(bins.back(), q.z());
      if (!fresh) at->second = std::max(at->second, q.z());
    }
    std::vector<std::size_t> top;
    for (std::size_t i = 0; i < lip_.size(); ++i)
      if ((frame * lip_[i]).z() > highest[bins[i]] - kTop_mm) top.push_back(i);
    return top;
  }

  // Variance of the parameters from sums over patches of residuals that hang together.
  Eigen::Matrix4d covariance(const std::vector<ProfilePoint>& points, double radius,
                             int& patches_around) const {
    Eigen::Matrix4d h = Eigen::Matrix4d::Zero();
    std::map<std::array<int, 3>, Vector4d> patches;
    std::map<int, int> around;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int k = 0; k < (points[i].profile == Revolution::kCircle ? 2 : 1); ++k) {
        const auto row = 2 * static_cast<Eigen::Index>(i) + k;
        const double r = std::clamp(best_.residuals[row], -0.6, 0.6), w = points[i].weight;
        const Vector4d j = best_.jacobian.row(row).transpose();
        h += w * j * j.transpose();
        const Vector3d q = best_.axis_from_model * points[i].p;
        const int turn =
            static_cast<int>(std::floor(std::atan2(q.y(), q.x()) * radius / kCluster_mm));
        const int height = static_cast<int>(std::floor(q.z() / kCluster_mm));
        ++around[turn];
        patches.try_emplace({points[i].profile + 10 * k, turn, height}, Vector4d::Zero())
            .first->second += w * r * j;
      }
    patches_around = static_cast<int>(around.size());
    Eigen::Matrix4d s = Eigen::Matrix4d::Zero();
    for (const auto& [key, g] : patches) s += g * g.transpose();
    const Eigen::Matrix4d inverse = h.ldlt().solve(Eigen::Matrix4d::Identity());
    const auto n = static_cast<double>(patches.size());
    return inverse * s * inverse * (n / std::max(1.0, n - 4));
  }

  std::optional<RimEstimate> describe() {
    Eigen::Isometry3d frame = best_.axis_from_model;
    double radius = (frame * middle_).head<2>().norm();
    if (!(radius > 5) || best_.jacobian.rows() == 0) return std::nullopt;
    const std::vector<std::size_t> top = topOf(frame, radius);
    const Rim rim = rimUnder(frame, top);
    Vector4d slope;
    const Vector4d steps(1e-3, 1e-3, 0.1, 0.1);
    for (int k = 0; k < 4; ++k) {
      const Vector4d step = steps[k] * Vector4d::Unit(k);
      slope[k] = (rimUnder(Revolution::moved(frame, step), top).radius -
                  rimUnder(Revolution::moved(frame, -step), top).radius) /
                 (2 * steps[k]);
    }
    int around = 0;
    const Eigen::Matrix4d variance = covariance(gather(1), rim.radius, around);
    const double sd = std::sqrt(std::max(0.0, slope.dot(variance * slope)));
    RimEstimate out;
    fillDiameter(rim.radius, sd, tQuantile(around - 2), out);
    fillFrame(frame, rim, out);
    out.kept = out.arc_mm / (std::numbers::pi * out.diameter_mm);
    out.kept_low = std::isfinite(out.high_mm)
                       ? std::min(1.0, out.arc_mm / (std::numbers::pi * out.high_mm))
                       : 0;
    out.kept_high = std::min(1.0, out.arc_mm / (std::numbers::pi * out.low_mm));
    out.smoother = std::log(std::max(arc_.elsewhere_mm, 0.02) / std::max(arc_.rms_mm, 0.02));
    out.lip_scatter_mm = lipScatter(frame);
    out.probability = probability(out);
    // A circle through a break says nothing of the mouth, however well it fits.
    if (out.probability < kLikelyLip) {
      out.low_mm = kSmallestMouth_mm;
      out.high_mm = std::numeric_limits<double>::infinity();
      out.kept_low = 0;
      out.kept_high = 1;
    }
    return out;
  }

  // Errors of the sagitta are symmetric, so it is the curvature that scatters evenly.
  static void fillDiameter(double radius, double sd, double quantile, RimEstimate& out) {
    const double relative = quantile * std::hypot(sd / radius, kRoundness);
    out.diameter_mm = 2 * radius;
    out.low_mm = 2 * radius / (1 + relative);
    out.high_mm =
        relative < 1 ? 2 * radius / (1 - relative) : std::numeric_limits<double>::infinity();
  }

  // From the middle of the stretch to both sides as long as the edge keeps to one circle; radians.
  double angleOfArc(const Eigen::Isometry3d& placed) const {
    std::vector<double> radii, heights;
    for (const Vector3d& p : arc_.points) {
      const Vector3d q = placed * p;
      radii.push_back(q.head<2>().norm());
      heights.push_back(q.z());
    }
    const double radius = medianOf(radii), height = medianOf(heights);
    const std::size_t n = arc_.edge.size(), middle = arc_.start + arc_.points.size() / 2;
    double angle = 0;
    for (const std::size_t step : {std::size_t{1}, n - 1}) {
      Vector3d last = placed * arc_.edge[middle % n];
      for (std::size_t k = 1; k < n / 2; ++k) {
        const Vector3d q = placed * arc_.edge[(middle + k * step) % n];
        if (std::abs(q.head<2>().norm() - radius) > kOffCircle_mm ||
            std::abs(q.z() - height) > kOffCircle_mm)
          break;
        const double cross = last.x() * q.y() - last.y() * q.x();
        angle += std::abs(std::atan2(cross, last.head<2>().dot(q.head<2>())));
        last = q;
      }
    }
    return angle;
  }

  void fillFrame(const Eigen::Isometry3d& axis, const Rim& rim, RimEstimate& out) const {
    // The sherd's middle at +x, up as the lip looks.
    const Vector3d centre = axis * walls_.centre;
    const double turn = std::atan2(centre.y(), centre.x());
    Eigen::Isometry3d placed = axis;
    placed.pretranslate(Vector3d(0, 0, -rim.height));
    placed.prerotate(Eigen::AngleAxisd(-turn, Vector3d::UnitZ()));
    out.vessel_from_model = placed;
    out.arc_mm = rim.radius * angleOfArc(placed);
    std::vector<double> off;
    for (Eigen::Index i = 0; i < best_.residuals.size(); i += 2)
      off.push_back(std::abs(best_.residuals[i]));
    out.residual_mm = medianOf(std::move(off));
  }

  // Of a lip against a break that happens to be smooth: how much smoother the stretch is than the
  // rest of the edge, and how well its surface is turned. Logistic, fitted on virtual sherds (seeds
  // 1 to 60 with a rim, 201 to 240 without; RESULTS.md, 'Rims'), others than those of the tests.
  static double probability(const RimEstimate& rim) {
    const double turned = std::log(std::max(rim.lip_scatter_mm, 0.02) / 0.1);
    return 1 / (1 + std::exp(-(kProbability[0] + kProbability[1] * rim.smoother +
                               kProbability[2] * turned)));
  }
  static constexpr double kProbability[3] = {-2.13, 2.03, -1.99};

  const Walls& walls_;
  const RimArc& arc_;
  Vector3d chord_, up_, middle_;
  std::vector<Vector3d> lip_;
  Revolution::Fit best_;
};

}  // namespace

bool RimEstimate::saysDiameter() const {
  return diameter_mm > 0 && low_mm > 0 && high_mm <= kWidestMouth_mm;  // not of what is no number
}

std::optional<RimEstimate> estimateRim(const Walls& walls, const RimArc& arc) {
  return Estimator(walls, arc).run();
}

std::optional<RimEstimate> findRim(const Walls& walls) {
  std::optional<RimEstimate> best;
  for (const RimArc& arc : findRimArcs(walls)) {
    std::optional<RimEstimate> one = estimateRim(walls, arc);
    // The most lip that may be expected: a part of the lip is as likely as all of it.
    if (one && (!best || one->probability * one->arc_mm > best->probability * best->arc_mm))
      best = std::move(one);
  }
  return best;
}

}  // namespace ostraka::drawing
