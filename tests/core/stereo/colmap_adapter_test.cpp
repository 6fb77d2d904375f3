#include "stereo/colmap_adapter.h"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

#include "cloud/ply.h"
#include "colmap/colmap_program.h"
#include "stand_in.h"
#include "textured_ball.h"

namespace ostraka::stereo {
namespace {

using testing::HasSubstr;

class ColmapAdapter : public StandIns {
 protected:
  void SetUp() override {
    StandIns::SetUp();
    PointCloud cloud;
    cloud.points = {{3, -2, 20}, {90, 0, 20}};  // on the ball, and far beside it
    cloud.normals = {{0, 0, 1}, {0, 0, 1}};
    cloud.colors = {{50, 60, 70}, {0, 0, 0}};
    ASSERT_TRUE(writePly(folder_ / "made.ply", cloud, "world").has_value());
  }
  Result<PointCloud> run(std::stop_token stop = {}) const {
    QuietProgress quiet;
    return reconstructWithColmap(ballViews({}, 4), {}, work(), quiet, stop);
  }
};

TEST_F(ColmapAdapter, HandsOverAWorkspaceAndReadsTheFusedCloud) {
  put("colmap", R"(want images/0000.png images/0007.png masks/0007.png.png
want sparse/cameras.txt sparse/images.txt sparse/points3D.txt
want stereo/patch-match.cfg stereo/fusion.cfg
[ -d "$work/dense/stereo/depth_maps" ] && [ -d "$work/dense/stereo/normal_maps" ] || exit 9
[ $(grep -c PINHOLE "$work/dense/sparse/cameras.txt") = 8 ] || exit 9
[ $(ls "$work/dense/images" | wc -l) = 8 ] || exit 9
if [ "$1" = stereo_fusion ]; then
  while [ "$1" != --output_path ]; do shift; done
  cp "$work/made.ply" "$2"
fi)");
  const auto cloud = run();
  ASSERT_TRUE(cloud.has_value()) << cloud.error().sentence() << textOf(work() / "log.txt");
  ASSERT_EQ(cloud->size(), 1U);
  EXPECT_EQ(cloud->colors[0], (Color{50, 60, 70}));
  EXPECT_THAT(calls(), HasSubstr("colmap patch_match_stereo --workspace_path " + work().string()));
  EXPECT_THAT(calls(), HasSubstr("colmap stereo_fusion"));
  EXPECT_THAT(textOf(work() / "stereo" / "patch-match.cfg"),
              testing::StartsWith("0000.png\n__auto__, 20\n0001.png\n"));
}

TEST_F(ColmapAdapter, SaysThatThisColmapHasNoCuda) {
  put("colmap",
      "echo 'ERROR: Dense stereo reconstruction requires CUDA, which is not available on your "
      "system.'; exit 1");
  const auto cloud = run();
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::Missing);
  EXPECT_THAT(cloud.error().what, HasSubstr("CUDA"));
  EXPECT_THAT(cloud.error().what, HasSubstr("--dense builtin, which needs neither"));
}

TEST_F(ColmapAdapter, TrustsTheOutputAndNotTheExitStatus) {
  put("colmap", R"([ "$1" = stereo_fusion ] || exit 0
printf 'ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n' \
  > "$work/dense/fused.ply"
printf 'property float z\nend_header\n' >> "$work/dense/fused.ply")");
  const auto cloud = run();
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::NotEnough);
  EXPECT_THAT(cloud.error().sentence(), HasSubstr("log.txt"));
  put("colmap", "exit 0");
  EXPECT_EQ(run().error().code, ErrorCode::NotEnough);
}

TEST_F(ColmapAdapter, NamesTheLogOfAFailure) {
  put("colmap", "echo broken; exit 3");
  const auto cloud = run();
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::Failed);
  EXPECT_THAT(cloud.error().sentence(), HasSubstr("log.txt"));
  EXPECT_EQ(textOf(work() / "log.txt"), "broken\n");
}

TEST_F(ColmapAdapter, NamesTheProgramThatIsMissing) {
  hideEverythingElse();
  const auto cloud = run();
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::Missing);
  EXPECT_EQ(cloud.error().sentence(),
            "The program colmap is not on the PATH, but --dense colmap needs it; install it, or "
            "use --dense builtin, which needs no other program.");
}

TEST_F(ColmapAdapter, LeavesTheWorkspaceOfAnotherRunAlone) {
  put("colmap", "exit 0");
  const Result<FolderLock> other = colmap::claimWorkspace(work());
  ASSERT_TRUE(other.has_value());
  std::ofstream(work() / "database.db") << "in use";
  const auto cloud = run();
  ASSERT_FALSE(cloud.has_value());
  EXPECT_THAT(cloud.error().sentence(), HasSubstr("Another run is writing to this folder"));
  EXPECT_EQ(textOf(work() / "database.db"), "in use");
  EXPECT_EQ(calls(), "");
}

TEST_F(ColmapAdapter, KillsTheProgramWhenAStopIsAskedFor) {
  put("colmap", "echo started; exec sleep 60");
  std::stop_source source;
  std::thread person([&] {
    for (int k = 0; k < 1000 && textOf(work() / "log.txt").empty(); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    source.request_stop();
  });
  const auto begin = std::chrono::steady_clock::now();
  const auto cloud = run(source.get_token());
  person.join();
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

}  // namespace
}  // namespace ostraka::stereo
