#include "api/checked.h"

#include <gtest/gtest.h>

#include <limits>

#include "api/close_model.h"
#include "api/register.h"
#include "tests/core/api/quiet.h"
#include "tests/core/model/shapes.h"

namespace ostraka::api {
namespace {

// One rule with the files of `ostraka register`.
TEST(CheckedCloud, LeavesOutPointsWhoseNormalsHaveNoDirection) {
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

TEST(CheckedCloud, RefusesPointsThatAreNotFiniteAndListsOfOtherLengths) {
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

}  // namespace
}  // namespace ostraka::api
