#include <gmock/gmock.h>

#include <cstring>
#include <filesystem>

#include "cloud/ply.h"

namespace ostraka {
namespace {

PointCloud fullCloud() {
  PointCloud cloud;
  cloud.points = {{0.1f, -2, 3e5f}, {4, 5, 6}, {-7, 8, 9}};
  cloud.normals = {{1, 0, 0}, {0, 0.6f, 0.8f}, {0, 0, -1}};
  cloud.colors = {{0, 1, 255}, {10, 20, 30}, {128, 127, 126}};
  cloud.quality = {0, 0.5f, 1};
  return cloud;
}

TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

TEST(PlyWrite, CloudsComeBackByteForByte) {
  const std::string bytes = formatPly(fullCloud(), "plate_front");
  const auto read = parsePly(bytes, "x.ply");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->quality, fullCloud().quality);
  EXPECT_EQ(read->mesh.colors, fullCloud().colors);
  const PointCloud again{read->mesh.vertices, read->mesh.normals, read->mesh.colors, read->quality};
  EXPECT_EQ(formatPly(again, "plate_front"), bytes);
}

TEST(PlyWrite, MeshesComeBackByteForByteWithWhatWasSeen) {
  TriangleMesh mesh = tetrahedron();
  mesh.seen = {1, 1, 0, 1};
  const std::string bytes = formatPly(mesh, "model");
  const auto read = parsePly(bytes, "x.ply");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->mesh.triangles, mesh.triangles);
  EXPECT_EQ(read->mesh.seen, mesh.seen);
  EXPECT_EQ(formatPly(read->mesh, "model"), bytes);
}

TEST(PlyWrite, PlacesInAPictureStandInTheFacesAndTheSurfaceStaysAsItIs) {
  TriangleMesh mesh = tetrahedron();
  mesh.seen = {1, 1, 0, 1};
  CornerPlaces places(4);
  places[0] = {Eigen::Vector2f(0, 0), Eigen::Vector2f(0.25f, 0.75f), Eigen::Vector2f(1, 0.5f)};
  for (std::size_t f = 1; f < 4; ++f) places[f].fill(Eigen::Vector2f::Zero());
  const std::string bytes = formatPly(mesh, "model", places);
  EXPECT_NE(bytes.find("property list uchar int vertex_indices\n"
                       "property list uchar float texcoord\nproperty uchar seen\n"),
            std::string::npos);
  const std::size_t vertices = bytes.find("end_header\n") + 11, faces = vertices + 4 * 13;
  ASSERT_EQ(bytes.size(), faces + 4 * (1 + 12 + 1 + 24 + 1));
  EXPECT_EQ(bytes[faces + 13], 6);
  float written[6];
  std::memcpy(written, bytes.data() + faces + 14, sizeof written);
  EXPECT_THAT(written, testing::ElementsAre(0, 1, 0.25f, 0.25f, 1, 0.5f)) << "upwards";
  const auto read = parsePly(bytes, "x.ply");
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_EQ(formatPly(read->mesh, "model"), formatPly(mesh, "model"));
}

TEST(PlyWrite, HeadersNameUnitAndFrame) {
  const std::string bytes = formatPly(fullCloud(), "plate_back");
  EXPECT_TRUE(bytes.starts_with("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_NE(bytes.find("\ncomment unit mm\ncomment frame plate_back\n"), std::string::npos);
}

TEST(PlyWrite, APointTakesTheBytesThatItsHeaderStates) {
  PointCloud cloud;
  cloud.points = {{1, -2, 0.5f}};
  cloud.colors = {{7, 8, 255}};
  cloud.quality = {0.25f};
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment unit mm\ncomment frame f\n"
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\n"
      "end_header\n";
  // IEEE 754: 1 is 3F800000, -2 is C0000000, 0.5 is 3F000000, 0.25 is 3E800000.
  const std::string point(
      "\0\0\x80\x3F"
      "\0\0\0\xC0"
      "\0\0\0\x3F"
      "\x07\x08\xFF"
      "\0\0\x80\x3E",
      19);
  EXPECT_EQ(formatPly(cloud, "f"), header + point);
}

TEST(PlyWrite, IsWholeOrTheErrorNamesTheFile) {
  const std::string path = testing::TempDir() + "ostraka_written.ply";
  ASSERT_TRUE(writePly(path, tetrahedron(), "model").has_value());
  const auto read = readPly(path);
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_EQ(read->mesh.triangles, tetrahedron().triangles);
  std::filesystem::remove(path);
  const auto refused = writePly("/dev/null/x.ply", fullCloud(), "model");
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::CannotWrite);
  EXPECT_NE(refused.error().sentence().english().find("/dev/null"), std::string::npos);
}

}  // namespace
}  // namespace ostraka
