#include "cloud/ply.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace ostraka {
namespace {

std::string bigEndian(float value) {
  char raw[4];
  std::memcpy(raw, &value, 4);
  return {raw[3], raw[2], raw[1], raw[0]};
}

TEST(Ply, NormalsStayAsTheyAreOnceTheyAreOfUnitLength) {
  PointCloud cloud;
  for (int i = 0; i < 400; ++i) {
    cloud.points.emplace_back(static_cast<float>(i), 0, 0);
    cloud.normals.emplace_back(std::sin(0.7f * i), std::cos(1.3f * i), std::sin(2.1f * i + 1));
    if (i % 2 == 0) cloud.normals.back().normalize();
  }
  const auto normalsOf = [](const std::string& bytes) {
    return parsePly(bytes, "x.ply")->mesh.normals;
  };
  const auto original = cloud.normals;
  cloud.normals = normalsOf(formatPly(cloud, "model"));
  for (std::size_t i = 0; i < original.size(); ++i) {
    EXPECT_NEAR(cloud.normals[i].norm(), 1, 1e-6) << i;
    if (i % 2 == 0) {
      EXPECT_EQ(cloud.normals[i], original[i]) << "was of unit length: " << i;
    }
  }
  EXPECT_EQ(normalsOf(formatPly(cloud, "model")), cloud.normals);
}

TEST(Ply, AsciiIsReadWithOddSpacingAndWindowsLines) {
  const auto read = parsePly(
      "ply\r\nformat ascii 1.0\r\nelement vertex 2\r\nproperty double x\r\nproperty float y\r\n"
      "property int z\r\nelement face 1\r\nproperty list uchar int vertex_index\r\nend_header\r\n"
      " 1.5  -2e1 3\r\n\r\n4 +5 6\r\n3 0 1 0\r\n",
      "x.ply");
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_EQ(read->mesh.vertices, (std::vector<Eigen::Vector3f>{{1.5f, -20, 3}, {4, 5, 6}}));
  EXPECT_EQ(read->mesh.triangles.size(), 1u);
}

TEST(Ply, BigEndianIsRead) {
  const std::string header =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty ushort red\nend_header\n";
  const auto read =
      parsePly(header + bigEndian(1.25f) + bigEndian(-3) + bigEndian(1e-3f) + "\1\2", "x");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->mesh.vertices[0], Eigen::Vector3f(1.25f, -3, 1e-3f));
}

TEST(Ply, PolygonsAreFannedAndOtherElementsSkipped) {
  const auto read = parsePly(
      "ply\nformat ascii 1.0\nobj_info a scanner\nelement camera 1\nproperty float f\n"
      "property list uchar float d\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty uchar flags\n"
      "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
      "800 2 0.1 0.2\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n7 5 0 1 2 3 4 0\n7 3 0 1 2 1 0.5\n",
      "x.ply");
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_EQ(read->mesh.triangles,
            (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 1, 2}}));
}

TEST(Ply, VerticesWithAListAreRead) {
  const auto read = parsePly(
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty list uchar int views\n"
      "property float y\nproperty float z\nend_header\n1 3 7 8 9 2 3\n4 0 5 6\n",
      "x.ply");
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_EQ(read->mesh.vertices, (std::vector<Eigen::Vector3f>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(Ply, OtherProgramsNamesOfNormalsAndColoursAreKnown) {
  const auto read = parsePly(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty float normal_x\nproperty float normal_y\nproperty float "
      "normal_z\n"
      "property float diffuse_red\nproperty float diffuse_green\nproperty float diffuse_blue\n"
      "property float confidence\nend_header\n1 2 3 0 0 2 0 0.5 1 0.25\n",
      "x.ply");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->mesh.normals.at(0), Eigen::Vector3f(0, 0, 1)) << "made of unit length";
  EXPECT_EQ(read->mesh.colors.at(0), (Color{0, 128, 255}));
  EXPECT_EQ(read->quality.at(0), 0.25f);
}

TEST(Ply, PointsThatAreNotFiniteAreDroppedWithTheirFacesAndCounted) {
  const auto read = parsePly(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
      "x.ply");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->dropped_not_finite, 1);
  EXPECT_EQ(read->mesh.vertices.size(), 3u);
  EXPECT_EQ(read->mesh.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}}));
}

TEST(Ply, AHeaderThatClaimsLessThanTheFileHoldsIsRefusedAndNamed) {
  const std::string lying =
      formatPly(PointCloud{{{1, 2, 3}, {4, 5, 6}}, {}, {}, {}}, "plate_front");
  std::string header = lying;
  header.replace(header.find("vertex 2"), 8, "vertex 1");
  const auto read = parsePly(header, "x.ply");
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().code, ErrorCode::UnusableInput);
  EXPECT_NE(read.error().sentence().english().find("x.ply"), std::string::npos);
  EXPECT_TRUE(parsePly(lying + "\n", "x.ply").has_value()) << "an empty line at the end is no lie";
}

TEST(Ply, ACloudWithoutNormalsAndACloudOfOnePointAreFine) {
  const std::string path = testing::TempDir() + "ostraka_one_point.ply";
  ASSERT_TRUE(writePly(path, PointCloud{{{1, 2, 3}}, {}, {}, {}}, "plate_front").has_value());
  const auto cloud = readPlyCloud(path);
  ASSERT_TRUE(cloud.has_value());
  EXPECT_EQ(cloud->size(), 1u);
  EXPECT_FALSE(cloud->hasNormals());
}

}  // namespace
}  // namespace ostraka
