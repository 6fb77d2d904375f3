#include "colmap/colmap_program.h"

#include <gmock/gmock.h>

#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/core/batch/batch_folder.h"
#include "tests/core/colmap/model_forms.h"
#include "tests/core/rig/simulated_rig.h"

namespace ostraka::colmap {
namespace {

namespace fs = std::filesystem;
using batch::Listener;
using testing::HasSubstr;

class ColmapProgram : public testing::Test {
 protected:
  // A program that writes down how it was called and runs `body` for the mapper ($out: its folder).
  fs::path standIn(const std::string& body) {
    const fs::path program = folder_ / "standin";
    std::ofstream(program) << "#!/bin/sh\necho \"$@\" >> " << (folder_ / "calls").string()
                           << "\n[ \"$1\" = mapper ] || exit 0\nout=\"$7\"\n"
                           << body << "\n";
    fs::permissions(program, fs::perms::owner_all);
    return program;
  }
  std::string calls() const {
    std::ifstream in(folder_ / "calls");
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::vector<batch::Shot> shots(int count) const {
    std::vector<batch::Shot> list;
    for (int k = 0; k < count; ++k) {
      const fs::path file = folder_ / ("photo" + std::to_string(k) + ".jpg");
      std::ofstream(file) << "x";
      list.push_back({batch::Side::Front, 2, k, file, {}, 1600, 1200});
    }
    return list;
  }
  Result<ColmapPoses> pose(const fs::path& program, int count) {
    QuietProgress quiet;
    ColmapPoseOptions options;
    options.program = program;
    options.threads = 1;
    return poseWithColmap(shots(count), folder_ / "work", options, quiet, {});
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(ColmapProgram, GivesTheShotsTheirPosesInATurntableFrame) {
  ColmapModel model;
  const Eigen::Isometry3d elsewhere = rig::rigid({0.3, -0.8, 0.2}, {4, 5, 6});
  model.cameras.push_back(toColmap(rig::lens(2600), 1));
  for (std::uint32_t k = 0; k < 6; ++k)
    model.images.push_back({k + 1,
                            1,
                            rig::lookingDown(0.6, 0.8 * k) * elsewhere,
                            "cam2/" + std::to_string(k) + ".jpg",
                            {}});
  for (std::uint64_t k = 0; k < 100; ++k)
    model.points.push_back({k + 1,
                            elsewhere.inverse() * Eigen::Vector3d(k % 10, k / 10., 0.1 * (k % 7)),
                            {},
                            0.5,
                            {}});
  writeBinaryModel(folder_ / "model", model);
  const auto poses =
      pose(standIn("mkdir -p $out/0 && cp " + (folder_ / "model").string() + "/* $out/0/"), 7);
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  ASSERT_EQ(poses->images.size(), 6U);
  EXPECT_FALSE(poses->has_scale);
  EXPECT_EQ(poses->images[3].stop, 3);
  EXPECT_EQ(poses->images[3].intrinsics.cx, rig::lens(2600).cx);
  // Cameras circle at sin(0.6) * 600 above the lowest points, cos(0.6) * 600 from the axis.
  for (const rig::PosedImage& image : poses->images) {
    EXPECT_NEAR(image.centre().z(), 600 * std::sin(0.6), 0.5);
    EXPECT_NEAR(image.centre().head<2>().norm(), 600 * std::cos(0.6), 1e-6);
  }
  EXPECT_THAT(calls(), HasSubstr("--SiftExtraction.use_gpu 0"));
  EXPECT_THAT(calls(), HasSubstr("--SiftMatching.use_gpu 0"));
  const ColmapPoses scaled = scaledTo(*poses, 2);
  EXPECT_TRUE(scaled.has_scale);
  EXPECT_NEAR(scaled.images[0].centre().norm(), 2 * poses->images[0].centre().norm(), 1e-9);
}

TEST_F(ColmapProgram, IsHandedMasksOfAnyDepthAndDoesWithoutTheUnreadable) {
  std::vector<batch::Shot> masked = shots(2);
  cv::Mat1w labels(4, 5, ushort{0});
  labels(1, 2) = 256;  // black when cut to 8 bits
  masked[0].mask_file = folder_ / "labels.png";
  ASSERT_TRUE(cv::imwrite(masked[0].mask_file.string(), labels));
  masked[1].mask_file = folder_ / "broken.png";
  std::ofstream(masked[1].mask_file) << "no picture";
  ColmapPoseOptions options;
  options.program = standIn("exit 0");
  Listener listener;
  const auto poses = poseWithColmap(masked, folder_ / "work", options, listener, {});
  EXPECT_EQ(poses.error().code, ErrorCode::NotEnough) << "it went on to the mapper";
  const cv::Mat handed =
      cv::imread((folder_ / "work/masks/cam2/0.jpg.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_FALSE(handed.empty());
  EXPECT_EQ(handed.type(), CV_8U);
  EXPECT_EQ(cv::countNonZero(handed), 1);
  EXPECT_EQ(handed.at<uchar>(1, 2), 255);
  EXPECT_FALSE(fs::exists(folder_ / "work/masks/cam2/1.jpg.png"));
  ASSERT_EQ(listener.warnings.size(), 1u);
  EXPECT_THAT(listener.warnings[0], HasSubstr("broken.png"));
}

TEST_F(ColmapProgram, HandsOverSmallerCopiesByLensAndGivesCamerasOfThePhotographs) {
  std::vector<batch::Shot> by_hand = shots(4);
  for (int k = 0; k < 4; ++k) {
    by_hand[k].camera = k, by_hand[k].stop = 0;
    ASSERT_TRUE(cv::imwrite(by_hand[k].file.string(), cv::Mat3b(1200, 1600, {90, 80, 70})));
  }
  ColmapModel model;
  model.cameras.push_back(toColmap(rig::reduced(rig::lens(2600), 800, 600), 1));
  for (std::uint32_t k = 0; k < 4; ++k)
    model.images.push_back({k + 1,
                            1,
                            rig::lookingDown(0.6, 0.8 * k),
                            "cam" + std::to_string(k / 2) + "/" + std::to_string(k) + ".jpg",
                            {}});
  model.points.push_back({1, {0, 0, 0}, {}, 0.5, {}});
  writeBinaryModel(folder_ / "model", model);
  ColmapPoseOptions options;
  options.program = standIn("mkdir -p $out/0 && cp " + (folder_ / "model").string() + "/* $out/0/");
  options.lenses = {0, 0, 1, 1};
  options.megapixels = 0.48;
  QuietProgress quiet;
  const auto poses = poseWithColmap(by_hand, folder_ / "work", options, quiet, {});
  ASSERT_TRUE(poses.has_value()) << poses.error().sentence();
  const cv::Mat copy = cv::imread((folder_ / "work/images/cam1/2.jpg").string());
  EXPECT_EQ(copy.size(), cv::Size(800, 600));
  ASSERT_EQ(poses->images.size(), 4u);
  EXPECT_EQ(poses->images[2].intrinsics.width, 1600);
  EXPECT_NEAR(poses->images[2].intrinsics.fx, 2600, 1e-9);
  EXPECT_NEAR(poses->images[2].intrinsics.cx, rig::lens(2600).cx, 1e-9);
  // People hold cameras upright and look down: z points up, and all four are above the middle.
  for (const rig::PosedImage& image : poses->images) EXPECT_GT(image.centre().z(), 300);
}

TEST_F(ColmapProgram, TrustsTheOutputAndNotTheExitStatus) {
  const auto poses = pose(standIn("exit 0"), 4);
  ASSERT_FALSE(poses.has_value());
  EXPECT_EQ(poses.error().code, ErrorCode::NotEnough);
  EXPECT_THAT(poses.error().what, HasSubstr("0 of 4"));
}

TEST_F(ColmapProgram, NamesTheLogOfAFailure) {
  const auto poses = pose(standIn("exit 3"), 4);
  ASSERT_FALSE(poses.has_value());
  EXPECT_EQ(poses.error().code, ErrorCode::NotEnough);
  EXPECT_THAT(poses.error().sentence(), HasSubstr("log.txt"));
  EXPECT_THAT(poses.error().what, HasSubstr("cannot align these photographs"));
}

TEST_F(ColmapProgram, SaysWhatCannotBeStarted) {
  EXPECT_EQ(pose(folder_ / "nothing", 4).error().code, ErrorCode::Missing);
  EXPECT_FALSE(findProgram("no-program-of-this-name").has_value());
  EXPECT_TRUE(findProgram("sh").has_value());
}

TEST_F(ColmapProgram, IsKilledWhenAStopIsAskedFor) {
  std::stop_source source;
  source.request_stop();
  const auto run = runProgram("/bin/sh", {"-c", "sleep 100"}, folder_ / "log", source.get_token());
  EXPECT_EQ(run.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::colmap
