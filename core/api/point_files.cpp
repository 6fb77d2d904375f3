#include "api/point_files.h"

#include <algorithm>

#include "api/checked.h"
#include "base/message.h"
#include "cloud/ply.h"
#include "files/output_place.h"

namespace ostraka::api {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFrame = "as given";

bool isWhole(const PointCloud& cloud) {
  const auto fits = [&](std::size_t size) { return size == 0 || size == cloud.size(); };
  return fits(cloud.normals.size()) && fits(cloud.colors.size()) && fits(cloud.quality.size());
}

bool isWhole(const TriangleMesh& mesh) {
  const std::size_t count = mesh.vertices.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == count; };
  const auto isVertex = [&](int v) { return v >= 0 && static_cast<std::size_t>(v) < count; };
  return fits(mesh.normals.size()) && fits(mesh.colors.size()) && fits(mesh.seen.size()) &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
           return std::all_of(triangle.begin(), triangle.end(), isVertex);
         });
}

template <class Shape>
Result<void> written(const fs::path& file, const Shape& shape) {
  if (!isWhole(shape))
    return Error::unusable(message("The lists of this cloud or mesh differ in length, or a "
                                   "triangle names a vertex that does not exist; nothing was "
                                   "written."),
                           file.string());
  if (Result<void> good = checkOutputPlace(file); !good) return good;
  return writePly(file, shape, kFrame);
}

}  // namespace

Result<PointCloud> readCloud(const std::filesystem::path& file) {
  return withoutExceptions([&] { return readPlyCloud(file); });
}

Result<void> writeCloud(const std::filesystem::path& file, const PointCloud& cloud) {
  return withoutExceptions([&] { return written(file, cloud); });
}

Result<void> writeMesh(const std::filesystem::path& file, const TriangleMesh& mesh) {
  return withoutExceptions([&] { return written(file, mesh); });
}

}  // namespace ostraka::api
