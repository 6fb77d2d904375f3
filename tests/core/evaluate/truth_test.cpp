#include "evaluate/truth.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "box.h"
#include "cloud/ply.h"

namespace ostraka::evaluate {
namespace {

std::filesystem::path truthFolder(const std::string& sherds_json) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "truth_test";
  std::filesystem::create_directories(folder);
  EXPECT_TRUE(writePly(folder / "box.ply", boxMesh(5, 4, 3), "model").has_value());
  EXPECT_TRUE(
      writePly(folder / "points.ply", PointCloud{{{0, 0, 0}}, {}, {}, {}}, "model").has_value());
  std::ofstream(folder / "sherds.json") << sherds_json;
  return folder;
}

TEST(ReadTrueSherds, ReadsMeshesAndPosesOfBothSides) {
  const auto sherds = readTrueSherds(truthFolder(
      R"({"sherds":[{"id":7,"mesh":"box.ply",
      "plate_from_model_front":[[1,0,0,10],[0,1,0,0],[0,0,1,0],[0,0,0,1]],
      "plate_from_model_back":[[1,0,0,0],[0,-1,0,0],[0,0,-1,3],[0,0,0,1]]}]})"));
  ASSERT_TRUE(sherds.has_value());
  EXPECT_EQ(sherds->at(0).id, "7");
  EXPECT_EQ(sherds->at(0).mesh.triangles.size(), 12u);
  // A point at the back's (0, 0, 3) is the model's origin, which stands at x = 10 in front.
  EXPECT_LT(
      (sherds->at(0).frontFromBack() * Eigen::Vector3d(0, 0, 3) - Eigen::Vector3d(10, 0, 0)).norm(),
      1e-12);
}

TEST(ReadTrueSherds, NamesTheFileThatIsWrong) {
  const char* const pose = R"("plate_from_model_front":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]])";
  const auto absent =
      readTrueSherds(truthFolder(std::string(R"({"sherds":[{"mesh":"no.ply",)") + pose + "}]}"));
  ASSERT_FALSE(absent.has_value());
  EXPECT_NE(absent.error().where.find("no.ply"), std::string::npos);
  const auto faceless = readTrueSherds(
      truthFolder(std::string(R"({"sherds":[{"mesh":"points.ply",)") + pose + "}]}"));
  ASSERT_FALSE(faceless.has_value());
  EXPECT_NE(faceless.error().what.english().find("no faces"), std::string::npos);
  EXPECT_FALSE(readTrueSherds(truthFolder(R"({"sherds":[{"mesh":"box.ply"}]})")).has_value());
  EXPECT_FALSE(readTrueSherds(truthFolder("{}")).has_value());
  EXPECT_FALSE(readTrueSherds(truthFolder(R"({"sherds":[{"mesh":"box.ply","plate_from_model_front":
      [[1,0,0,1e300],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}]})"))
                   .has_value())
      << "farther than any plate";
}

TEST(ReadTrueSherds, OpensNoMeshOutsideOfItsFolder) {
  const char* const pose = R"("plate_from_model_front":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]])";
  const std::filesystem::path folder = truthFolder("{}"), inside = folder / "inside";
  std::filesystem::create_directories(inside);
  for (const std::string& mesh : {std::string("../box.ply"), (folder / "box.ply").string()}) {
    std::ofstream(inside / "sherds.json")
        << R"({"sherds":[{"mesh":")" << mesh << "\"," << pose << "}]}";
    const auto outside = readTrueSherds(inside);
    ASSERT_FALSE(outside.has_value()) << mesh;
    EXPECT_EQ(outside.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(outside.error().where.find("sherds.json"), std::string::npos) << mesh;
  }
}

}  // namespace
}  // namespace ostraka::evaluate
