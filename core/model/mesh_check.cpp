#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/message.h"

#include "model/model.h"

namespace ostraka::model {
namespace {

bool fail(Message* why, Message words) {
  if (why) *why = std::move(words);
  return false;
}

std::string name(int a, int b) {
  return std::to_string(a) + "-" + std::to_string(b);
}

// Directed edges sorted by key; false when one is used twice or lacks its opposite.
bool edgesPair(const TriangleMesh& mesh, Message* why) {
  std::vector<std::uint64_t> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      edges.push_back(static_cast<std::uint64_t>(t[k]) << 32 |
                      static_cast<std::uint32_t>(t[(k + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const int a = static_cast<int>(edges[i] >> 32), b = static_cast<int>(edges[i] & 0xffffffffu);
    if (i > 0 && edges[i] == edges[i - 1])
      return fail(why,
                  message("Edge %1 is used more than once in the same direction.", name(a, b)));
    const std::uint64_t opposite = edges[i] << 32 | edges[i] >> 32;
    if (!std::binary_search(edges.begin(), edges.end(), opposite))
      return fail(why, message("Edge %1 has a face on one side only.", name(a, b)));
  }
  return true;
}

// Each vertex's triangles form one closed fan.
bool oneFanEach(const TriangleMesh& mesh, Message* why) {
  const std::size_t n = mesh.vertices.size();
  std::vector<int> start(n + 1, 0);
  for (const auto& t : mesh.triangles)
    for (const int v : t) ++start[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 0; v < n; ++v) start[v + 1] += start[v];
  std::vector<std::pair<int, int>> spoke(mesh.triangles.size() *
                                         3);  // (next, after next) round a vertex
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      spoke[static_cast<std::size_t>(fill[t[k]]++)] = {t[(k + 1) % 3], t[(k + 2) % 3]};
  for (std::size_t v = 0; v < n; ++v) {
    const auto begin = spoke.begin() + start[v], end = spoke.begin() + start[v + 1];
    if (begin == end) return fail(why, message("Vertex %1 belongs to no face.", v));
    int at = begin->second, steps = 1;
    while (at != begin->first && steps <= end - begin) {
      const auto next = std::find_if(begin, end, [&](const auto& s) { return s.first == at; });
      if (next == end) break;
      at = next->second;
      ++steps;
    }
    if (steps != end - begin)
      return fail(why, message("Vertex %1 joins two separate fans of faces.", v));
  }
  return true;
}

}  // namespace

bool isClosedManifold(const TriangleMesh& mesh, Message* why) {
  if (mesh.triangles.empty()) return fail(why, message("The mesh has no faces."));
  const int n = static_cast<int>(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    if (std::min({t[0], t[1], t[2]}) < 0 || std::max({t[0], t[1], t[2]}) >= n)
      return fail(why, message("A face refers to a vertex that does not exist."));
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      return fail(why, message("A face has the same vertex twice."));
  }
  return edgesPair(mesh, why) && oneFanEach(mesh, why);
}

std::vector<Eigen::Vector3f> vertexNormals(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.vertices.size(), Eigen::Vector3f::Zero());
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f p[3] = {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    const Eigen::Vector3f across = (p[1] - p[0]).cross(p[2] - p[0]);
    const float length = across.norm();
    if (!(length > 1e-20f)) continue;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3f a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
      normals[t[k]] += across / length * std::atan2(length, a.dot(b));
    }
  }
  for (Eigen::Vector3f& n : normals) {
    const float length = n.norm();
    n = length > 1e-12f ? Eigen::Vector3f(n / length) : Eigen::Vector3f::UnitZ();
  }
  return normals;
}

}  // namespace ostraka::model
