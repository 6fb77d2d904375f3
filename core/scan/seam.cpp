#include "scan/seam.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

namespace ostraka::scan {
namespace {

constexpr float kLayer_mm = 0.5f;     // what lies deeper below the highest point is another surface
constexpr double kOffPlane_mm = 0.4;  // a neighbouring cell so far off the plane of this one ...
constexpr double kBend_deg = 20;      // ... or so far turned is reached over a break,
constexpr double kBreakCost = 8;      // which is as long as so many cells
constexpr double kNear_mm = 4, kSeam_mm = 1;  // a side's plane is fitted in this ring
constexpr int kFewestCells = 8;
constexpr double kStep_mm = 0.6, kGroove_mm = 0.6, kKink_deg = 20;

Eigen::Vector3d normalOf(const SeenSurface& surface, const cv::Point& at) {
  const cv::Vec3f& n = surface.normal(at);
  return {n[0], n[1], n[2]};
}

// 0 on a smooth surface, 1 over a break or where nothing was seen.
double breakBetween(const SeenSurface& surface, const cv::Point& p, const cv::Point& q) {
  const double rise = surface.height_mm(q) - surface.height_mm(p);
  if (std::isnan(rise)) return 1;
  const Eigen::Vector3d way((q.x - p.x) * kPlanCell_mm, (q.y - p.y) * kPlanCell_mm, rise);
  const Eigen::Vector3d np = normalOf(surface, p), nq = normalOf(surface, q);
  const double off = std::max(std::abs(way.dot(np)), std::abs(way.dot(nq))) / kOffPlane_mm;
  const double bend = (1 - np.dot(nq)) / (1 - std::cos(kBend_deg * std::numbers::pi / 180));
  return std::min(1.0, off * off + bend);
}

struct Side {
  double height_mm;  // of its plane above the place asked for
  Eigen::Vector3d normal;
};

// The plane of one part beside a place of the seam.
std::optional<Side> sideAt(const cv::Mat1i& parts, int part, const cv::Mat1f& from_seam_mm,
                           const SeenSurface& surface, const cv::Point& place) {
  const int reach = static_cast<int>(kNear_mm / kPlanCell_mm);
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  int cells = 0;
  const cv::Rect all(0, 0, parts.cols, parts.rows);
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const cv::Point q = place + cv::Point(dx, dy);
      if (dx * dx + dy * dy > reach * reach || !all.contains(q) || parts(q) != part ||
          from_seam_mm(q) <= kSeam_mm || std::isnan(surface.height_mm(q)))
        continue;
      const Eigen::Vector3d row(1, dx * kPlanCell_mm, dy * kPlanCell_mm);
      squares += row * row.transpose();
      products += row * surface.height_mm(q);
      normal += normalOf(surface, q);
      ++cells;
    }
  if (cells < kFewestCells) return {};
  squares.diagonal().array() += 1e-6;  // cells in one row fix no plane
  return Side{squares.ldlt().solve(products)(0), normal.normalized()};
}

double lowestAt(const SeenSurface& surface, const cv::Point& place) {
  const int reach = static_cast<int>(kSeam_mm / kPlanCell_mm);
  const cv::Rect all(0, 0, surface.height_mm.cols, surface.height_mm.rows);
  double lowest = std::numeric_limits<double>::infinity();
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      const cv::Point q = place + cv::Point(dx, dy);
      if (all.contains(q) && surface.height_mm(q) < lowest) lowest = surface.height_mm(q);
    }
  return lowest;
}

}  // namespace

cv::Point Plan::cellOf(const Eigen::Vector3f& p) const {
  return {static_cast<int>((p.x() - origin.x()) / kPlanCell_mm),
          static_cast<int>((p.y() - origin.y()) / kPlanCell_mm)};
}

SeenSurface surfaceFromAbove(const PointCloud& piece, const Plan& plan) {
  cv::Mat1f top(plan.filled.size(), -std::numeric_limits<float>::infinity());
  for (const Eigen::Vector3f& p : piece.points) {
    float& highest = top(plan.cellOf(p));
    highest = std::max(highest, p.z());
  }
  cv::Mat1f count(top.size(), 0.f);
  SeenSurface seen{cv::Mat1f(top.size(), 0.f), cv::Mat3f(top.size(), cv::Vec3f())};
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const cv::Point cell = plan.cellOf(piece.points[i]);
    if (piece.points[i].z() < top(cell) - kLayer_mm) continue;
    count(cell) += 1;
    seen.height_mm(cell) += piece.points[i].z();
    const Eigen::Vector3f& n = piece.normals[i];
    seen.normal(cell) += cv::Vec3f(n.x(), n.y(), n.z());
  }
  for (int y = 0; y < top.rows; ++y)
    for (int x = 0; x < top.cols; ++x) {
      float& height = seen.height_mm(y, x);
      height = count(y, x) > 0 ? height / count(y, x) : std::numeric_limits<float>::quiet_NaN();
      const double length = cv::norm(seen.normal(y, x));
      if (length > 0) seen.normal(y, x) *= 1 / length;
    }
  return seen;
}

cv::Mat1i partsReached(const Plan& plan, const cv::Mat1i& cores, const SeenSurface* surface) {
  using Step = std::tuple<double, int, int>;  // cost, row, column
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
  cv::Mat1i parts = cores.clone();
  cv::Mat1d cost(cores.size(), std::numeric_limits<double>::infinity());
  for (int y = 0; y < cores.rows; ++y)
    for (int x = 0; x < cores.cols; ++x)
      if (cores(y, x) > 0) open.emplace(cost(y, x) = 0, y, x);
  const cv::Rect all(0, 0, cores.cols, cores.rows);
  while (!open.empty()) {
    const auto [spent, y, x] = open.top();
    open.pop();
    const cv::Point here(x, y);
    if (spent > cost(here)) continue;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const cv::Point next = here + cv::Point(dx, dy);
        if ((dx == 0 && dy == 0) || !all.contains(next) || plan.filled(next) == 0) continue;
        const double length = std::hypot(dx, dy);
        const double broken = surface ? breakBetween(*surface, here, next) : 0;
        const double total = spent + length * (1 + kBreakCost * broken);
        if (total >= cost(next)) continue;
        cost(next) = total;
        parts(next) = parts(here);
        open.emplace(total, next.y, next.x);
      }
  }
  return parts;
}

std::vector<cv::Point> seamBetween(const cv::Mat1i& parts, int a, int b) {
  std::vector<cv::Point> seam;
  for (int y = 1; y + 1 < parts.rows; ++y)
    for (int x = 1; x + 1 < parts.cols; ++x) {
      if (parts(y, x) != a) continue;
      if (parts(y, x - 1) == b || parts(y, x + 1) == b || parts(y - 1, x) == b ||
          parts(y + 1, x) == b)
        seam.emplace_back(x, y);
    }
  return seam;
}

double brokenShare(const cv::Mat1i& parts, int a, int b, const SeenSurface& surface) {
  const std::vector<cv::Point> seam = seamBetween(parts, a, b);
  if (seam.empty()) return 1;
  cv::Mat1b line(parts.size(), uchar{255});
  for (const cv::Point& p : seam) line(p) = 0;
  cv::Mat1f from_seam_mm;
  cv::distanceTransform(line, from_seam_mm, cv::DIST_L2, cv::DIST_MASK_5);
  from_seam_mm *= kPlanCell_mm;
  int known = 0, broken = 0;
  const double straight = std::cos(kKink_deg * std::numbers::pi / 180);
  for (const cv::Point& p : seam) {
    const std::optional<Side> one = sideAt(parts, a, from_seam_mm, surface, p);
    const std::optional<Side> other = sideAt(parts, b, from_seam_mm, surface, p);
    if (!one || !other) continue;
    ++known;
    const double groove = std::min(one->height_mm, other->height_mm) - lowestAt(surface, p);
    if (std::abs(one->height_mm - other->height_mm) > kStep_mm || groove > kGroove_mm ||
        one->normal.dot(other->normal) < straight)
      ++broken;
  }
  return known > 0 ? static_cast<double>(broken) / known : 0;
}

}  // namespace ostraka::scan
