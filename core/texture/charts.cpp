#include "texture/charts.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <utility>

#include "texture/flat.h"

namespace ostraka::texture {
namespace {

using Corners = std::array<Eigen::Vector2f, 3>;

// A face belongs to the front or the back up to this angle from the axis: less than the slant of a
// usual fracture, more than a wall's own curve turns it within a sherd.
const float kFaceCosine = std::cos(55.0f * static_cast<float>(EIGEN_PI) / 180);
const float kSurelyFace = std::cos(30.0f * static_cast<float>(EIGEN_PI) / 180);
// The least cosine to the direction a chart is seen from: more slant would starve it of texels.
constexpr float kLeastCosine = 0.3f;
// Area of a face unrolled over its own: at corners of the outline the way along it is short or
// long.
constexpr float kLeastStretch = 0.1f, kMostStretch = 3;

constexpr double kWorthAChart = 64;  // texels; a chart's margin is worth more than less of it

struct Faces {
  std::vector<Eigen::Vector3f> normals;
  std::vector<float> areas;                    ///< mm^2
  std::vector<std::array<int, 3>> neighbours;  ///< across the edge from corner k to k + 1; -1: none
};

Faces facesOf(const TriangleMesh& mesh) {
  Faces faces;
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& t = mesh.triangles[f];
    const Eigen::Vector3f cross = (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                                      .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    const float length = cross.norm();
    faces.areas.push_back(length / 2);
    faces.normals.push_back(length > 0 ? Eigen::Vector3f(cross / length) : Eigen::Vector3f::Zero());
    for (std::size_t k = 0; k < 3; ++k) edges[{t[k], t[(k + 1) % 3]}] = static_cast<int>(f);
  }
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> beside{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto other = edges.find({t[(k + 1) % 3], t[k]});
      beside[k] = other == edges.end() ? -1 : other->second;
    }
    faces.neighbours.push_back(beside);
  }
  return faces;
}

// The direction that the most area looks along, to either side; its first two columns span the
// plane in which the sherd lies, right-handed.
Eigen::Matrix3f axesOf(const Faces& faces) {
  Eigen::Matrix3f sum = Eigen::Matrix3f::Zero();
  for (std::size_t f = 0; f < faces.areas.size(); ++f)
    sum += faces.areas[f] * faces.normals[f] * faces.normals[f].transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(sum);
  Eigen::Vector3f axis = solver.eigenvectors().col(2);
  if (axis.z() < 0) axis = -axis;  // the side that lay up in the front's photographs
  // Right is right in the front's photographs as far as the axis allows.
  Eigen::Vector3f right = Eigen::Vector3f::UnitX() - axis.x() * axis;
  if (right.norm() < 0.1f) right = Eigen::Vector3f::UnitY() - axis.y() * axis;
  right.normalize();
  Eigen::Matrix3f axes;
  axes << right, axis.cross(right), axis;
  return axes;
}

std::vector<Part> partsOf(const Faces& faces, const Eigen::Vector3f& axis) {
  std::vector<Part> parts;
  for (const Eigen::Vector3f& n : faces.normals) {
    const float along = n.dot(axis);
    parts.push_back(along > kFaceCosine    ? Part::Front
                    : along < -kFaceCosine ? Part::Back
                                           : Part::Fracture);
  }
  // Single faces that differ from all around them make ragged borders.
  for (int pass = 0; pass < 4; ++pass) {
    std::vector<Part> calmer = parts;
    for (std::size_t f = 0; f < parts.size(); ++f) {
      const auto& beside = faces.neighbours[f];
      for (const Part part : {Part::Front, Part::Back, Part::Fracture}) {
        const float along = faces.normals[f].dot(axis);
        const bool may = part == Part::Fracture
                             ? std::abs(along) < kSurelyFace
                             : (part == Part::Front ? along : -along) > kLeastCosine;
        const auto like = std::ranges::count_if(beside, [&](int other) {
          return other >= 0 && parts[static_cast<std::size_t>(other)] == part;
        });
        if (may && like >= 2) calmer[f] = part;
      }
    }
    parts = std::move(calmer);
  }
  return parts;
}

// Lays faces into the plane one after the other and turns away those that would lie over others.
class Layer {
 public:
  Layer(const TriangleMesh& mesh, double texel_mm) : mesh_(mesh), texel_mm_(texel_mm) {}

  /// The faces that found a place; those that did not are added to `rest`.
  Chart lay(const std::vector<int>& faces, const std::vector<Corners>& corners,
            std::vector<int>& rest) {
    Chart chart;
    Eigen::Vector2f low = Eigen::Vector2f::Constant(INFINITY), high = -low;
    for (const Corners& t : corners)
      for (const Eigen::Vector2f& c : t) low = low.cwiseMin(c), high = high.cwiseMax(c);
    if (faces.empty()) return chart;
    const Eigen::Vector2f size = high - low;
    // Faces are smaller than a texel at times: a chart of 4,000 x 4,000 cells shows what matters.
    const double cell = std::max<double>(texel_mm_, size.maxCoeff() / 4000.0);
    const int width = static_cast<int>(size.x() / cell) + 2,
              height = static_cast<int>(size.y() / cell) + 2;
    std::vector<int> owner(static_cast<std::size_t>(width) * height, -1);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      std::array<Eigen::Vector2d, 3> t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = (corners[i][k] - low).cast<double>() / cell;
      // One texel of another face does not show.
      int taken = 0;
      forEachInside(t, width, height, 0, [&](int x, int y, const Eigen::Vector3d&) {
        const int there = owner[static_cast<std::size_t>(y) * width + x];
        if (there >= 0 && !touch(there, faces[i])) ++taken;
      });
      if (taken > 1) {
        rest.push_back(faces[i]);
        continue;
      }
      forEachInside(t, width, height, 0, [&](int x, int y, const Eigen::Vector3d&) {
        owner[static_cast<std::size_t>(y) * width + x] = faces[i];
      });
      chart.faces.push_back(faces[i]);
      chart.corners.push_back({corners[i][0] - low, corners[i][1] - low, corners[i][2] - low});
    }
    chart.size = size;
    return chart;
  }

 private:
  bool touch(int a, int b) const {
    for (const int v : mesh_.triangles[static_cast<std::size_t>(a)])
      for (const int w : mesh_.triangles[static_cast<std::size_t>(b)])
        if (v == w) return true;
    return false;
  }
  const TriangleMesh& mesh_;
  double texel_mm_;
};

// Seen from where the third of the axes points at; right-handed, so that nothing is mirrored.
Corners seenAlong(const TriangleMesh& mesh, int face, const Eigen::Matrix3f& axes) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3f& p =
        mesh.vertices[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(face)][k])];
    corners[k] = {axes.col(0).dot(p), axes.col(1).dot(p)};
  }
  return corners;
}

// The sherd's outline as one sees it along the axis, smoothed, with the way along it.
class Outline {
 public:
  Outline(const TriangleMesh& mesh, const Eigen::Matrix3f& axes) {
    Eigen::Vector2f low = Eigen::Vector2f::Constant(INFINITY), high = -low;
    std::vector<Eigen::Vector2f> flat;
    for (const Eigen::Vector3f& p : mesh.vertices) {
      flat.emplace_back(axes.col(0).dot(p), axes.col(1).dot(p));
      low = low.cwiseMin(flat.back());
      high = high.cwiseMax(flat.back());
    }
    const float cell = std::max((high - low).maxCoeff() / 400, 1e-6f);
    const auto pixel = [&](const Eigen::Vector2f& p) {
      return cv::Point(static_cast<int>((p.x() - low.x()) / cell) + 4,
                       static_cast<int>((p.y() - low.y()) / cell) + 4);
    };
    const cv::Point last = pixel(high);
    cv::Mat1b filled = cv::Mat1b::zeros(last.y + 5, last.x + 5);
    for (const auto& t : mesh.triangles) {
      const cv::Point corners[3] = {pixel(flat[t[0]]), pixel(flat[t[1]]), pixel(flat[t[2]])};
      cv::fillConvexPoly(filled, corners, 3, cv::Scalar(255));
      cv::polylines(filled, std::vector<cv::Point>(corners, corners + 3), true, cv::Scalar(255));
    }
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(filled, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    if (contours.empty()) return;
    const auto longest = std::ranges::max_element(
        contours, [](const auto& a, const auto& b) { return a.size() < b.size(); });
    const int n = static_cast<int>(longest->size()), window = std::max(1, n / 150);
    for (int i = 0; i < n; ++i) {
      Eigen::Vector2f sum = Eigen::Vector2f::Zero();
      for (int k = -window; k <= window; ++k) {
        const cv::Point& p = (*longest)[static_cast<std::size_t>((i + k + n) % n)];
        sum +=
            Eigen::Vector2f(static_cast<float>(p.x) - 4, static_cast<float>(p.y) - 4) * cell + low;
      }
      points_.push_back(sum / static_cast<float>(2 * window + 1));
    }
    // OpenCV goes clockwise with y down, which is counter-clockwise here; looked at from outside,
    // the way then leads to the right with the axis up.
    float area = 0;
    for (int i = 0; i < n; ++i) {
      const Eigen::Vector2f &a = points_[static_cast<std::size_t>(i)],
                            &b = points_[static_cast<std::size_t>((i + 1) % n)];
      area += a.x() * b.y() - a.y() * b.x();
    }
    if (area < 0) std::reverse(points_.begin(), points_.end());
    way_.push_back(0);
    for (std::size_t i = 1; i <= points_.size(); ++i)
      way_.push_back(way_.back() + (points_[i % points_.size()] - points_[i - 1]).norm());
  }
  bool empty() const { return points_.size() < 8; }
  float length() const { return way_.back(); }

  struct Place {
    float along = 0, off = 0;  ///< mm along the outline, and off it
  };
  Place nearest(const Eigen::Vector2f& p) const {
    Place best{0, INFINITY};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Eigen::Vector2f& a = points_[i];
      const Eigen::Vector2f step = points_[(i + 1) % points_.size()] - a;
      const float length2 = step.squaredNorm();
      const float s = length2 > 0 ? std::clamp((p - a).dot(step) / length2, 0.0f, 1.0f) : 0;
      const float off = (a + s * step - p).norm();
      if (off < best.off) best = {way_[i] + s * std::sqrt(length2), off};
    }
    return best;
  }

 private:
  std::vector<Eigen::Vector2f> points_;
  std::vector<float> way_;
};

// The fracture along the outline: to the right the way along it, up the axis. Faces that this would
// squeeze, turn over or tear go to `rest`.
void unroll(const TriangleMesh& mesh, const Faces& faces, const Eigen::Matrix3f& axes,
            const std::vector<int>& strip, float row_mm, Layer& layer, std::vector<Chart>& charts,
            std::vector<int>& rest) {
  const Outline outline(mesh, axes);
  if (outline.empty()) {
    rest.insert(rest.end(), strip.begin(), strip.end());
    return;
  }
  const int rows = std::max(1, static_cast<int>(std::ceil(outline.length() / row_mm)));
  const float row = outline.length() / static_cast<float>(rows);
  std::vector<std::vector<int>> of_row(static_cast<std::size_t>(rows));
  std::vector<std::vector<Corners>> corners_of_row(static_cast<std::size_t>(rows));
  std::vector<Outline::Place> places(mesh.vertices.size());
  std::vector<char> is_placed(mesh.vertices.size(), 0);
  for (const int f : strip)
    for (const int v : mesh.triangles[static_cast<std::size_t>(f)]) {
      const Eigen::Vector3f& p = mesh.vertices[static_cast<std::size_t>(v)];
      if (!std::exchange(is_placed[static_cast<std::size_t>(v)], 1))
        places[static_cast<std::size_t>(v)] =
            outline.nearest({axes.col(0).dot(p), axes.col(1).dot(p)});
    }
  for (const int f : strip) {
    const auto& t = mesh.triangles[static_cast<std::size_t>(f)];
    Corners corners;
    float first = places[static_cast<std::size_t>(t[0])].along, mean = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(t[k]);
      float along = places[v].along;
      // The way ends where it began.
      if (along - first > outline.length() / 2) along -= outline.length();
      if (first - along > outline.length() / 2) along += outline.length();
      corners[k] = {along, axes.col(2).dot(mesh.vertices[v])};
      mean += along / 3;
    }
    const float stretch =
        crossOf(corners) / 2 / std::max(faces.areas[static_cast<std::size_t>(f)], 1e-12f);
    if (stretch < kLeastStretch || stretch > kMostStretch) {
      rest.push_back(f);
      continue;
    }
    const float turns = outline.length() * std::floor(mean / outline.length());
    const float around = mean - turns;
    for (Eigen::Vector2f& c : corners) c.x() -= turns;
    const auto r =
        static_cast<std::size_t>(std::clamp(static_cast<int>(around / row), 0, rows - 1));
    of_row[r].push_back(f);
    corners_of_row[r].push_back(corners);
  }
  for (std::size_t r = 0; r < of_row.size(); ++r) {
    Chart chart = layer.lay(of_row[r], corners_of_row[r], rest);
    if (!chart.faces.empty()) charts.push_back(std::move(chart));
  }
}

Eigen::Matrix3f axesAlong(const Eigen::Vector3f& axis) {
  Eigen::Matrix3f axes;
  const Eigen::Vector3f right = axis.unitOrthogonal();
  axes << right, axis.cross(right), axis;
  return axes;
}

// Slivers are no charts of their own: each is folded out across an edge of a face that has its
// place. What it covers there it shares, a few texels.
void foldOut(const TriangleMesh& mesh, const Faces& faces, const std::vector<int>& slivers,
             std::vector<Chart>& charts) {
  struct InChart {
    std::size_t chart = 0, index = 0;
  };
  std::map<int, InChart> placed;
  for (std::size_t c = 0; c < charts.size(); ++c)
    for (std::size_t i = 0; i < charts[c].faces.size(); ++i) placed[charts[c].faces[i]] = {c, i};
  const auto corner = [&](int face, int vertex) -> const Eigen::Vector2f& {
    const InChart& at = placed.at(face);
    const auto& t = mesh.triangles[static_cast<std::size_t>(face)];
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), vertex) - t.begin());
    return charts[at.chart].corners[at.index][k];
  };
  std::vector<int> open = slivers;
  while (!open.empty()) {
    std::vector<int> still;
    for (const int f : open) {
      const auto& t = mesh.triangles[static_cast<std::size_t>(f)];
      const auto& beside = faces.neighbours[static_cast<std::size_t>(f)];
      const auto at =
          std::ranges::find_if(beside, [&](int other) { return placed.contains(other); });
      if (at == beside.end()) {
        still.push_back(f);
        continue;
      }
      const auto k = static_cast<std::size_t>(at - beside.begin());
      const auto p = [&](std::size_t i) {
        return mesh.vertices[static_cast<std::size_t>(t[(k + i) % 3])];
      };
      Corners corners;
      const Eigen::Vector2f a = corner(*at, t[k]), b = corner(*at, t[(k + 1) % 3]);
      const Eigen::Vector3f edge = (p(1) - p(0)).normalized();
      const float along = edge.dot(p(2) - p(0)), off = edge.cross(p(2) - p(0)).norm();
      const Eigen::Vector2f u = (b - a).normalized();
      corners[k] = a;
      corners[(k + 1) % 3] = b;
      corners[(k + 2) % 3] = a + along * u + off * Eigen::Vector2f(-u.y(), u.x());
      Chart& chart = charts[placed.at(*at).chart];
      placed[f] = {placed.at(*at).chart, chart.faces.size()};
      chart.faces.push_back(f);
      chart.corners.push_back(corners);
    }
    // A part of the mesh that is all slivers: the first of them is a chart after all.
    if (still.size() == open.size()) {
      placed[still.front()] = {charts.size(), 0};
      charts.push_back(
          {{still.front()},
           {seenAlong(mesh, still.front(),
                      axesAlong(faces.normals[static_cast<std::size_t>(still.front())]))},
           Eigen::Vector2f::Zero()});
      still.erase(still.begin());
    }
    open = std::move(still);
  }
  for (Chart& chart : charts) {
    Eigen::Vector2f low = Eigen::Vector2f::Constant(INFINITY), high = -low;
    for (const Corners& t : chart.corners)
      for (const Eigen::Vector2f& c : t) low = low.cwiseMin(c), high = high.cwiseMax(c);
    for (Corners& t : chart.corners)
      for (Eigen::Vector2f& c : t) c -= low;
    chart.size = high - low;
  }
}

// What is left: grown from its largest face as far as one looks at it from one direction. Faces
// that are not worth a chart come back.
std::vector<int> seenAlongTheirOwn(const TriangleMesh& mesh, const Faces& faces,
                                   std::vector<int> rest, float least_mm2, Layer& layer,
                                   std::vector<Chart>& charts) {
  std::vector<int> slivers;
  std::vector<char> open(mesh.triangles.size(), 0);
  const auto areaOf = [&](int f) { return faces.areas[static_cast<std::size_t>(f)]; };
  while (!rest.empty()) {
    for (const int f : rest) open[static_cast<std::size_t>(f)] = 1;
    const int seed =
        *std::ranges::max_element(rest, [&](int a, int b) { return areaOf(a) < areaOf(b); });
    const Eigen::Vector3f axis = faces.normals[static_cast<std::size_t>(seed)];
    std::vector<int> grown;
    std::queue<int> next({seed});
    open[static_cast<std::size_t>(seed)] = 0;
    float area = 0;
    while (!next.empty()) {
      const int f = next.front();
      next.pop();
      grown.push_back(f);
      area += areaOf(f);
      for (const int other : faces.neighbours[static_cast<std::size_t>(f)])
        if (other >= 0 && open[static_cast<std::size_t>(other)] &&
            faces.normals[static_cast<std::size_t>(other)].dot(axis) > 2 * kLeastCosine) {
          open[static_cast<std::size_t>(other)] = 0;
          next.push(other);
        }
    }
    std::vector<int> again;
    for (const int f : rest)
      if (open[static_cast<std::size_t>(f)]) again.push_back(f);
    if (area < least_mm2) {
      slivers.insert(slivers.end(), grown.begin(), grown.end());
    } else {
      std::vector<Corners> corners;
      for (const int f : grown) corners.push_back(seenAlong(mesh, f, axesAlong(axis)));
      charts.push_back(layer.lay(grown, corners, again));
    }
    rest = std::move(again);
  }
  return slivers;
}

}  // namespace

SherdParts partsOf(const TriangleMesh& mesh) {
  const Faces faces = facesOf(mesh);
  const Eigen::Vector3f axis = axesOf(faces).col(2);
  return {partsOf(faces, axis), axis};
}

std::vector<Chart> chartsOf(const TriangleMesh& mesh, double texel_mm) {
  const Faces faces = facesOf(mesh);
  const Eigen::Matrix3f axes = axesOf(faces);
  const std::vector<Part> parts = partsOf(faces, axes.col(2));
  // Of the back one sees what one sees of a sherd that was turned over: its own right is right.
  Eigen::Matrix3f from_behind;
  from_behind << -axes.col(0), axes.col(1), -axes.col(2);
  Layer layer(mesh, texel_mm);
  std::vector<Chart> charts;
  std::vector<int> rest, strip;
  float row_mm = 0;
  for (const Part part : {Part::Front, Part::Back}) {
    std::vector<int> own;
    std::vector<Corners> corners;
    for (std::size_t f = 0; f < parts.size(); ++f)
      if (parts[f] == part && faces.areas[f] > 0) {
        own.push_back(static_cast<int>(f));
        corners.push_back(seenAlong(mesh, own.back(), part == Part::Front ? axes : from_behind));
      }
    Chart chart = layer.lay(own, corners, rest);
    row_mm = std::max(row_mm, chart.size.x());
    if (!chart.faces.empty()) charts.push_back(std::move(chart));
  }
  for (std::size_t f = 0; f < parts.size(); ++f)
    if (parts[f] == Part::Fracture && faces.areas[f] > 0) strip.push_back(static_cast<int>(f));
  if (!strip.empty())
    unroll(mesh, faces, axes, strip, std::max(row_mm, 1e-3f), layer, charts, rest);
  const auto least_mm2 = static_cast<float>(kWorthAChart * texel_mm * texel_mm);
  const std::vector<int> slivers =
      seenAlongTheirOwn(mesh, faces, std::move(rest), least_mm2, layer, charts);
  foldOut(mesh, faces, slivers, charts);
  return charts;
}

}  // namespace ostraka::texture
