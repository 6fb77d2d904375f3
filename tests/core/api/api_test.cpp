// The functions that other programs call give what core gives them, and say what they cannot use.
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "api/catalogue.h"
#include "api/close_model.h"
#include "api/dense.h"
#include "api/point_files.h"
#include "api/register.h"
#include "api/version.h"
#include "files/files.h"
#include "tests/core/catalogue/small_project.h"
#include "tests/core/files/temporary_folder.h"
#include "tests/core/model/shapes.h"
#include "tests/core/pipeline/synthetic_out.h"
#include "tests/core/stereo/textured_ball.h"

namespace ostraka::api {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

QuietProgress quiet;

TEST(Api, ClosesABoxOfKnownVolume) {
  const model::BoxScan box;
  const Result<ClosedModel> closed = closeModel(scanOfBox(box, false, 1), scanOfBox(box, true, 2),
                                                Eigen::Isometry3d::Identity(), 2, quiet, {});
  ASSERT_TRUE(closed.has_value()) << closed.error().sentence();
  EXPECT_NEAR(closed->volume_mm3, box.size.prod(), 0.005 * box.size.prod());
  EXPECT_NEAR(closed->length_mm, box.size.x(), 0.2);  // noise of 0.03 mm on both ends
  EXPECT_NEAR(closed->width_mm, box.size.y(), 0.2);
  EXPECT_NEAR(closed->thickness_mean_mm, box.size.z(), 0.1);
  EXPECT_FALSE(closed->mesh.triangles.empty());
}

TEST(Api, PairsAndRegistersScansHandedInAsPoints) {
  const TemporaryFolder folder;
  pipeline::SyntheticOptions options;
  options.sherds = 3;
  options.swapped_look_alikes = false;
  const pipeline::SyntheticOut truth = pipeline::writeSyntheticOut(folder.path() / "out", options);
  std::vector<PointCloud> fronts, backs;
  for (const int i : {1, 2, 3}) {
    const std::string number = "00" + std::to_string(i) + ".ply";
    fronts.push_back(*readCloud(truth.output / "work/scans_front" / ("f" + number)));
    backs.push_back(*readCloud(truth.output / "work/scans_back" / ("b" + number)));
  }
  std::swap(backs.front(), backs.back());
  const Result<RegisteredScans> found = registerScans(fronts, backs, 2, quiet, {});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  ASSERT_EQ(found->pairs.size(), 3u);
  for (const RegisteredPair& pair : found->pairs) EXPECT_EQ(pair.front + pair.back, 2);
  EXPECT_TRUE(found->unpaired_front.empty() && found->unpaired_back.empty());

  const Result<RegisteredScans> half =
      registerScans(std::span(fronts).first(1), std::span(backs).first(2), 2, quiet, {});
  ASSERT_TRUE(half.has_value()) << half.error().sentence();
  EXPECT_FALSE(half->unpaired_back.empty());
}

TEST(Api, RefusesScansWithoutNormalsOrPointsAndNamesThem) {
  const PointCloud good = scanOfBox(model::BoxScan{}, false, 1);
  PointCloud flat = good;
  flat.normals.clear();
  const std::vector<PointCloud> fronts = {good}, flats = {good, flat}, few = {PointCloud{}};
  const Result<RegisteredScans> no_normals = registerScans(fronts, flats, 1, quiet, {});
  ASSERT_FALSE(no_normals.has_value());
  EXPECT_EQ(no_normals.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(no_normals.error().sentence(), HasSubstr("back 1"));
  EXPECT_EQ(registerScans(few, fronts, 1, quiet, {}).error().code, ErrorCode::NotEnough);
  EXPECT_EQ(registerScans({}, fronts, 1, quiet, {}).error().code, ErrorCode::NotEnough);
}

// One rule with the files of `ostraka register`.
TEST(Api, LeavesOutPointsWhoseNormalsHaveNoDirection) {
  const PointCloud good = scanOfBox(model::BoxScan{}, false, 1);
  PointCloud none = good, few = good;
  for (Eigen::Vector3f& normal : none.normals) normal.setZero();
  for (std::size_t i = 99; i < few.size(); ++i) few.normals[i].setZero();
  const std::vector<PointCloud> fronts = {good}, without = {none}, left = {few};
  const auto no_normals = registerScans(fronts, without, 1, quiet, {});
  ASSERT_FALSE(no_normals.has_value());
  EXPECT_EQ(no_normals.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(registerScans(fronts, left, 1, quiet, {}).error().code, ErrorCode::NotEnough);
  EXPECT_EQ(closeModel(good, none, Eigen::Isometry3d::Identity(), 1, quiet, {}).error().code,
            ErrorCode::UnusableInput);
}

TEST(Api, RefusesPointsThatAreNotFiniteAndListsOfOtherLengths) {
  const PointCloud good = scanOfBox(model::BoxScan{}, false, 1);
  PointCloud nowhere = good, few_colours = good, doubtful = good;
  doubtful.quality.assign(good.size(), std::numeric_limits<float>::quiet_NaN());
  nowhere.points[7].x() = std::numeric_limits<float>::quiet_NaN();
  few_colours.colors.resize(3);
  for (const PointCloud& bad : {nowhere, few_colours, doubtful}) {
    const std::vector<PointCloud> fronts = {good}, backs = {bad};
    EXPECT_EQ(registerScans(fronts, backs, 1, quiet, {}).error().code, ErrorCode::UnusableInput);
    const auto closed = closeModel(good, bad, Eigen::Isometry3d::Identity(), 1, quiet, {});
    ASSERT_FALSE(closed.has_value());
    EXPECT_EQ(closed.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(closed.error().where, "back");
  }
}

TEST(Api, ClosesNothingWithATransformThatIsNoneOrScansInAnotherUnit) {
  const PointCloud front = scanOfBox(model::BoxScan{}, false, 1),
                   back = scanOfBox(model::BoxScan{}, true, 2);
  std::vector<Eigen::Isometry3d> bad(6, Eigen::Isometry3d::Identity());
  bad[0](0, 0) = std::numeric_limits<double>::quiet_NaN();
  bad[1].matrix().setZero();
  bad[2].linear() *= 1000;
  bad[3](2, 2) = -1;
  bad[4].translation().x() = 5000;
  bad[5].translation().x() = 1e30;
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const auto closed = closeModel(front, back, bad[i], 1, quiet, {});
    ASSERT_FALSE(closed.has_value()) << i;
    EXPECT_EQ(closed.error().code, ErrorCode::UnusableInput) << i;
    EXPECT_EQ(closed.error().where, "front_from_back") << i;
  }
  for (const float factor : {1e-3f, 1e3f, 1e30f}) {
    PointCloud small_front = front, small_back = back;
    for (PointCloud* cloud : {&small_front, &small_back})
      for (Eigen::Vector3f& point : cloud->points) point *= factor;
    const auto closed =
        closeModel(small_front, small_back, Eigen::Isometry3d::Identity(), 1, quiet, {});
    ASSERT_FALSE(closed.has_value()) << factor;
    EXPECT_EQ(closed.error().code, ErrorCode::UnusableInput) << factor;
  }
}

TEST(Api, RefusesPhotographsWhoseCameraOrPoseIsNone) {
  const std::vector<std::uint8_t> rgb(std::size_t{3} * 64 * 48, 128);
  DensePhotograph good;
  good.width = 64;
  good.height = 48;
  good.rgb = rgb;
  good.fx = good.fy = 80;
  good.cx = 31.5;
  good.cy = 23.5;
  std::vector<DensePhotograph> bad(8, good);
  bad[0].camera_from_world.matrix().setZero();
  bad[1].camera_from_world(0, 3) = 1e30;
  bad[2].camera_from_world(0, 0) = -1;
  bad[3].fx = std::numeric_limits<double>::quiet_NaN();
  bad[4].fy = 0;
  bad[5].fx = 1e300;
  bad[6].distortion[2] = std::numeric_limits<double>::quiet_NaN();
  bad[7].cx = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const std::vector<DensePhotograph> photographs = {good, bad[i], good};
    const auto found = dense(photographs, 1, quiet, {});
    ASSERT_FALSE(found.has_value()) << i;
    EXPECT_EQ(found.error().code, ErrorCode::UnusableInput) << i;
    EXPECT_EQ(found.error().where, "photograph 1") << i;
  }
}

TEST(Api, SaysThatPhotographsAreTooSmall) {
  const std::vector<std::uint8_t> rgb(3, 128), mask(1, 255);
  DensePhotograph pixel;
  pixel.width = pixel.height = 1;
  pixel.rgb = rgb;
  pixel.mask = mask;
  pixel.fx = pixel.fy = 1;
  const auto found = dense(std::vector<DensePhotograph>(3, pixel), 1, quiet, {});
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(found.error().sentence(), HasSubstr("less than 16 pixels"));
}

TEST(Api, FindsABallInPhotographsWithKnownCameras) {
  const stereo::TexturedBall ball;
  std::vector<cv::Mat> kept;
  std::vector<DensePhotograph> photographs;
  for (const stereo::View& view : stereo::ballViews(ball, 6)) {
    const rig::Intrinsics& camera = view.camera.intrinsics;
    kept.push_back(view.photograph);  // grey: red, green and blue are alike
    kept.push_back(view.mask);
    photographs.push_back({camera.width,
                           camera.height,
                           {view.photograph.data, 3 * view.photograph.total()},
                           {view.mask.data, view.mask.total()},
                           camera.fx,
                           camera.fy,
                           camera.cx,
                           camera.cy,
                           camera.distortion,
                           view.camera.camera_from_plate});
  }
  const Result<DenseCloud> found = dense(photographs, 2, quiet, {});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_TRUE(found->plausible);
  ASSERT_TRUE(found->cloud.hasNormals());
  std::vector<double> off;
  for (const Eigen::Vector3f& p : found->cloud.points)
    off.push_back(std::abs((p.cast<double>() - ball.centre).norm() - ball.radius_mm));
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() / 2], 0.06);  // stereo_test.cpp: bias 0.04, spread 0.08

  photographs[1].height += 1;
  const Result<DenseCloud> wrong = dense(photographs, 2, quiet, {});
  ASSERT_FALSE(wrong.has_value());
  EXPECT_EQ(wrong.error().where, "photograph 1");
}

using ReadCatalogue = catalogue::SmallProject;

TEST_F(ReadCatalogue, GivesSherdsThatMatchWithTheirFields) {
  numbered(context12);
  numbered(context13);
  draft(context12);
  const fs::path folder = folder_.path() / "project";
  const Result<CatalogueContents> all = readCatalogue(folder, "");
  ASSERT_TRUE(all.has_value()) << all.error().sentence();
  EXPECT_EQ(all->title, "Trial");
  ASSERT_EQ(all->sherds.size(), 3u);
  EXPECT_EQ(all->sherds.front().number, "ARM1-T3-0012-0001");
  EXPECT_TRUE(all->sherds.back().number.empty()) << "drafts are last";
  const Result<CatalogueContents> some = readCatalogue(folder, "context:0013");
  ASSERT_TRUE(some.has_value()) << some.error().sentence();
  ASSERT_EQ(some->sherds.size(), 1u);
  EXPECT_THAT(some->sherds.front().fields, testing::Contains(testing::Pair("context", "0013")));
}

TEST(Api, SaysThatAFolderIsNoProject) {
  const TemporaryFolder folder;
  const Result<CatalogueContents> none = readCatalogue(folder.path(), "");
  ASSERT_FALSE(none.has_value());
  EXPECT_EQ(none.error().code, ErrorCode::UnusableInput);
}

TEST(Api, WritesNothingThatCannotBeReadOrThatMakesAnArchiveInvalid) {
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

TEST(Api, WritesWhatItReads) {
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
