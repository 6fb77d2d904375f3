#include "vessels/sherd.h"

#include <algorithm>
#include <numbers>

namespace ostraka::vessels {
namespace {

// Of one octave's height in that of the next coarser: fractured surfaces are self-affine with an
// exponent of about 0.8 (Bouchaud, "Scaling properties of cracks", 1997), so 2^-0.8.
constexpr float kFractureShare = 0.57f;
constexpr int kMostFaces = 55'000;  // an estimate; a truth mesh holds at most 60 000

// The plane in which a piece is drawn: unrolled wall (a along the parallel, b up the profile), or
// the base seen from outside (distance from the origin = arc length from the base's centre).
class Chart {
 public:
  Chart(const Vessel& vessel, const BreakPlan& plan)
      : vessel_(vessel), base_(plan.part == SherdPart::Base), s_mm_(plan.s_mm) {}

  Eigen::Vector2d placeOf(const Eigen::Vector2d& q) const {  // (s, theta)
    if (base_) {
      const Eigen::Vector2d p = q + Eigen::Vector2d(s_mm_, 0);
      return {p.norm(), -std::atan2(p.y(), p.x())};
    }
    const double s = s_mm_ + q.y();
    return {s, q.x() / vessel_.radius(s)};
  }
  Eigen::Vector3d point(const Eigen::Vector2d& q, double depth) const {
    const Eigen::Vector2d p = placeOf(q);
    const Eigen::Vector3d outer = vessel_.outer(p.x(), p.y());
    if (depth == 0) return outer;
    return outer + depth * (vessel_.inner(p.x(), p.y()) - outer);
  }
  double thickness(const Eigen::Vector2d& q) const { return vessel_.thickness(placeOf(q).x()); }
  ClayPlace clayPlace(const Eigen::Vector2d& q, double depth, bool broken) const {
    const Eigen::Vector2d p = placeOf(q);
    return {static_cast<float>(p.y() * 60), static_cast<float>(p.x()), static_cast<float>(depth),
            broken ? 1.f : 0.f};
  }

 private:
  const Vessel& vessel_;
  bool base_;
  double s_mm_;
};

// Distance of the outline from the centre in each direction: a star-shaped polygon with fractal
// edges. Directions are turns about the centre, counter-clockwise in the chart.
class Outline {
 public:
  explicit Outline(const BreakPlan& plan) : plan_(plan) {
    Random random(plan.outline_seed);
    const int count = 5 + random.below(4);
    const double stretch = random.uniform(1, 1.45), axis = random.uniform(0, std::numbers::pi);
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * (i + random.uniform(-0.28, 0.28)) / count;
      const double radius = random.uniform(0.8, 1.25) * plan.radius_mm;
      const Eigen::Vector2d q =
          Eigen::Rotation2Dd(axis) *
          Eigen::DiagonalMatrix<double, 2>(std::sqrt(stretch), 1 / std::sqrt(stretch)) *
          Eigen::Rotation2Dd(-axis) *
          Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle));
      corners_.push_back(q);
    }
    std::sort(corners_.begin(), corners_.end(), [](const auto& p, const auto& q) {
      return std::atan2(p.y(), p.x()) < std::atan2(q.y(), q.x());
    });
    seed_ = static_cast<std::uint32_t>(random.next());
  }

  /// through_mm: depth in the wall from its middle; a crack wanders that way as well.
  double radius(double angle, double through_mm = 0) const {
    if (plan_.mirrored) angle = std::numbers::pi - angle;
    const Eigen::Vector2d d(std::cos(angle), std::sin(angle));
    double r = plan_.radius_mm;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Eigen::Vector2d& p = corners_[i];
      const Eigen::Vector2d& q = corners_[(i + 1) % corners_.size()];
      const double from = cross(p, d), to = cross(d, q), turn = cross(p, q);
      if (from < 0 || to < 0 || turn <= 0) continue;
      r = turn / (cross(d, q) + cross(p, d));  // along p + t (q - p)
      break;
    }
    const Eigen::Vector3f q(static_cast<float>(r * d.x()), static_cast<float>(r * d.y()),
                            static_cast<float>(through_mm));
    // Cracks wander by some mm over centimetres; what is finer belongs to the break's relief.
    return r + 0.06 * plan_.radius_mm * noise(q / 17, seed_ + 7) +
           1.8 * fractalNoise(q / 8, seed_, 3);
  }

 private:
  static double cross(const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return p.x() * q.y() - p.y() * q.x();
  }
  const BreakPlan& plan_;
  std::vector<Eigen::Vector2d> corners_;
  std::uint32_t seed_ = 0;
};

struct Column {
  double angle = 0;  // direction of the outline's point from the centre
  bool rim = false;  // on the vessel's lip, not broken
  double lean = 0;   // tangent of the break face's lean, outward from outside to inside
  std::vector<Eigen::Vector2d> chart;  // by row, from the outer to the inner surface
  std::vector<double> depth;
};

class Builder {
 public:
  Builder(const Vessel& vessel, const BreakPlan& plan)
      : vessel_(vessel),
        plan_(plan),
        chart_(vessel, plan),
        outline_(plan),
        relief_seed_(static_cast<std::uint32_t>(mixed(plan.relief_seed))),
        worn_mm_(Random(mixed(plan.relief_seed, 3)).uniform(0.03, 0.18)),
        rim_b_(plan.part == SherdPart::Rim ? vessel.length() - plan.s_mm : 1e9) {}

  VirtualSherd build() {
    layColumns();
    for (Column& c : columns_) fillColumn(c);
    emit();
    return std::move(sherd_);
  }

 private:
  double radiusAt(double angle) const {
    const double r = outline_.radius(angle);
    return std::sin(angle) * r > rim_b_ ? rim_b_ / std::sin(angle) : r;
  }

  // Columns at equal steps of the outline's length, with the step that keeps to kMostFaces.
  void layColumns() {
    constexpr int kFine = 16384;
    std::vector<double> length(kFine + 1, 0.0);
    double area = 0;
    Eigen::Vector2d last(radiusAt(0), 0);
    for (int i = 1; i <= kFine; ++i) {
      const double angle = 2 * std::numbers::pi * i / kFine, r = radiusAt(angle);
      const Eigen::Vector2d q(r * std::cos(angle), r * std::sin(angle));
      length[i] = length[i - 1] + (q - last).norm();
      area += 0.5 * (last.x() * q.y() - last.y() * q.x());
      last = q;
    }
    const double wall = chart_.thickness({0, 0});
    const double surface = 2 * area + length.back() * wall;
    edge_ = std::max(plan_.edge_mm, std::sqrt(surface / (0.433 * kMostFaces)));
    const int count = static_cast<int>(std::lround(length.back() / edge_));
    rows_ = std::max(
        3, static_cast<int>(std::lround(wall / edge_)) + (plan_.part == SherdPart::Rim ? 2 : 0));
    rings_ = std::max(
        4, static_cast<int>(std::lround(std::sqrt(area / std::numbers::pi) / (0.92 * edge_))));
    int i = 1;
    for (int k = 0; k < count; ++k) {
      const double s = length.back() * k / count;
      while (length[i] < s) ++i;
      const double t = (s - length[i - 1]) / std::max(1e-12, length[i] - length[i - 1]);
      Column c;
      c.angle = 2 * std::numbers::pi * (i - 1 + t) / kFine;
      c.rim = outline_.radius(c.angle) * std::sin(c.angle) > rim_b_;
      const Eigen::Vector3f around(static_cast<float>(1.6 * std::cos(c.angle)),
                                   static_cast<float>(1.6 * std::sin(c.angle)), 0);
      c.lean =
          std::tan(plan_.tilt_rad * std::clamp(1.6 * noise(around, relief_seed_ + 5), -1.0, 1.0));
      columns_.push_back(std::move(c));
    }
  }

  void fillColumn(Column& c) {
    const Eigen::Vector2d d(std::cos(c.angle), std::sin(c.angle));
    const double middle = outline_.radius(c.angle);
    const double wall = chart_.thickness(radiusAt(c.angle) * d);
    for (int row = 0; row <= rows_; ++row) {
      const double t = static_cast<double>(row) / rows_;
      const double depth = c.rim ? 0.5 - 0.5 * std::cos(std::numbers::pi * t) : t;
      const double through = (depth - 0.5) * wall;
      const Eigen::Vector3f q(static_cast<float>(middle * d.x()),
                              static_cast<float>(middle * d.y()), static_cast<float>(depth * wall));
      const double relief =
          plan_.relief_mm * (1.5 * noise(q / 5.5f, relief_seed_ + 9) +
                             1.2 * fractalNoise(q / 2.2f, relief_seed_, 3, kFractureShare));
      const double worn =
          worn_mm_ * (std::exp(-depth * wall / 0.4) + std::exp((depth - 1) * wall / 0.4));
      double r = outline_.radius(c.angle, through) + through * c.lean + relief - worn;
      // The lip: half an ellipse across the wall, its top on the vessel's upper edge.
      const double lip =
          rim_b_ + 0.45 * wall *
                       (std::sin(std::numbers::pi *
                                 (c.rim ? t : std::acos(1 - 2 * depth) / std::numbers::pi)) -
                        1);
      if (r * d.y() > lip) r = lip / d.y();
      c.chart.push_back(std::max(r, 1.0) * d);
      c.depth.push_back(depth);
    }
  }

  int add(const Eigen::Vector2d& q, double depth, bool broken) {
    sherd_.mesh.vertices.push_back(Eigen::Vector3f::Zero());
    points_.push_back(chart_.point(q, depth));
    sherd_.places.push_back(chart_.clayPlace(q, depth, broken));
    return static_cast<int>(points_.size()) - 1;
  }

  // A face of the wall: the outline's row, then rings that shrink towards the centre.
  void emitFace(const std::vector<int>& border, int row, bool flip) {
    const double depth = row == 0 ? 0 : 1;
    const int n0 = static_cast<int>(border.size());
    std::vector<int> outer = border;
    for (int k = 1; k <= rings_; ++k) {
      const double shrink = 1 - static_cast<double>(k) / rings_;
      const int n = k == rings_ ? 1 : std::max(6, static_cast<int>(std::lround(n0 * shrink)));
      std::vector<int> ring;
      for (int i = 0; i < n; ++i) {
        const double u = static_cast<double>(i) / n * n0;
        const int j = static_cast<int>(u);
        const Eigen::Vector2d q =
            columns_[j].chart[row] +
            (u - j) * (columns_[(j + 1) % n0].chart[row] - columns_[j].chart[row]);
        ring.push_back(add(shrink * q, depth, false));
      }
      stitch(outer, ring, flip);
      outer = std::move(ring);
    }
  }

  // Triangles between two closed rings whose points are evenly numbered around.
  void stitch(const std::vector<int>& outer, const std::vector<int>& inner, bool flip) {
    const std::size_t n = outer.size(), m = inner.size();
    std::size_t i = 0, j = 0;
    while (i < n || j < (m > 1 ? m : 0)) {
      const bool step_outer = m == 1 || (i < n && (j >= m || (2 * i + 1) * m <= (2 * j + 1) * n));
      if (step_outer) {
        face(outer[i % n], outer[(i + 1) % n], inner[j % m], flip);
        ++i;
      } else {
        face(outer[i % n], inner[(j + 1) % m], inner[j % m], flip);
        ++j;
      }
    }
  }

  void face(int a, int b, int c, bool flip) {
    if (flip) std::swap(b, c);
    sherd_.mesh.triangles.push_back({a, b, c});
  }

  void emit() {
    const int n = static_cast<int>(columns_.size());
    std::vector<std::vector<int>> grid(rows_ + 1, std::vector<int>(n));
    for (int row = 0; row <= rows_; ++row)
      for (int j = 0; j < n; ++j) {
        const Column& c = columns_[j];
        const bool broken = !c.rim && row > 0 && row < rows_;
        grid[row][j] = add(c.chart[row], c.depth[row], broken);
      }
    for (int row = 0; row < rows_; ++row)
      for (int j = 0; j < n; ++j) {
        const int k = (j + 1) % n;
        const int a = grid[row][j], b = grid[row][k], c = grid[row + 1][j], d = grid[row + 1][k];
        // The shorter diagonal keeps the relief's crests.
        if ((points_[a] - points_[d]).squaredNorm() < (points_[b] - points_[c]).squaredNorm()) {
          face(b, a, d, false);
          face(a, c, d, false);
        } else {
          face(b, a, c, false);
          face(b, c, d, false);
        }
      }
    emitFace(grid[0], 0, false);
    emitFace(grid[rows_], rows_, true);
    finish();
  }

  void finish() {
    TriangleMesh rough = sherd_.mesh;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points_) mean += p;
    mean /= static_cast<double>(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      rough.vertices[i] = (points_[i] - mean).cast<float>();
    Eigen::Vector3d centre;
    enclosedVolume(rough, &centre);
    const Eigen::Vector3d z = (chart_.point({0, 0}, 0) - chart_.point({0, 0}, 1)).normalized();
    const Eigen::Vector3d x =
        (chart_.point({1, 0}, 0) - chart_.point({-1, 0}, 0)).cross(z).cross(z).normalized() * -1;
    Eigen::Matrix3d model_from_vessel;
    model_from_vessel << x.transpose(), z.cross(x).transpose(), z.transpose();
    for (std::size_t i = 0; i < points_.size(); ++i)
      sherd_.mesh.vertices[i] = (model_from_vessel * (points_[i] - mean - centre)).cast<float>();
    sherd_.volume_mm3 = enclosedVolume(sherd_.mesh);
    measure();
  }

  void measure() {
    for (int i = 0; i < 36; ++i) {
      Eigen::Vector3f d(static_cast<float>(std::cos(std::numbers::pi * i / 36)),
                        static_cast<float>(std::sin(std::numbers::pi * i / 36)), 0);
      float low = 1e9f, high = -1e9f;
      for (const Eigen::Vector3f& p : sherd_.mesh.vertices) {
        low = std::min(low, d.dot(p));
        high = std::max(high, d.dot(p));
      }
      sherd_.width_mm = std::max(sherd_.width_mm, static_cast<double>(high - low));
    }
    sherd_.wall_min_mm = 1e9;
    for (const Column& c : columns_)
      for (const double shrink : {0.3, 0.6, 0.85}) {
        const double wall =
            (chart_.point(shrink * c.chart[0], 0) - chart_.point(shrink * c.chart[0], 1)).norm();
        sherd_.wall_min_mm = std::min(sherd_.wall_min_mm, wall);
        sherd_.wall_max_mm = std::max(sherd_.wall_max_mm, wall);
        sherd_.wall_mean_mm += wall / (3.0 * static_cast<double>(columns_.size()));
      }
    sherd_.kind = std::string(name(vessel_.form())) + " " + name(plan_.part);
  }

  const Vessel& vessel_;
  const BreakPlan& plan_;
  Chart chart_;
  Outline outline_;
  std::uint32_t relief_seed_;
  double worn_mm_;  // off the creases: fresh breaks are sharp, long buried ones are not
  double rim_b_;
  double edge_ = 0.5;
  int rows_ = 0, rings_ = 0;
  std::vector<Column> columns_;
  std::vector<Eigen::Vector3d> points_;  // vessel frame
  VirtualSherd sherd_;
};

}  // namespace

const char* name(SherdPart part) {
  return part == SherdPart::Wall ? "wall" : part == SherdPart::Rim ? "rim" : "base";
}

double enclosedVolume(const TriangleMesh& mesh, Eigen::Vector3d* centre_of_mass) {
  double volume = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[t[0]].cast<double>(),
                          b = mesh.vertices[t[1]].cast<double>(),
                          c = mesh.vertices[t[2]].cast<double>();
    const double six = a.dot(b.cross(c));
    volume += six / 6;
    moment += six / 24 * (a + b + c);
  }
  if (centre_of_mass) *centre_of_mass = moment / volume;
  return volume;
}

VirtualSherd breakOut(const Vessel& vessel, const BreakPlan& plan) {
  return Builder(vessel, plan).build();
}

}  // namespace ostraka::vessels
