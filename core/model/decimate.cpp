#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <queue>

#include "base/message.h"

#include "model/model.h"

namespace ostraka::model {
namespace {

using Eigen::Vector3d;

// Sum of squared distances from planes, weighted by area: x' A x + 2 b' x + c.
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  double c = 0, weight = 0;

  void add(const Quadric& q) {
    a += q.a;
    b += q.b;
    c += q.c;
    weight += q.weight;
  }
  // Mean squared distance, mm^2.
  double error(const Vector3d& x) const {
    return weight > 0 ? std::max(0.0, (x.dot(a * x) + 2 * b.dot(x) + c) / weight) : 0;
  }
};

Quadric planeOf(const Vector3d& p, const Vector3d& q, const Vector3d& r) {
  const Vector3d across = (q - p).cross(r - p);
  const double area = 0.5 * across.norm();
  if (!(area > 1e-12)) return {};
  const Vector3d n = across / (2 * area);
  const double d = -n.dot(p);
  return {area * n * n.transpose(), area * d * n, area * d * d, area};
}

struct Collapse {
  double cost;
  int from, to;      // from < to; both go to one place
  unsigned version;  // of both ends together when it was judged
  Vector3d place;

  // Cheapest first in a priority queue; ties by index, so that every run is the same.
  bool operator<(const Collapse& other) const {
    if (cost != other.cost) return cost > other.cost;
    return std::pair(from, to) > std::pair(other.from, other.to);
  }
};

class Decimation {
 public:
  Decimation(const TriangleMesh& mesh, double max_deviation_mm)
      : mesh_(mesh), limit_(max_deviation_mm * max_deviation_mm), triangles_(mesh.triangles) {
    const std::size_t n = mesh.vertices.size();
    faces_.resize(n);
    quadrics_.resize(n);
    version_.assign(n, 0);
    origin_ = mesh.vertices[0].cast<double>();
    for (const Eigen::Vector3f& v : mesh.vertices) points_.push_back(v.cast<double>() - origin_);
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      const auto& t = triangles_[f];
      const Quadric plane = planeOf(points_[t[0]], points_[t[1]], points_[t[2]]);
      for (const int v : t) {
        faces_[v].push_back(static_cast<int>(f));
        quadrics_[v].add(plane);
      }
    }
  }

  TriangleMesh run() {
    for (const auto& t : triangles_)
      for (int k = 0; k < 3; ++k)
        if (t[k] < t[(k + 1) % 3]) judge(t[k], t[(k + 1) % 3]);
    while (!queue_.empty()) {
      const Collapse best = queue_.top();
      queue_.pop();
      if (best.version != version_[best.from] + version_[best.to] || faces_[best.from].empty() ||
          faces_[best.to].empty())
        continue;
      if (keepsManifold(best.from, best.to) && keepsFacing(best)) collapse(best);
    }
    return result();
  }

 private:
  static bool has(const std::array<int, 3>& t, int v) {
    return t[0] == v || t[1] == v || t[2] == v;
  }

  void judge(int a, int b) {
    Quadric q = quadrics_[a];
    q.add(quadrics_[b]);
    Collapse best{INFINITY, std::min(a, b), std::max(a, b), version_[a] + version_[b], {}};
    const auto consider = [&](const Vector3d& place) {
      // A little for the length: flat places thin out evenly.
      const double cost = q.error(place) + 1e-6 * (points_[a] - points_[b]).squaredNorm();
      if (cost < best.cost) {
        best.cost = cost;
        best.place = place;
      }
    };
    const double length = (points_[a] - points_[b]).norm();
    const Vector3d middle = 0.5 * (points_[a] + points_[b]);
    Eigen::Matrix3d a3 = q.a;
    a3.diagonal().array() += 1e-3 * q.weight;  // drawn to the middle where planes leave it free
    const Vector3d free_place = a3.ldlt().solve(-q.b + 1e-3 * q.weight * middle);
    if (free_place.allFinite() && (free_place - middle).norm() < length) consider(free_place);
    consider(middle);
    if (best.cost <= limit_) queue_.push(best);
  }

  void neighbours(int v, std::vector<int>& found) const {
    found.clear();
    for (const int f : faces_[v])
      for (const int u : triangles_[f])
        if (u != v) found.push_back(u);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

  // The link condition: the ends share exactly the two corners opposite their edge.
  bool keepsManifold(int a, int b) {
    neighbours(a, near_a_);
    neighbours(b, near_b_);
    common_.clear();
    std::set_intersection(near_a_.begin(), near_a_.end(), near_b_.begin(), near_b_.end(),
                          std::back_inserter(common_));
    // A tetrahedron would collapse into a flat pair of faces.
    return common_.size() == 2 && near_a_.size() + near_b_.size() > 6 &&
           faces_[common_[0]].size() > 3 && faces_[common_[1]].size() > 3;
  }

  // No face turns by more than 60 degrees or becomes a needle.
  bool keepsFacing(const Collapse& c) const {
    for (const int moved : {c.from, c.to})
      for (const int f : faces_[moved]) {
        const auto& t = triangles_[f];
        if (has(t, c.from) && has(t, c.to)) continue;
        Vector3d p[3], q[3];
        for (int k = 0; k < 3; ++k) {
          p[k] = points_[t[k]];
          q[k] = t[k] == moved ? c.place : p[k];
        }
        const Vector3d before = (p[1] - p[0]).cross(p[2] - p[0]);
        const Vector3d after = (q[1] - q[0]).cross(q[2] - q[0]);
        if (after.dot(before) < 0.5 * after.norm() * before.norm()) return false;
        const double longest = std::max({(q[1] - q[0]).squaredNorm(), (q[2] - q[1]).squaredNorm(),
                                         (q[0] - q[2]).squaredNorm()});
        if (after.norm() < 0.05 * longest) return false;
      }
    return true;
  }

  void collapse(const Collapse& c) {
    points_[c.from] = c.place;
    quadrics_[c.from].add(quadrics_[c.to]);
    for (const int f : faces_[c.to]) {
      auto& t = triangles_[f];
      if (has(t, c.from)) {
        for (const int v : t)
          if (v != c.to) std::erase(faces_[v], f);
        t = {-1, -1, -1};
      } else {
        for (int& v : t)
          if (v == c.to) v = c.from;
        faces_[c.from].push_back(f);
      }
    }
    faces_[c.to].clear();
    ++version_[c.from];
    neighbours(c.from, near_a_);
    for (const int u : near_a_) judge(c.from, u);
  }

  TriangleMesh result() const {
    TriangleMesh out;
    std::vector<int> number(points_.size(), -1);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (faces_[v].empty()) continue;
      number[v] = static_cast<int>(out.vertices.size());
      out.vertices.push_back((points_[v] + origin_).cast<float>());
      if (!mesh_.colors.empty()) out.colors.push_back(mesh_.colors[v]);
      if (!mesh_.seen.empty()) out.seen.push_back(mesh_.seen[v]);
    }
    for (const auto& t : triangles_)
      if (t[0] >= 0) out.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    if (!mesh_.normals.empty()) out.normals = vertexNormals(out);
    return out;
  }

  const TriangleMesh& mesh_;
  double limit_;
  Vector3d origin_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<std::vector<int>> faces_;
  std::vector<Quadric> quadrics_;
  std::vector<unsigned> version_;
  std::vector<Vector3d> points_;
  std::priority_queue<Collapse> queue_;
  std::vector<int> near_a_, near_b_, common_;
};

}  // namespace

Result<TriangleMesh> decimated(const TriangleMesh& mesh, double max_deviation_mm) {
  Message why;
  if (!isClosedManifold(mesh, &why))
    return Error::unusable(inOne(message("Only a closed mesh can be simplified."), why));
  if (!(max_deviation_mm > 0))
    return Error::unusable(
        message("The deviation of a simplified mesh must be greater than 0 mm."));
  return Decimation(mesh, max_deviation_mm).run();
}

}  // namespace ostraka::model
