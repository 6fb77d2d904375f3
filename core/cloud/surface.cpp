#include "cloud/surface.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/parallel.h"

namespace ostraka {
namespace {

constexpr int kLeafItems = 4;

double squaredDistanceToBox(const Eigen::Vector3d& p, const Eigen::Vector3d& low,
                            const Eigen::Vector3d& high) {
  return (low - p).cwiseMax(p - high).cwiseMax(0).squaredNorm();
}

}  // namespace

Eigen::Vector3d closestOnTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 - d3 > 0) return a + d1 / (d1 - d3) * ab;
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 - d6 > 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  const double along = d4 - d3, back = d5 - d6;
  if (va <= 0 && along >= 0 && back >= 0 && along + back > 0)
    return b + along / (along + back) * (c - b);
  const double sum = va + vb + vc;
  if (!(sum > 0)) return a;  // a triangle without area whose corners coincide
  return a + vb / sum * ab + vc / sum * ac;
}

Surface::Surface(const TriangleMesh& mesh) {
  for (const Eigen::Vector3f& v : mesh.vertices) vertices_.push_back(v.cast<double>());
  items_ = mesh.triangles;
  if (items_.empty())
    for (int v = 0; v < static_cast<int>(vertices_.size()); ++v) items_.push_back({v, v, v});
  order_.resize(items_.size());
  std::iota(order_.begin(), order_.end(), 0);
  // Of triangles that repeat each other no box is nearer than the rest, and all would be searched.
  std::vector<std::array<int, 3>> corners = items_;
  for (std::array<int, 3>& t : corners) std::ranges::sort(t);
  std::ranges::sort(order_, [&](int x, int y) {
    return corners[x] != corners[y] ? corners[x] < corners[y] : x < y;
  });
  const auto repeated = std::ranges::unique(order_, {}, [&](int i) { return corners[i]; });
  order_.erase(repeated.begin(), repeated.end());
  std::ranges::sort(order_);
  nodes_.reserve(order_.size());
  build(0, static_cast<int>(order_.size()));
}

void Surface::boxOf(int item, Eigen::Vector3d& low, Eigen::Vector3d& high) const {
  for (const int v : items_[item]) {
    low = low.cwiseMin(vertices_[v]);
    high = high.cwiseMax(vertices_[v]);
  }
}

int Surface::build(int first, int count) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Node node;
  node.low.setConstant(std::numeric_limits<double>::infinity());
  node.high = -node.low;
  for (int i = first; i < first + count; ++i) boxOf(order_[i], node.low, node.high);
  if (count <= kLeafItems) {
    node.first = first;
    node.count = count;
  } else {
    int axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const auto middle = [&](int item) {
      const std::array<int, 3>& t = items_[item];
      return vertices_[t[0]][axis] + vertices_[t[1]][axis] + vertices_[t[2]][axis];
    };
    const int left = count / 2;
    std::nth_element(order_.begin() + first, order_.begin() + first + left,
                     order_.begin() + first + count, [&](int x, int y) {
                       const double mx = middle(x), my = middle(y);
                       return mx != my ? mx < my : x < y;
                     });
    build(first, left);  // the left child stands right after its parent
    node.first = build(first + left, count - left);
  }
  nodes_[index] = node;
  return index;
}

SurfacePoint Surface::closest(const Eigen::Vector3d& query) const {
  double best = std::numeric_limits<double>::infinity();
  Eigen::Vector3d best_point = Eigen::Vector3d::Zero();
  int best_item = -1;
  struct Waiting {
    int node;
    double squared;
  };
  std::array<Waiting, 64> stack;  // depth is at most log2 of 2^31 items
  int top = 0;
  stack[top++] = {0, squaredDistanceToBox(query, nodes_[0].low, nodes_[0].high)};
  while (top > 0) {
    const Waiting waiting = stack[--top];
    if (waiting.squared >= best) continue;
    const Node& node = nodes_[waiting.node];
    if (node.count > 0) {
      for (int i = node.first; i < node.first + node.count; ++i) {
        const std::array<int, 3>& t = items_[order_[i]];
        const Eigen::Vector3d at =
            closestOnTriangle(query, vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]);
        const double squared = (at - query).squaredNorm();
        if (squared < best) {
          best = squared;
          best_point = at;
          best_item = order_[i];
        }
      }
      continue;
    }
    const int left = waiting.node + 1, right = node.first;
    const double dl = squaredDistanceToBox(query, nodes_[left].low, nodes_[left].high);
    const double dr = squaredDistanceToBox(query, nodes_[right].low, nodes_[right].high);
    if (dl < dr) {
      stack[top++] = {right, dr};
      stack[top++] = {left, dl};
    } else {
      stack[top++] = {left, dl};
      stack[top++] = {right, dr};
    }
  }
  return {std::sqrt(best), best_point, best_item};
}

std::vector<SurfacePoint> Surface::closest(std::span<const Eigen::Vector3d> queries, int threads,
                                           const std::stop_token& stop) const {
  std::vector<SurfacePoint> found(queries.size());
  parallelForRanges(queries.size(), 1024, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !stop.stop_requested(); ++i)
      found[i] = closest(queries[i]);
  });
  return found;
}

}  // namespace ostraka
