#include "stereo/openmvs_adapter.h"

#include <gmock/gmock.h>

#include "stand_in.h"
#include "textured_ball.h"

namespace ostraka::stereo {
namespace {

using testing::HasSubstr;

// A cloud as OpenMVS writes it, with the views of each point as lists among its properties.
constexpr const char* kMakeCloud = R"(
made() {
  printf 'ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n'
  printf 'property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n'
  printf 'property float nx\nproperty float ny\nproperty float nz\n'
  printf 'property list uchar uint view_indices\nproperty list uchar float view_weights\n'
  printf 'end_header\n3 -2 20 9 8 7 0 0 1 2 0 1 2 0.5 0.5\n'
  printf '90 0 20 9 8 7 0 0 1 2 0 1 2 0.5 0.5\n'
})";

class OpenMvsAdapter : public StandIns {
 protected:
  Result<PointCloud> run() const {
    QuietProgress quiet;
    return reconstructWithOpenMvs(ballViews({}, 4), {}, work(), quiet, {});
  }
  void putInterface() const {
    put("InterfaceCOLMAP", R"(want images/0000.png images/0007.png sparse/cameras.txt
want sparse/images.txt sparse/points3D.txt
grep -q '^1 PINHOLE 200 160 900 900 100 80$' "$work/dense/sparse/cameras.txt" || exit 9
[ $(ls "$work/dense/images" | wc -l) = 8 ] || exit 9
while [ "$1" != -o ]; do shift; done
echo scene > "$2")");
  }
};

TEST_F(OpenMvsAdapter, HandsOverTheSceneAndReadsTheDenseCloud) {
  putInterface();
  put("DensifyPointCloud",
      std::string(kMakeCloud) +
          "\nwant scene.mvs masks/0000.mask.png masks/0007.mask.png\nmade > $work/dense/dense.ply");
  const auto cloud = run();
  ASSERT_TRUE(cloud.has_value()) << cloud.error().sentence() << textOf(work() / "log.txt");
  ASSERT_EQ(cloud->size(), 1U);
  EXPECT_EQ(cloud->points[0], Eigen::Vector3f(3, -2, 20));
  EXPECT_EQ(cloud->normals[0], Eigen::Vector3f(0, 0, 1));
  EXPECT_EQ(cloud->colors[0], (Color{9, 8, 7}));
  EXPECT_THAT(calls(), HasSubstr("--mask-path " + (work() / "masks").string() + "/"));
  EXPECT_THAT(calls(), HasSubstr("--ignore-mask-label 0"));
  EXPECT_THAT(calls(), HasSubstr("--resolution-level 0 --max-resolution 200"));
}

TEST_F(OpenMvsAdapter, TakesTheNameThatOlderVersionsGiveTheCloud) {
  putInterface();
  put("DensifyPointCloud", std::string(kMakeCloud) + "\nmade > $work/dense/dense_dense.ply");
  EXPECT_TRUE(run().has_value());
}

TEST_F(OpenMvsAdapter, TrustsTheOutputAndNotTheExitStatus) {
  put("InterfaceCOLMAP", "exit 0");
  put("DensifyPointCloud", "exit 0");
  EXPECT_EQ(run().error().code, ErrorCode::Failed);
  putInterface();
  const auto cloud = run();
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::NotEnough);
  EXPECT_THAT(cloud.error().sentence(), HasSubstr("log.txt"));
}

TEST_F(OpenMvsAdapter, NamesTheProgramThatIsMissing) {
  hideEverythingElse();
  putInterface();
  const auto cloud = run();
  ASSERT_FALSE(cloud.has_value());
  EXPECT_EQ(cloud.error().code, ErrorCode::Missing);
  EXPECT_THAT(cloud.error().what, HasSubstr("DensifyPointCloud"));
  EXPECT_THAT(cloud.error().what, HasSubstr("--dense builtin, which needs no other program"));
}

}  // namespace
}  // namespace ostraka::stereo
