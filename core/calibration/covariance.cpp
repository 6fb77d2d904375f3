#include "calibration/covariance.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace ostraka::calibration {
namespace {

// Ambient values by tangent: identity without a manifold.
Eigen::MatrixXd plusJacobian(const ceres::Problem& problem, const double* block) {
  const int size = problem.ParameterBlockSize(block);
  const ceres::Manifold* manifold = problem.GetManifold(block);
  if (manifold == nullptr) return Eigen::MatrixXd::Identity(size, size);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(
      size, manifold->TangentSize());
  manifold->PlusJacobian(block, jacobian.data());
  return jacobian;
}

Eigen::MatrixXd normalMatrix(const ceres::CRSMatrix& jacobian) {
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(jacobian.num_cols, jacobian.num_cols);
  for (int row = 0; row < jacobian.num_rows; ++row)
    for (int a = jacobian.rows[row]; a < jacobian.rows[row + 1]; ++a)
      for (int b = jacobian.rows[row]; b <= a; ++b)
        normal(jacobian.cols[a], jacobian.cols[b]) += jacobian.values[a] * jacobian.values[b];
  return normal.selfadjointView<Eigen::Lower>();
}

}  // namespace

std::optional<Eigen::MatrixXd> covarianceOfFirst(ceres::Problem& problem,
                                                 const std::vector<double*>& blocks,
                                                 std::size_t wanted) {
  ceres::Problem::EvaluateOptions options;
  options.num_threads = 1;
  int ambient = 0, tangent = 0;  // of the wanted ones
  std::vector<int> tangent_at;   // of each wanted block; -1 when it is constant
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const bool free =
        problem.HasParameterBlock(blocks[k]) && !problem.IsParameterBlockConstant(blocks[k]);
    if (free) options.parameter_blocks.push_back(blocks[k]);
    if (k >= wanted) continue;
    if (!problem.HasParameterBlock(blocks[k])) return std::nullopt;
    tangent_at.push_back(free ? tangent : -1);
    ambient += problem.ParameterBlockSize(blocks[k]);
    if (free) tangent += problem.ParameterBlockTangentSize(blocks[k]);
  }
  if (tangent == 0) return Eigen::MatrixXd(Eigen::MatrixXd::Zero(ambient, ambient));
  ceres::CRSMatrix jacobian;
  if (!problem.Evaluate(options, nullptr, nullptr, nullptr, &jacobian)) return std::nullopt;
  const Eigen::MatrixXd normal = normalMatrix(jacobian);
  // Pixels, radians and millimetres are brought to one size first.
  Eigen::VectorXd scale = normal.diagonal().cwiseSqrt();
  for (double& s : scale) {
    if (!(s > 0) || !std::isfinite(s)) return std::nullopt;
    s = 1 / s;
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(scale.asDiagonal() * normal * scale.asDiagonal());
  if (factor.info() != Eigen::Success || factor.rcond() < 1e-15) return std::nullopt;
  Eigen::MatrixXd first = Eigen::MatrixXd::Zero(normal.rows(), tangent);
  first.topRows(tangent).diagonal().setOnes();
  const Eigen::MatrixXd covariance = scale.head(tangent).asDiagonal() *
                                     factor.solve(first).topRows(tangent) *
                                     scale.head(tangent).asDiagonal();
  Eigen::MatrixXd lift = Eigen::MatrixXd::Zero(ambient, tangent);
  int row = 0;
  for (std::size_t k = 0; k < wanted; ++k) {
    if (tangent_at[k] >= 0) {
      const Eigen::MatrixXd jac = plusJacobian(problem, blocks[k]);
      lift.block(row, tangent_at[k], jac.rows(), jac.cols()) = jac;
    }
    row += problem.ParameterBlockSize(blocks[k]);
  }
  return Eigen::MatrixXd(lift * covariance * lift.transpose());
}

}  // namespace ostraka::calibration
