#include "api/point_files.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"
#include "tests/core/model/shapes.h"

namespace ostraka::api {
namespace {

namespace fs = std::filesystem;

TEST(PointFiles, WritesNothingThatCannotBeReadOrThatMakesAnArchiveInvalid) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "mesh.ply";
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {}, {{0, 1, 2}}};
  for (const int wrong : {3, -1}) {
    mesh.triangles[0][2] = wrong;
    const Result<void> refused = writeMesh(file, mesh);
    ASSERT_FALSE(refused.has_value()) << wrong;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  }
  mesh.triangles[0][2] = 2;
  mesh.seen = {1};
  EXPECT_FALSE(writeMesh(file, mesh).has_value());
  mesh.seen.clear();
  PointCloud cloud;
  cloud.points = mesh.vertices;
  cloud.normals = {{0, 0, 1}};
  EXPECT_FALSE(writeCloud(file, cloud).has_value());
  EXPECT_FALSE(fs::exists(file));
  ASSERT_TRUE(writeMesh(file, mesh).has_value());
  fs::remove(file);
  ASSERT_TRUE(writeFileAtomically(folder.path() / "bagit.txt", "x"));
  EXPECT_FALSE(writeMesh(file, mesh).has_value());
  EXPECT_FALSE(fs::exists(file));
}

TEST(PointFiles, WritesWhatItReads) {
  const TemporaryFolder folder;
  const PointCloud cloud = scanOfBox(model::BoxScan{}, false, 1);
  ASSERT_TRUE(writeCloud(folder.path() / "box.ply", cloud).has_value());
  const Result<PointCloud> read = readCloud(folder.path() / "box.ply");
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_EQ(read->points, cloud.points);
  ASSERT_EQ(read->normals.size(), cloud.normals.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)  // made unit vectors again
    EXPECT_TRUE(read->normals[i].isApprox(cloud.normals[i], 1e-5f));
}

}  // namespace
}  // namespace ostraka::api
