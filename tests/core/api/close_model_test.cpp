#include "api/close_model.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/api/quiet.h"
#include "tests/core/model/shapes.h"

namespace ostraka::api {
namespace {

TEST(CloseModel, ClosesABoxOfKnownVolume) {
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

TEST(CloseModel, ClosesNothingWithATransformThatIsNoneOrScansInAnotherUnit) {
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

}  // namespace
}  // namespace ostraka::api
