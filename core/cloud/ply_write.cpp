#include <bit>

#include "cloud/ply.h"
#include "files/files.h"

namespace ostraka {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY writing assumes little endian");

template <class T>
void appendValue(std::string& bytes, const T& value) {
  const char* raw = reinterpret_cast<const char*>(&value);
  bytes.append(raw, sizeof value);
}

enum class Faces { None, Plain, Placed };

std::string headerText(const TriangleMesh& mesh, bool quality, std::string_view frame,
                       Faces faces) {
  std::string h = "ply\nformat binary_little_endian 1.0\ncomment unit mm\ncomment frame " +
                  std::string(frame) + "\nelement vertex " + std::to_string(mesh.vertices.size()) +
                  "\nproperty float x\nproperty float y\nproperty float z\n";
  if (!mesh.normals.empty()) h += "property float nx\nproperty float ny\nproperty float nz\n";
  if (!mesh.colors.empty()) h += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (quality) h += "property float quality\n";
  if (!mesh.seen.empty()) h += "property uchar scalar_seen\n";
  if (faces != Faces::None) {
    h += "element face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\n";
    if (faces == Faces::Placed) h += "property list uchar float texcoord\n";
    if (!mesh.seen.empty()) h += "property uchar seen\n";
  }
  return h + "end_header\n";
}

void appendVertices(std::string& bytes, const TriangleMesh& mesh,
                    const std::vector<float>& quality) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (int k = 0; k < 3; ++k) appendValue(bytes, mesh.vertices[i][k]);
    if (!mesh.normals.empty())
      for (int k = 0; k < 3; ++k) appendValue(bytes, mesh.normals[i][k]);
    if (!mesh.colors.empty()) appendValue(bytes, mesh.colors[i]);
    if (!quality.empty()) appendValue(bytes, quality[i]);
    if (!mesh.seen.empty()) appendValue(bytes, mesh.seen[i]);
  }
}

// places: null, or of each triangle.
std::string formatted(const TriangleMesh& mesh, std::string_view frame,
                      const CornerPlaces* places) {
  std::string bytes =
      headerText(mesh, false, frame, places == nullptr ? Faces::Plain : Faces::Placed);
  appendVertices(bytes, mesh, {});
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::array<int, 3>& t = mesh.triangles[i];
    bytes += '\3';
    appendValue(bytes, t);
    if (places != nullptr) {
      bytes += '\6';
      for (const Eigen::Vector2f& place : (*places)[i]) {
        appendValue(bytes, place.x());
        appendValue(bytes, 1 - place.y());  // from the picture's lower left corner
      }
    }
    if (!mesh.seen.empty())
      bytes += mesh.seen[t[0]] && mesh.seen[t[1]] && mesh.seen[t[2]] ? '\1' : '\0';
  }
  return bytes;
}

}  // namespace

std::string formatPly(const PointCloud& cloud, std::string_view frame) {
  const TriangleMesh mesh{cloud.points, cloud.normals, cloud.colors, {}, {}};
  std::string bytes = headerText(mesh, !cloud.quality.empty(), frame, Faces::None);
  appendVertices(bytes, mesh, cloud.quality);
  return bytes;
}

std::string formatPly(const TriangleMesh& mesh, std::string_view frame) {
  return formatted(mesh, frame, nullptr);
}

std::string formatPly(const TriangleMesh& mesh, std::string_view frame,
                      const CornerPlaces& places) {
  return formatted(mesh, frame, &places);
}

Result<void> writePly(const std::filesystem::path& path, const PointCloud& cloud,
                      std::string_view frame) {
  return writeFileAtomically(path, formatPly(cloud, frame));
}

Result<void> writePly(const std::filesystem::path& path, const TriangleMesh& mesh,
                      std::string_view frame) {
  return writeFileAtomically(path, formatPly(mesh, frame));
}

}  // namespace ostraka
