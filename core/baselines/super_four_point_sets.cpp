#include "baselines/super_four_point_sets.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <unordered_map>
#include <vector>

#include "cloud/nearest.h"

namespace ostraka::baselines {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

using PointPair = std::array<int, 2>;

// Four points of the back in one plane. The segments from 0 to 1 and from 2 to 3 cross at these
// shares of their lengths: an affine map, thus a motion, leaves them as they are.
struct Base {
  std::array<int, 4> points{};
  double first_share = 0, second_share = 0;
  double first_mm = 0, second_mm = 0;
  double angle_rad = 0;  // between the segments
};

// Visits 0 to n-1 in steps near the golden section, so that any begin is a sample of all. A step
// that has no divisor in common with n meets each number once.
struct Jumping {
  explicit Jumping(std::size_t n) : count(n), step(n * 618 / 1000 + 1) {
    while (std::gcd(step, count) > 1) ++step;
  }
  std::size_t operator[](std::size_t k) const { return (k * step) % count; }
  std::size_t count, step;
};

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

class SuperSearch {
 public:
  SuperSearch(const PointCloud& front, const PointCloud& back, const SuperFourPointOptions& options,
              std::stop_token stop)
      : front_(front),
        back_(back),
        options_(options),
        stop_(std::move(stop)),
        front_tree_(front.points),
        turn_rad_(options.max_normal_angle_deg * M_PI / 180) {
    for (const Vector3f& p : front.points) front_box_.extend(p);
    Eigen::AlignedBox3f box;
    for (const Vector3f& p : back.points) box.extend(p);
    longest_mm_ = options.overlap * box.diagonal().norm();
  }

  Result<Isometry3d> run();

 private:
  Vector3d frontPoint(int i) const {
    return front_.points[static_cast<std::size_t>(i)].cast<double>();
  }
  Vector3d backPoint(int i) const {
    return back_.points[static_cast<std::size_t>(i)].cast<double>();
  }
  static double normalAngle(const PointCloud& cloud, int i, int j) {
    return angleBetween(cloud.normals[static_cast<std::size_t>(i)].cast<double>(),
                        cloud.normals[static_cast<std::size_t>(j)].cast<double>());
  }
  int drawn() { return static_cast<int>(random_() % back_.size()); }

  std::optional<Base> drawBase();
  std::optional<Base> crossing(const std::array<int, 4>& points) const;
  std::vector<PointPair> pairsLike(int i, int j) const;
  void shells(const Vector3f& centre, float half, const std::vector<int>& points,
              const std::vector<int>& spheres, double radius, std::vector<PointPair>& found) const;
  std::vector<std::array<int, 4>> congruent(const Base& base) const;
  std::optional<Isometry3d> poseOf(const Base& base, const std::array<int, 4>& set) const;
  double shareThatMeets(const Isometry3d& pose, double best) const;

  const PointCloud &front_, &back_;
  const SuperFourPointOptions& options_;
  std::stop_token stop_;
  KdTree front_tree_;
  Eigen::AlignedBox3f front_box_;
  double longest_mm_ = 0, turn_rad_ = 0;
  std::mt19937 random_{1};
};

// Where the segments ab and cd of four points come nearest to each other, if that lies on both and
// the points are in one plane within delta.
std::optional<Base> SuperSearch::crossing(const std::array<int, 4>& points) const {
  const Vector3d a = backPoint(points[0]), u = backPoint(points[1]) - a;
  const Vector3d c = backPoint(points[2]), v = backPoint(points[3]) - c;
  const Vector3d w = a - c;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double area = uu * vv - uv * uv;
  if (area < 1e-6 * uu * vv) return {};
  Base base{points};
  base.first_share = (uv * v.dot(w) - vv * u.dot(w)) / area;
  base.second_share = (uu * v.dot(w) - uv * u.dot(w)) / area;
  for (const double share : {base.first_share, base.second_share})
    if (share < 0 || share > 1) return {};
  if ((w + base.first_share * u - base.second_share * v).norm() > options_.accuracy_mm) return {};
  base.first_mm = std::sqrt(uu);
  base.second_mm = std::sqrt(vv);
  base.angle_rad = angleBetween(u, v);
  return base;
}

// A wide triangle of points drawn at random, no side longer than the overlap allows, and the fourth
// point whose segments cross and span the largest area.
std::optional<Base> SuperSearch::drawBase() {
  constexpr int kDraws = 200;
  std::array<int, 3> triangle{};
  double widest = 0;
  const int a = drawn();
  for (int draw = 0; draw < kDraws; ++draw) {
    const int b = drawn(), c = drawn();
    const Vector3d u = backPoint(b) - backPoint(a), v = backPoint(c) - backPoint(a);
    if (std::max({u.norm(), v.norm(), (u - v).norm()}) > longest_mm_) continue;
    const double area = u.cross(v).norm();
    if (area <= widest) continue;
    widest = area;
    triangle = {a, b, c};
  }
  if (widest <= 0) return {};
  std::optional<Base> best;
  double most = 0;
  for (int d = 0; d < static_cast<int>(back_.size()); ++d) {
    const auto [p, q, r] = triangle;
    if (d == p || d == q || d == r) continue;
    for (const std::array<int, 4>& points :
         {std::array{p, q, r, d}, std::array{p, r, q, d}, std::array{p, d, q, r}}) {
      const std::optional<Base> base = crossing(points);
      if (!base || std::max(base->first_mm, base->second_mm) > longest_mm_) continue;
      const double area = base->first_mm * base->second_mm * std::sin(base->angle_rad);
      if (area <= most) continue;
      most = area;
      best = base;
    }
  }
  return best;
}

// Spheres about points of the front, in a cube of its space: those whose shells cross it go on to
// its eight parts, until few points or spheres are left, or the cube is as small as delta.
void SuperSearch::shells(const Vector3f& centre, float half, const std::vector<int>& points,
                         const std::vector<int>& spheres, double radius,
                         std::vector<PointPair>& found) const {
  const double delta = options_.accuracy_mm;
  std::vector<int> crossed;
  for (const int s : spheres) {
    const Vector3f off = (front_.points[static_cast<std::size_t>(s)] - centre).cwiseAbs();
    const double nearest = (off.array() - half).max(0.f).matrix().norm();
    const double farthest = (off.array() + half).matrix().norm();
    if (nearest <= radius + delta && farthest >= radius - delta) crossed.push_back(s);
  }
  if (crossed.empty() || stop_.stop_requested()) return;
  if (points.size() <= 4 || half <= delta) {
    for (const int s : crossed)
      for (const int p : points)
        if (s != p && std::abs((frontPoint(s) - frontPoint(p)).norm() - radius) <= delta)
          found.push_back({s, p});
    return;
  }
  std::array<std::vector<int>, 8> parts;
  for (const int p : points) {
    const Vector3f& at = front_.points[static_cast<std::size_t>(p)];
    parts[static_cast<std::size_t>((at.x() > centre.x()) + 2 * (at.y() > centre.y()) +
                                   4 * (at.z() > centre.z()))]
        .push_back(p);
  }
  for (int k = 0; k < 8; ++k) {
    const std::vector<int>& part = parts[static_cast<std::size_t>(k)];
    const Vector3f towards((k & 1) != 0 ? 1.f : -1.f, (k & 2) != 0 ? 1.f : -1.f,
                           (k & 4) != 0 ? 1.f : -1.f);
    if (!part.empty())
      shells(centre + 0.5f * half * towards, 0.5f * half, part, crossed, radius, found);
  }
}

// Ordered pairs of the front as far from each other as these two of the back, and whose normals
// turn alike.
std::vector<PointPair> SuperSearch::pairsLike(int i, int j) const {
  std::vector<int> all(front_.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<int>(k);
  std::vector<PointPair> pairs;
  const float half = 0.5f * front_box_.sizes().maxCoeff() + 1e-3f;
  shells(front_box_.center(), half, all, all, (backPoint(i) - backPoint(j)).norm(), pairs);
  const double turned = normalAngle(back_, i, j);
  std::erase_if(pairs, [&](const PointPair& pair) {
    return std::abs(normalAngle(front_, pair[0], pair[1]) - turned) > turn_rad_;
  });
  return pairs;
}

// Pairs of the front that lie to each other as the base's segments: they cross at the same place,
// at the same angle. Cells are two deltas wide, so that what is within one delta lies in eight.
std::vector<std::array<int, 4>> SuperSearch::congruent(const Base& base) const {
  const std::vector<PointPair> firsts = pairsLike(base.points[0], base.points[1]);
  const std::vector<PointPair> seconds = pairsLike(base.points[2], base.points[3]);
  std::vector<std::array<int, 4>> sets;
  if (firsts.empty() || seconds.empty()) return sets;
  const double delta = options_.accuracy_mm, cell = 2 * delta;
  const auto crossingOf = [&](const PointPair& pair, double share) -> Vector3d {
    return (1 - share) * frontPoint(pair[0]) + share * frontPoint(pair[1]);
  };
  const auto keyOf = [](const Eigen::Array3d& place) {
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k)
      key =
          (key << 21) | (static_cast<std::uint64_t>(std::llround(place[k]) + (1 << 20)) & 0x1FFFFF);
    return key;
  };
  std::unordered_map<std::uint64_t, std::vector<int>> cells;  // only looked up, never walked
  for (std::size_t k = 0; k < firsts.size(); ++k)
    cells[keyOf((crossingOf(firsts[k], base.first_share) / cell).array().floor())].push_back(
        static_cast<int>(k));
  const double tolerance_rad = 2 * delta / base.first_mm + 2 * delta / base.second_mm;
  const Jumping order(seconds.size());
  for (std::size_t k = 0; k < seconds.size() && !stop_.stop_requested(); ++k) {
    const PointPair& second = seconds[order[k]];
    const Vector3d at = crossingOf(second, base.second_share);
    const Vector3d along = frontPoint(second[1]) - frontPoint(second[0]);
    const Eigen::Array3d lowest = ((at.array() - delta) / cell).floor();
    for (int corner = 0; corner < 8; ++corner) {
      const auto in_cell =
          cells.find(keyOf(lowest + Eigen::Array3d(corner & 1, (corner >> 1) & 1, corner >> 2)));
      if (in_cell == cells.end()) continue;
      for (const int f : in_cell->second) {
        const PointPair& first = firsts[static_cast<std::size_t>(f)];
        if ((crossingOf(first, base.first_share) - at).norm() > delta) continue;
        const double angle = angleBetween(frontPoint(first[1]) - frontPoint(first[0]), along);
        if (std::abs(angle - base.angle_rad) > tolerance_rad) continue;
        sets.push_back({first[0], first[1], second[0], second[1]});
        if (static_cast<int>(sets.size()) >= options_.max_matches) return sets;
      }
    }
  }
  return sets;
}

// The motion that lays the base on the set (Umeyama 1991), if no point is off by more than two
// deltas and no normal turned away.
std::optional<Isometry3d> SuperSearch::poseOf(const Base& base,
                                              const std::array<int, 4>& set) const {
  Eigen::Matrix<double, 3, 4> from, to;
  for (int k = 0; k < 4; ++k) {
    from.col(k) = backPoint(base.points[static_cast<std::size_t>(k)]);
    to.col(k) = frontPoint(set[static_cast<std::size_t>(k)]);
  }
  const Eigen::Matrix4d solved = Eigen::umeyama(from, to, false);
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(Eigen::Matrix3d(solved.topLeftCorner<3, 3>()))
                      .normalized()
                      .toRotationMatrix();
  pose.translation() = solved.topRightCorner<3, 1>();
  if (!pose.matrix().allFinite()) return {};
  for (int k = 0; k < 4; ++k) {
    const auto b = static_cast<std::size_t>(base.points[static_cast<std::size_t>(k)]);
    const auto f = static_cast<std::size_t>(set[static_cast<std::size_t>(k)]);
    if ((pose * from.col(k) - to.col(k)).norm() > 2 * options_.accuracy_mm) return {};
    if (angleBetween(pose.linear() * back_.normals[b].cast<double>(),
                     front_.normals[f].cast<double>()) > turn_rad_)
      return {};
  }
  return pose;
}

// Of the back's samples; 0 as soon as it cannot be more than the best.
double SuperSearch::shareThatMeets(const Isometry3d& pose, double best) const {
  const Jumping order(back_.size());
  const std::size_t samples =
      std::min(back_.size(), static_cast<std::size_t>(std::max(1, options_.samples)));
  const double min_cos = std::cos(turn_rad_);
  std::size_t meet = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    // A tenth tells poses of which hardly anything meets.
    if (k == samples / 10 &&
        static_cast<double>(meet) < 0.5 * options_.overlap * static_cast<double>(k))
      return 0;
    if (static_cast<double>(meet + samples - k) <= best * static_cast<double>(samples)) return 0;
    const std::size_t i = order[k];
    const Vector3d p = pose * back_.points[i].cast<double>();
    const int near =
        front_tree_.nearest(p.cast<float>(), static_cast<float>(options_.accuracy_mm)).index;
    if (near < 0) continue;
    const Vector3d normal = pose.linear() * back_.normals[i].cast<double>();
    if (normal.dot(front_.normals[static_cast<std::size_t>(near)].cast<double>()) > min_cos) ++meet;
  }
  return static_cast<double>(meet) / static_cast<double>(samples);
}

Result<Isometry3d> SuperSearch::run() {
  constexpr double kNearlyAll = 0.98;
  double best = 0;
  Isometry3d found = Isometry3d::Identity();
  for (int k = 0; k < options_.bases && best < kNearlyAll; ++k) {
    if (stop_.stop_requested()) return Error::cancelled();
    const std::optional<Base> base = drawBase();
    if (!base) continue;
    for (const std::array<int, 4>& set : congruent(*base)) {
      if (stop_.stop_requested()) return Error::cancelled();
      const std::optional<Isometry3d> pose = poseOf(*base, set);
      const double share = pose ? shareThatMeets(*pose, best) : 0;
      if (share <= best) continue;
      best = share;
      found = *pose;
    }
  }
  if (stop_.stop_requested()) return Error::cancelled();
  if (best < options_.overlap) return notConverged();
  return found;
}

}  // namespace

Result<Isometry3d> superFourPointSets(const PointCloud& front_cloud, const PointCloud& back_cloud,
                                      const SuperFourPointOptions& options, std::stop_token stop) {
  const PointCloud front = thinned(front_cloud, options.spacing_mm);
  const PointCloud back = thinned(back_cloud, options.spacing_mm);
  if (const auto ok = enoughPoints(front, back); !ok) return ok.error();
  return SuperSearch(front, back, options, std::move(stop)).run();
}

}  // namespace ostraka::baselines
