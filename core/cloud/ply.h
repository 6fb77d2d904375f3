#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka {

struct PlyContents {
  TriangleMesh mesh;           ///< triangles empty for a cloud; polygons are fanned
  std::vector<float> quality;  ///< property quality or confidence; empty when absent
  int dropped_not_finite = 0;  ///< points with NaN or infinity, left out with their faces
};

/// ascii, binary_little_endian and binary_big_endian 1.0. Counts are compared with the file's size
/// before anything is allocated; faces that name absent vertices are an error, and so is a `comment
/// unit` other than mm. `where` names the
/// file.
Result<PlyContents> parsePly(std::string_view bytes, const std::string& where);
Result<PlyContents> readPly(const std::filesystem::path& path);
/// The points of a file, faces left aside. Errors as above, and when there is no point.
Result<PointCloud> readPlyCloud(const std::filesystem::path& path);
/// For names that another file states: nothing outside of the folder is opened (OpenFile::within).
Result<PlyContents> readPlyWithin(const std::filesystem::path& folder, std::string_view path);
Result<PointCloud> readPlyCloudWithin(const std::filesystem::path& folder, std::string_view path);

/// Binary little-endian with `comment unit mm` and `comment frame <frame>`.
std::string formatPly(const PointCloud& cloud, std::string_view frame);
std::string formatPly(const TriangleMesh& mesh, std::string_view frame);
/// Of each triangle its corners' places in a picture, 0..1 from the picture's top left corner.
using CornerPlaces = std::vector<std::array<Eigen::Vector2f, 3>>;
/// With these as `texcoord` of each face, which MeshLab, CloudCompare and three.js read: the
/// vertices stay as they are, and the surface closed. `comment TextureFile` with the picture's name
/// is for whoever writes that beside it. places: one for each triangle.
std::string formatPly(const TriangleMesh& mesh, std::string_view frame, const CornerPlaces& places);
Result<void> writePly(const std::filesystem::path& path, const PointCloud& cloud,
                      std::string_view frame);
Result<void> writePly(const std::filesystem::path& path, const TriangleMesh& mesh,
                      std::string_view frame);

}  // namespace ostraka
