#include "vessels/given_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "cloud/ply.h"

namespace ostraka::vessels {
namespace {

constexpr double kSmallest_mm = 5, kLargest_mm = 300;
constexpr std::size_t kMostTriangles = 500'000;

using Edge = std::pair<int, int>;

// Each edge is walked once in either direction.
bool closed(const TriangleMesh& mesh) {
  std::map<Edge, int> walks;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++walks[{t[k], t[(k + 1) % 3]}];
  return !walks.empty() && std::all_of(walks.begin(), walks.end(), [&](const auto& walk) {
    const auto back = walks.find({walk.first.second, walk.first.first});
    return walk.second == 1 && back != walks.end() && back->second == 1;
  });
}

double longestEdge(const TriangleMesh& mesh) {
  float longest = 0;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      longest =
          std::max(longest, (mesh.vertices[t[k]] - mesh.vertices[t[(k + 1) % 3]]).squaredNorm());
  return std::sqrt(longest);
}

Color between(const Color& a, const Color& b) {
  Color middle;
  for (std::size_t c = 0; c < middle.size(); ++c)
    middle[c] = static_cast<std::uint8_t>((a[c] + b[c] + 1) / 2);
  return middle;
}

// Each edge that is too long is halved, for both of its triangles.
TriangleMesh withHalvedEdges(TriangleMesh mesh) {
  std::map<Edge, int> middles;
  const auto middle = [&](int a, int b) {  // -1: short enough
    if ((mesh.vertices[a] - mesh.vertices[b]).norm() <= kMostEdge_mm) return -1;
    const auto [at, fresh] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                 static_cast<int>(mesh.vertices.size()));
    if (fresh) {
      mesh.vertices.push_back(0.5f * (mesh.vertices[a] + mesh.vertices[b]));
      if (!mesh.colors.empty()) mesh.colors.push_back(between(mesh.colors[a], mesh.colors[b]));
    }
    return at->second;
  };
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(4 * mesh.triangles.size());
  for (std::array<int, 3> t : mesh.triangles) {
    std::array<int, 3> m{middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
    const auto halved = std::count_if(m.begin(), m.end(), [](int v) { return v >= 0; });
    // Turned so that the first edge is halved, and with two the second, too.
    while ((halved > 0 && m[0] < 0) || (halved == 2 && m[1] < 0)) {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
    const auto [a, b, c] = t;
    const auto [ab, bc, ca] = m;
    if (halved == 0)
      triangles.push_back(t);
    else if (halved == 1)
      triangles.insert(triangles.end(), {{a, ab, c}, {ab, b, c}});
    else if (halved == 2)
      triangles.insert(triangles.end(), {{a, ab, bc}, {ab, b, bc}, {a, bc, c}});
    else
      triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(triangles);
  return mesh;
}

}  // namespace

Result<VirtualSherd> sherdOfMesh(const std::filesystem::path& file) {
  const Result<PlyContents> read = readPly(file);
  if (!read) return read.error();
  const auto refused = [&](const char* why) { return Error::unusable(why, file.string()); };
  constexpr const char* kTooMany = "The mesh needs more than 500,000 triangles of 1 mm.";
  if (read->mesh.triangles.size() > kMostTriangles) return refused(kTooMany);
  VirtualSherd sherd;
  sherd.mesh.vertices = read->mesh.vertices;
  sherd.mesh.triangles = read->mesh.triangles;
  sherd.mesh.colors = read->mesh.colors;
  if (!closed(sherd.mesh)) return refused("The mesh is not closed: it has no inside to weigh.");
  if (longestEdge(sherd.mesh) > kLargest_mm) return refused("The mesh is larger than 300 mm.");
  while (longestEdge(sherd.mesh) > kMostEdge_mm) {
    sherd.mesh = withHalvedEdges(std::move(sherd.mesh));
    if (sherd.mesh.triangles.size() > kMostTriangles) return refused(kTooMany);
  }

  Eigen::Vector3d centre;
  sherd.volume_mm3 = enclosedVolume(sherd.mesh, &centre);
  if (!(sherd.volume_mm3 > 0)) return refused("The mesh is inside out.");
  Eigen::AlignedBox3f box;
  for (Eigen::Vector3f& v : sherd.mesh.vertices) {
    v -= centre.cast<float>();
    box.extend(v);
  }
  if (box.sizes().maxCoeff() < kSmallest_mm || box.sizes().maxCoeff() > kLargest_mm)
    return refused("The mesh is not between 5 and 300 mm large.");
  sherd.width_mm = box.sizes().head<2>().maxCoeff();
  sherd.kind = file.stem().string();
  for (const Eigen::Vector3f& v : sherd.mesh.vertices)
    sherd.places.push_back({v.x() + v.y(), v.z(), 0, 0});
  return sherd;
}

}  // namespace ostraka::vessels
