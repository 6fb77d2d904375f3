#include "calibration/covariance.h"

#include <ceres/ceres.h>
#include <gtest/gtest.h>

namespace ostraka::calibration {
namespace {

// Residuals that are linear in a (2 values) and b (1 value), so that the answer is known by hand.
struct Line {
  double u, v, w;
  template <typename T>
  bool operator()(const T* a, const T* b, T* residual) const {
    residual[0] = u * a[0] + v * a[1] + w * b[0];
    return true;
  }
};

class Covariance : public testing::Test {
 protected:
  void add(double u, double v, double w) {
    using Cost = ceres::AutoDiffCostFunction<Line, 1, 2, 1>;
    problem_.AddResidualBlock(new Cost(new Line{u, v, w}), nullptr, a_, b_);
  }
  double a_[2] = {0.5, -1}, b_[1] = {2};
  ceres::Problem problem_;
};

TEST_F(Covariance, IsTheInverseOfTheNormalEquations) {
  add(2, 0, 0);
  add(0, 4, 0);
  add(0, 0, 10);
  const auto found = covarianceOfFirst(problem_, {a_, b_}, 2);
  ASSERT_TRUE(found.has_value());
  const Eigen::Vector3d expected(1.0 / 4, 1.0 / 16, 1.0 / 100);
  EXPECT_LT((found->diagonal() - expected).norm(), 1e-14);
  EXPECT_LT((Eigen::MatrixXd(found->diagonal().asDiagonal()) - *found).norm(), 1e-14);
}

TEST_F(Covariance, CountsWhatTheOtherBlocksLeaveOpen) {
  add(1, 0, 1);  // a0 + b
  add(0, 1, 0);
  add(0, 0, 2);  // b alone, standard deviation 1/2
  // var(a0) = var(a0 + b) + var(b) = 1 + 1/4.
  const auto found = covarianceOfFirst(problem_, {a_, b_}, 1);
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->rows(), 2);
  EXPECT_NEAR((*found)(0, 0), 1.25, 1e-14);
}

TEST_F(Covariance, IsZeroForWhatIsHeldConstant) {
  add(1, 0, 1);
  add(0, 1, 0);
  problem_.SetParameterBlockConstant(b_);
  const auto found = covarianceOfFirst(problem_, {b_, a_}, 2);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ((*found)(0, 0), 0);
  EXPECT_NEAR((*found)(1, 1), 1, 1e-14);
  problem_.SetManifold(a_, new ceres::SubsetManifold(2, {1}));
  const auto held = covarianceOfFirst(problem_, {a_, b_}, 2);
  ASSERT_TRUE(held.has_value());
  EXPECT_NEAR((*held)(0, 0), 1, 1e-14);
  EXPECT_EQ((*held)(1, 1), 0);
}

TEST_F(Covariance, IsNotGivenWhereNothingDeterminesAValue) {
  add(1, 1, 1);
  EXPECT_FALSE(covarianceOfFirst(problem_, {a_, b_}, 2).has_value());
}

}  // namespace
}  // namespace ostraka::calibration
