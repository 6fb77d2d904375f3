#include "model/contouring.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace ostraka::model {
namespace {

using Eigen::Vector3f;

// Corner k of a cell: x = k & 1, y = k >> 1 & 1, z = k >> 2. Edge 4 a + m runs along axis a.
struct CellEdge {
  int from, to, axis;
};

constexpr std::array<CellEdge, 12> kEdges = {{{0, 1, 0},
                                              {2, 3, 0},
                                              {4, 5, 0},
                                              {6, 7, 0},
                                              {0, 2, 1},
                                              {1, 3, 1},
                                              {4, 6, 1},
                                              {5, 7, 1},
                                              {0, 4, 2},
                                              {1, 5, 2},
                                              {2, 6, 2},
                                              {3, 7, 2}}};

int edgeBetween(int a, int b) {
  for (int e = 0; e < 12; ++e)
    if ((kEdges[e].from == a && kEdges[e].to == b) || (kEdges[e].from == b && kEdges[e].to == a))
      return e;
  return -1;
}

// The corners of each face, counter-clockwise seen from outside the cell.
constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                              {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

// The polygons of a cell, as edges in order, outward; one list per pattern of inside corners.
struct Polygons {
  std::vector<std::vector<int>> loops;
};

// Walking round a face counter-clockwise (seen from outside the cell), the surface's segment runs
// from the crossing that leaves the inside to the crossing that enters it next to it: corners
// inside lie then to the left of ... so the loop of segments has the inside on one constant side.
Polygons polygonsOf(int inside) {
  std::array<int, 12> next;
  next.fill(-1);
  for (const auto& face : kFaces) {
    for (int k = 0; k < 4; ++k) {
      const auto in = [&](int i) { return (inside >> face[i & 3]) & 1; };
      if (in(k) || !in(k + 1)) continue;  // entering the inside between k and k + 1
      // The run of inside corners that starts here ends where the inside is left: each run is cut
      // off by itself, so outside corners that face each other stay joined.
      int last = k + 1;
      while (in(last + 1)) ++last;
      const int enter = edgeBetween(face[k & 3], face[(k + 1) & 3]);
      const int leave = edgeBetween(face[last & 3], face[(last + 1) & 3]);
      next[enter] = leave;
    }
  }
  Polygons found;
  std::array<bool, 12> used{};
  for (int e = 0; e < 12; ++e) {
    if (used[e] || next[e] < 0) continue;
    std::vector<int> loop;
    for (int at = e; !used[at]; at = next[at]) {
      used[at] = true;
      loop.push_back(at);
    }
    found.loops.push_back(std::move(loop));
  }
  return found;
}

const std::array<Polygons, 256>& polygonTable() {
  static const std::array<Polygons, 256> table = [] {
    std::array<Polygons, 256> t;
    for (int i = 0; i < 256; ++i) t[static_cast<std::size_t>(i)] = polygonsOf(i);
    return t;
  }();
  return table;
}

class Contouring {
 public:
  explicit Contouring(const Grid& grid) : grid_(grid) {
    layer_ = static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
    for (auto& v : vertex_) v.assign(layer_ * 3, -1);
  }

  TriangleMesh run() {
    for (int z = 0; z + 1 < grid_.size[2]; ++z) {
      for (int y = 0; y + 1 < grid_.size[1]; ++y)
        for (int x = 0; x + 1 < grid_.size[0]; ++x) visitCell(x, y, z);
      std::swap(vertex_[0], vertex_[1]);
      std::fill(vertex_[1].begin(), vertex_[1].end(), -1);
    }
    return std::move(mesh_);
  }

 private:
  void visitCell(int x, int y, int z) {
    const std::size_t first = grid_.at(x, y, z), row = static_cast<std::size_t>(grid_.size[0]);
    int inside = 0;
    float corner[8];
    for (int k = 0; k < 8; ++k) {
      corner[k] = grid_.values[first + (k & 1) + ((k >> 1) & 1) * row + (k >> 2) * layer_];
      inside |= (corner[k] < 0) << k;
    }
    if (inside == 0 || inside == 255) return;
    for (const std::vector<int>& loop : polygonTable()[static_cast<std::size_t>(inside)].loops) {
      polygon_.clear();
      for (const int e : loop) polygon_.push_back(vertexOn(e, x, y, z, corner));
      fill();
    }
  }

  int vertexOn(int e, int x, int y, int z, const float (&corner)[8]) {
    const CellEdge& edge = kEdges[static_cast<std::size_t>(e)];
    const int dx = edge.from & 1, dy = (edge.from >> 1) & 1, dz = edge.from >> 2;
    int& slot =
        vertex_[dz][(static_cast<std::size_t>(y + dy) * grid_.size[0] + (x + dx)) * 3 + edge.axis];
    if (slot >= 0) return slot;
    const float a = corner[edge.from], b = corner[edge.to];
    // Kept off the nodes: no two vertices of a cell fall together.
    const float t = std::clamp(a / (a - b), 0.02f, 0.98f);
    Vector3f p = grid_.node(x + dx, y + dy, z + dz);
    p[edge.axis] += t * grid_.cell_mm;
    slot = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.push_back(p);
    return slot;
  }

  void fill() {
    const std::size_t n = polygon_.size();
    if (n == 3) {
      mesh_.triangles.push_back({polygon_[0], polygon_[1], polygon_[2]});
      return;
    }
    if (n == 4) {
      const auto d = [&](int i, int j) {
        return (mesh_.vertices[polygon_[i]] - mesh_.vertices[polygon_[j]]).squaredNorm();
      };
      const int s = d(0, 2) <= d(1, 3) ? 0 : 1;  // the shorter diagonal
      mesh_.triangles.push_back({polygon_[s], polygon_[s + 1], polygon_[s + 2]});
      mesh_.triangles.push_back({polygon_[s], polygon_[s + 2], polygon_[(s + 3) & 3]});
      return;
    }
    Vector3f middle = Vector3f::Zero();
    for (const int v : polygon_) middle += mesh_.vertices[v];
    const int m = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.push_back(middle / static_cast<float>(n));
    for (std::size_t k = 0; k < n; ++k)
      mesh_.triangles.push_back({polygon_[k], polygon_[(k + 1) % n], m});
  }

  const Grid& grid_;
  std::size_t layer_;
  std::vector<int> vertex_[2];  // of the edges from this layer's nodes and the next one's
  std::vector<int> polygon_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh contour(const Grid& distance) {
  return Contouring(distance).run();
}

TriangleMesh largestPart(const TriangleMesh& mesh) {
  std::vector<int> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& t : mesh.triangles)
    for (int k = 1; k < 3; ++k) {
      const int a = root(t[0]), b = root(t[k]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  std::vector<double> volume(mesh.vertices.size(), 0.0);
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[t[0]].cast<double>(),
                          b = mesh.vertices[t[1]].cast<double>();
    volume[root(t[0])] += a.dot(b.cross(mesh.vertices[t[2]].cast<double>())) / 6;
  }
  if (volume.empty()) return {};
  const int best =
      static_cast<int>(std::max_element(volume.begin(), volume.end()) - volume.begin());
  TriangleMesh part;
  std::vector<int> number(mesh.vertices.size(), -1);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (root(static_cast<int>(v)) == best) {
      number[v] = static_cast<int>(part.vertices.size());
      part.vertices.push_back(mesh.vertices[v]);
    }
  for (const auto& t : mesh.triangles)
    if (number[t[0]] >= 0) part.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return part;
}

}  // namespace ostraka::model
