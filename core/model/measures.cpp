#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "base/limits.h"
#include "base/message.h"
#include "base/text.h"
#include "cloud/bounds.h"
#include "model/model.h"
#include "model/ray_grid.h"
#include "model/volume_moment.h"

namespace ostraka::model {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLeastExtent_mm = 3;
constexpr double kLeastExtent_cm = 0.8;  // of a sherd; what is smaller is in m

struct Corners {
  Vector3d a, b, c;
};

Corners cornersOf(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  return {mesh.vertices[t[0]].cast<double>(), mesh.vertices[t[1]].cast<double>(),
          mesh.vertices[t[2]].cast<double>()};
}

// Centre and covariance of the surface, exact per triangle.
void surfaceMoments(const TriangleMesh& mesh, Vector3d& mean, Eigen::Matrix3d& covariance) {
  double area = 0;
  mean.setZero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
  for (const auto& t : mesh.triangles) {
    const Corners p = cornersOf(mesh, t);
    const double w = 0.5 * (p.b - p.a).cross(p.c - p.a).norm();
    const Vector3d s = p.a + p.b + p.c;
    area += w;
    mean += w / 3 * s;
    square +=
        w / 12 *
        (s * s.transpose() + p.a * p.a.transpose() + p.b * p.b.transpose() + p.c * p.c.transpose());
  }
  mean /= area;
  covariance = square / area - mean * mean.transpose();
}

std::vector<Vector2d> convexHull(std::vector<Vector2d> points) {
  const auto before = [](const Vector2d& a, const Vector2d& b) {
    return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
  };
  std::sort(points.begin(), points.end(), before);
  const auto turn = [](const Vector2d& o, const Vector2d& a, const Vector2d& b) {
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  };
  std::vector<Vector2d> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const Vector2d& p : points) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// Sides of the smallest rectangle: one of them lies along an edge of the hull.
Vector2d smallestRectangle(const std::vector<Vector2d>& hull) {
  Vector2d best(0, 0);
  double least = INFINITY;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2d u = (hull[(i + 1) % hull.size()] - hull[i]).normalized(), v(-u[1], u[0]);
    if (!u.allFinite()) continue;
    double low_u = INFINITY, high_u = -INFINITY, low_v = INFINITY, high_v = -INFINITY;
    for (const Vector2d& p : hull) {
      low_u = std::min(low_u, p.dot(u));
      high_u = std::max(high_u, p.dot(u));
      low_v = std::min(low_v, p.dot(v));
      high_v = std::max(high_v, p.dot(v));
    }
    const Vector2d sides(high_u - low_u, high_v - low_v);
    if (sides.prod() < least) {
      least = sides.prod();
      best = sides;
    }
  }
  return best;
}

// Of the cosine between a face's normal and the sherd's own: breaks are steeper.
constexpr double kFaceCosine = 0.5;
// Both faces of a wall run within 30 degrees of each other; an oblique break does not.
constexpr double kOppositeCosine = -0.87;

// Wall thickness per about 1 mm^2: rays from triangle centres against their normal.
std::vector<double> thicknesses(const TriangleMesh& mesh, const Vector3d& across_sherd) {
  const RayGrid rays(mesh);
  std::vector<double> found;
  double due = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Corners p = cornersOf(mesh, mesh.triangles[i]);
    const Vector3d across = (p.b - p.a).cross(p.c - p.a);
    due += 0.5 * across.norm();
    if (due < 1) continue;
    due = std::fmod(due, 1.0);
    const Vector3d normal = across.normalized();
    if (std::abs(normal.dot(across_sherd)) < kFaceCosine) continue;
    const auto hit = rays.leaving(((p.a + p.b + p.c) / 3).cast<float>(), (-normal).cast<float>(),
                                  static_cast<int>(i));
    if (hit && hit->normal.cast<double>().dot(normal) < kOppositeCosine)
      found.push_back(hit->distance_mm);
  }
  return found;
}

// Area of the gaps that the faces leave within their outline, each at least `kLeastHole_mm2`: a
// gap as small lies between the faces of one rough edge. places: the vertices in the sherd's plane.
double holesBetween(const TriangleMesh& mesh, const std::vector<Vector2d>& places) {
  constexpr double kPerMm = 4, kLeastHole_mm2 = 1;
  const auto [low, high] = boundsOf(places);
  const Raster raster = rasterOver(high - low, kPerMm);
  cv::Mat1b shown(raster.rows + 3, raster.columns + 3, uchar{0});
  constexpr int kShift = 6;
  const auto pixel = [&](int v) {
    const Vector2d at = ((places[static_cast<std::size_t>(v)] - low) * raster.per_mm).array() + 1;
    return cv::Point(cvRound(at[0] * (1 << kShift)), cvRound(at[1] * (1 << kShift)));
  };
  for (const auto& t : mesh.triangles) {
    const cv::Point corners[] = {pixel(t[0]), pixel(t[1]), pixel(t[2])};
    cv::fillConvexPoly(shown, corners, 3, cv::Scalar(255), cv::LINE_8, kShift);
  }
  cv::Mat labels, stats, centres;
  const int parts = cv::connectedComponentsWithStats(shown == 0, labels, stats, centres, 4);
  const int around = labels.at<int>(0, 0);
  double sum = 0;
  for (int k = 1; k < parts; ++k) {
    const double area = stats.at<int>(k, cv::CC_STAT_AREA) / (raster.per_mm * raster.per_mm);
    if (k != around && area >= kLeastHole_mm2) sum += area;
  }
  return sum;
}

}  // namespace

Result<void> checkExtent(const TriangleMesh& mesh, const std::string& where) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& v : mesh.vertices) box.extend(v.cast<double>());
  const double extent_mm = mesh.vertices.empty() ? 0 : box.sizes().maxCoeff();
  if (extent_mm > 0 && extent_mm < kLeastExtent_mm)
    return Error::unusable(
        message("This model is only %1 mm in size, smaller than any sherd, so its unit is probably "
                "not mm (%2); export it in mm.",
                decimal(extent_mm, 3),
                extent_mm < kLeastExtent_cm ? message("metres") : message("centimetres")),
        where);
  if (extent_mm <= static_cast<double>(limits::kModelExtent_mm.most)) return {};
  return Error::unusable(message("This model is %1 mm in size, larger than any vessel, so its unit "
                                 "is probably not mm; export it in mm.",
                                 decimal(extent_mm, 0)),
                         where);
}

Raster rasterOver(const Vector2d& size_mm, double per_mm) {
  constexpr double kPixels = limits::kRasterPixels.most, kSide = limits::kImageSide.most;
  if (!size_mm.allFinite()) return {1, 1, per_mm};
  Raster raster;
  raster.per_mm =
      std::min({per_mm, std::sqrt(kPixels / size_mm.prod()), kSide / size_mm.maxCoeff()});
  raster.columns = static_cast<int>(std::ceil(size_mm.x() * raster.per_mm));
  raster.rows = static_cast<int>(std::ceil(size_mm.y() * raster.per_mm));
  return raster;
}

Measures measure(const TriangleMesh& mesh) {
  Measures m;
  if (mesh.triangles.empty()) return m;
  for (const auto& t : mesh.triangles) {
    const Corners p = cornersOf(mesh, t);
    m.area_mm2 += 0.5 * (p.b - p.a).cross(p.c - p.a).norm();
  }
  const VolumeMoment moment = volumeMoment(mesh);
  m.volume_mm3 = moment.volume_mm3;
  m.centroid = moment.centre;
  Vector3d mean;
  Eigen::Matrix3d covariance;
  surfaceMoments(mesh, mean, covariance);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  std::vector<Vector2d> outline;
  for (const Eigen::Vector3f& v : mesh.vertices) {
    const Vector3d d = v.cast<double>() - mean;
    outline.emplace_back(axes.eigenvectors().col(2).dot(d), axes.eigenvectors().col(1).dot(d));
  }
  m.holes_mm2 = holesBetween(mesh, outline);
  const Vector2d sides = smallestRectangle(convexHull(std::move(outline)));
  m.length_mm = sides.maxCoeff();
  m.width_mm = sides.minCoeff();
  std::vector<double> walls = thicknesses(mesh, axes.eigenvectors().col(0));
  if (!walls.empty()) {
    std::sort(walls.begin(), walls.end());
    const auto at = [&](double share) {
      return walls[static_cast<std::size_t>(share * static_cast<double>(walls.size() - 1) + 0.5)];
    };
    m.thickness_min_mm = at(0.02);
    m.thickness_max_mm = at(0.98);
    m.thickness_mean_mm =
        std::accumulate(walls.begin(), walls.end(), 0.0) / static_cast<double>(walls.size());
  }
  return m;
}

}  // namespace ostraka::model
