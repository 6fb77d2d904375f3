#include "api/point_files.h"

#include "api/checked.h"
#include "cloud/ply.h"

namespace ostraka::api {
namespace {

constexpr const char* kFrame = "as given";

}  // namespace

Result<PointCloud> readCloud(const std::filesystem::path& file) {
  return withoutExceptions([&] { return readPlyCloud(file); });
}

Result<void> writeCloud(const std::filesystem::path& file, const PointCloud& cloud) {
  return withoutExceptions([&] { return writePly(file, cloud, kFrame); });
}

Result<void> writeMesh(const std::filesystem::path& file, const TriangleMesh& mesh) {
  return withoutExceptions([&] { return writePly(file, mesh, kFrame); });
}

}  // namespace ostraka::api
