#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

namespace ceres {
class Problem;
}

namespace ostraka::calibration {

/// Covariance of the values of the first `wanted` blocks at the problem's present state: the
/// inverse of the dense normal equations, robust loss applied, with zeros for what is held
/// constant. blocks: every block of the problem that is free, in an order of the caller's; unlike
/// ceres::Covariance, which sorts them by address, the same problem gives the same digits in every
/// run. Nothing where the problem does not determine them. O(n^3) for n unknowns, some hundreds.
std::optional<Eigen::MatrixXd> covarianceOfFirst(ceres::Problem& problem,
                                                 const std::vector<double*>& blocks,
                                                 std::size_t wanted);

}  // namespace ostraka::calibration
