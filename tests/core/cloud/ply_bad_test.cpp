// Files that lie, end early or are no PLY: each gets a sentence, none memory that it only claims.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <string>

#include "cloud/ply.h"

namespace ostraka {
namespace {

std::string header(const std::string& format, const std::string& rest) {
  return "ply\nformat " + format + " 1.0\n" + rest + "end_header\n";
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";

void expectRefused(const std::string& bytes, const std::string& word) {
  const auto read = parsePly(bytes, "scan.ply");
  ASSERT_FALSE(read.has_value()) << bytes.substr(0, 200);
  EXPECT_EQ(read.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(read.error().where, "scan.ply");
  EXPECT_NE(read.error().what.english().find(word), std::string::npos) << read.error().what;
}

TEST(BadPly, WhatIsNoPlyIsRefused) {
  expectRefused("", "Not a PLY");
  expectRefused("solid stl", "Not a PLY");
  expectRefused("ply\n", "no end");
  expectRefused("ply\nelement vertex 1\n" + kXyz + "end_header\n1 2 3\n", "no format");
  expectRefused(header("ascii", "element face 0\n"), "no vertices");
}

TEST(BadPly, HeaderLinesThatCannotBeUnderstoodAreNamedByNumber) {
  expectRefused("ply\nformat ascii 1.0\nelement vertex many\n", "line 3");
  expectRefused("ply\nformat ascii 1.0\nelement vertex -1\n", "line 3");
  expectRefused("ply\nformat middle_endian 1.0\n", "line 2");
  expectRefused("ply\nformat ascii 1.0\nelement vertex 1\nproperty quark x\n", "line 4");
  expectRefused("ply\nformat ascii 1.0\nproperty float x\n", "line 3");
  expectRefused("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int v\n", "line 4");
}

TEST(BadPly, AStatedUnitOtherThanMillimetresIsRefusedByName) {
  const auto stating = [](const std::string& comment) {
    return header("ascii", comment + "\nelement vertex 1\n" + kXyz) + "1 2 3\n";
  };
  for (const char* unit : {"cm", "m", "inch"})
    expectRefused(stating(std::string("comment unit ") + unit), std::string("'") + unit + "'");
  for (const char* comment : {"comment unit mm", "comment unit Millimeters",
                              "comment unit normals are added", "comment made in m"})
    EXPECT_TRUE(parsePly(stating(comment), "scan.ply").has_value()) << comment;
}

TEST(BadPly, CountsThatTheFileCannotHoldAreRefusedBeforeAllocating) {
  for (const char* count : {"1000008", "4000000000", "18446744073709551615"}) {
    expectRefused(
        header("binary_little_endian", std::string("element vertex ") + count + "\n" + kXyz) +
            std::string(96, '\0'),
        "more than the file contains");
    expectRefused(header("ascii", std::string("element vertex ") + count + "\n" + kXyz) + "1 2 3\n",
                  "more than the file contains");
  }
  expectRefused(
      header("ascii", "element vertex 1\n" + kXyz + "element nothing 4000000000\n") + "1 2 3\n",
      "more than the file contains");
  expectRefused(header("binary_little_endian",
                       "element vertex 1\n" + kXyz +
                           "element face 1000000\nproperty list uchar int vertex_indices\n") +
                    std::string(40, '\0'),
                "more than the file contains");
}

TEST(BadPly, ListsLongerThanTheFileAreRefused) {
  expectRefused(
      header("binary_little_endian", "element vertex 1\n" + kXyz + "property list uint float w\n") +
          std::string(12, '\0') + "\xff\xff\xff\xff",
      "ends early");
  expectRefused(header("binary_little_endian",
                       "element vertex 1\n" + kXyz +
                           "element face 1\nproperty list uint int vertex_indices\n") +
                    std::string(12, '\0') + "\x84\x03" + std::string(10, '\0'),
                "ends within 'face'");
}

// A fan of 30 million corners kept `evaluate` busy beyond a minute.
TEST(BadPly, AFaceOfMillionsOfCornersIsRefusedAtOnce) {
  constexpr std::uint32_t kCorners = 30'000'000;
  std::string bytes = header("binary_little_endian",
                             "element vertex 3\n" + kXyz +
                                 "element face 1\nproperty list uint int vertex_indices\n") +
                      std::string(36, '\0');
  bytes.append(reinterpret_cast<const char*>(&kCorners), sizeof kCorners);
  bytes.append(std::size_t{4} * kCorners, '\0');
  const auto begin = std::chrono::steady_clock::now();
  expectRefused(bytes, "more than 1000 corners");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

TEST(BadPly, EveryCutOffEndIsRefused) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  const std::string whole = formatPly(mesh, "model");
  ASSERT_TRUE(parsePly(whole, "x").has_value());
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(parsePly(whole.substr(0, length), "x").has_value()) << length;
}

TEST(BadPly, FacesThatNameAbsentVerticesAreRefused) {
  const std::string start =
      header("ascii", "element vertex 2\n" + kXyz +
                          "element face 1\nproperty list uchar int vertex_index\n") +
      "0 0 0\n1 1 1\n";
  expectRefused(start + "3 0 1 2\n", "vertex that does not exist");
  expectRefused(start + "3 0 1 -1\n", "vertex that does not exist");
  expectRefused(
      header("ascii",
             "element face 1\nproperty list uchar int vertex_index\nelement vertex 1\n" + kXyz) +
          "1 0\n0 0 0\n",
      "vertex that does not exist");
}

TEST(BadPly, WordsAmongTheNumbersAreRefused) {
  expectRefused(header("ascii", "element vertex 1\n" + kXyz) + "1 two 3\n", "not a number");
  expectRefused(header("ascii", "element vertex 1\n" + kXyz) + "1 2 3x\n", "not a number");
}

TEST(BadPly, VerticesWithoutAPlaceAreRefused) {
  expectRefused(header("ascii", "element vertex 1\nproperty float x\nproperty float y\n") + "1 2\n",
                "lack x, y or z");
  expectRefused(
      header("ascii", "element vertex 1\n" + kXyz + "element vertex 1\n" + kXyz) + "1 2 3\n4 5 6\n",
      "two lists");
}

TEST(BadPly, ACloudOfNothingUsableIsRefused) {
  const std::string path = testing::TempDir() + "ostraka_empty.ply";
  ASSERT_TRUE(writePly(path, PointCloud{}, "plate_front").has_value());
  const auto cloud = readPlyCloud(path);
  ASSERT_FALSE(cloud.has_value());
  EXPECT_NE(cloud.error().sentence().english().find("ostraka_empty.ply"), std::string::npos);
}

}  // namespace
}  // namespace ostraka
