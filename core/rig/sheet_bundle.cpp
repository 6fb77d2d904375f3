#include "rig/sheet_bundle.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "rig/camera.h"

namespace ostraka::rig {
namespace {

constexpr double kFocusSd = 0.01;      // of a telephone's focal length, a share
constexpr double kPrincipalSd = 0.02;  // of the longer side
constexpr double kDistortionSd = 0.3;  // k1, k2 of lenses without a fisheye
constexpr double kSheetLoss_px = 2;    // px; what is farther off counts less and less
constexpr double kSheetSd_px = 0.5;    // paper is not flat, and edges are fitted to 0.06 px

// Focal length and principal point by the longer side, k1, k2.
using LensBlock = std::array<double, 5>;

struct MarkerCost {
  Quad seen;
  double width, height, half_mm;

  template <class T>
  bool operator()(const T* lens, const T* focus, const T* pose, const T* marker, const T* inset,
                  T* residuals) const {
    const double longer = std::max(width, height);
    const T cosine = ceres::cos(marker[2]), sine = ceres::sin(marker[2]);
    const double sign[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    T at[4][2];
    for (int c = 0; c < 4; ++c) {
      const T x = T(half_mm * sign[c][0]), y = T(half_mm * sign[c][1]);
      const T p[3] = {marker[0] + cosine * x - sine * y, marker[1] + sine * x + cosine * y, T(0)};
      T q[3];
      ceres::AngleAxisRotatePoint(pose, p, q);
      for (int k = 0; k < 3; ++k) q[k] += pose[3 + k];
      if (q[2] < T(1)) return false;
      const T u = q[0] / q[2], v = q[1] / q[2], r2 = u * u + v * v;
      const T f =
          T(longer) * lens[0] * ceres::exp(focus[0]) * (T(1) + r2 * (lens[3] + r2 * lens[4]));
      at[c][0] = f * u + T(longer) * lens[1] + T(0.5 * (width - 1));
      at[c][1] = f * v + T(longer) * lens[2] + T(0.5 * (height - 1));
    }
    for (int c = 0; c < 4; ++c) {
      T inward[2] = {T(0), T(0)};
      for (const int to : {(c + 1) % 4, (c + 3) % 4}) {
        const T dx = at[to][0] - at[c][0], dy = at[to][1] - at[c][1];
        const T length = ceres::sqrt(dx * dx + dy * dy + T(1e-9));
        inward[0] += dx / length;
        inward[1] += dy / length;
      }
      for (int k = 0; k < 2; ++k)
        residuals[2 * c + k] = (at[c][k] + inset[0] * inward[k] - T(seen[c][k])) / T(kSheetSd_px);
    }
    return true;
  }
};

struct PriorCost {
  double mean, sd;
  template <class T>
  bool operator()(const T* value, T* residual) const {
    residual[0] = (value[0] - T(mean)) / T(sd);
    return true;
  }
};

struct LensCost {
  template <class T>
  bool operator()(const T* lens, T* residuals) const {
    for (int k = 0; k < 2; ++k) {
      residuals[k] = lens[1 + k] / T(kPrincipalSd);
      residuals[2 + k] = lens[3 + k] / T(kDistortionSd);
    }
    return true;
  }
};

MarkerCost costOf(const SheetView& view, const SeenMarker& seen, double side_mm) {
  return {seen.corners, static_cast<double>(view.width), static_cast<double>(view.height),
          0.5 * side_mm};
}

}  // namespace

std::array<Eigen::Vector2d, 4> cornersOf(const FlatMarker& marker, double side_mm) {
  const Eigen::Rotation2Dd turn(marker[2]);
  const Eigen::Vector2d middle(marker[0], marker[1]);
  const double half = 0.5 * side_mm;
  return {middle + turn * Eigen::Vector2d(-half, half), middle + turn * Eigen::Vector2d(half, half),
          middle + turn * Eigen::Vector2d(half, -half),
          middle + turn * Eigen::Vector2d(-half, -half)};
}

SheetFit fitSheet(SheetBundle& sheet) {
  std::map<std::pair<int, int>, LensBlock> lenses;
  std::vector<double> focus(sheet.views.size(), 0);
  std::vector<PoseBlock> poses;
  double inset_px = 0;
  for (const SheetView& view : sheet.views) {
    lenses[{view.width, view.height}] = {sheet.focal_px_per_width, 0, 0, 0, 0};
    poses.push_back(toBlock(view.camera_from_sheet));
  }
  ceres::Problem problem;
  const auto lensOf = [&lenses](const SheetView& view) {
    return lenses.at({view.width, view.height}).data();
  };
  for (std::size_t i = 0; i < sheet.views.size(); ++i) {
    const SheetView& view = sheet.views[i];
    for (const SeenMarker& seen : view.markers)
      if (const auto at = sheet.markers.find(seen.id); at != sheet.markers.end())
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<MarkerCost, 8, 5, 1, 6, 3, 1>(
                                     new MarkerCost(costOf(view, seen, sheet.side_mm))),
                                 new ceres::HuberLoss(kSheetLoss_px / kSheetSd_px), lensOf(view),
                                 &focus[i], poses[i].data(), at->second.data(), &inset_px);
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<PriorCost, 1, 1>(new PriorCost{0, kFocusSd}), nullptr,
        &focus[i]);
  }
  for (auto& [size, lens] : lenses)
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<LensCost, 4, 5>(new LensCost), nullptr,
                             lens.data());
  problem.SetParameterBlockConstant(sheet.markers.begin()->second.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.max_num_iterations = 100;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  SheetFit fit;
  fit.converged = summary.IsSolutionUsable();
  double all = 0;
  std::size_t corners = 0;
  std::map<int, std::pair<double, std::size_t>> by_marker;
  for (std::size_t i = 0; i < sheet.views.size(); ++i) {
    SheetView& view = sheet.views[i];
    view.camera_from_sheet = poseFrom(poses[i]);
    for (const SeenMarker& seen : view.markers) {
      const auto at = sheet.markers.find(seen.id);
      if (at == sheet.markers.end()) continue;
      double residuals[8] = {};
      costOf(view, seen, sheet.side_mm)(lensOf(view), &focus[i], poses[i].data(), at->second.data(),
                                        &inset_px, residuals);
      for (const double r : residuals) {
        all += r * r;
        by_marker[seen.id].first += r * r;
      }
      corners += 4;
      by_marker[seen.id].second += 4;
    }
  }
  fit.rms_px = kSheetSd_px * std::sqrt(all / std::max<double>(1, static_cast<double>(corners)));
  for (const auto& [id, sum] : by_marker)
    fit.marker_rms_px[id] = kSheetSd_px * std::sqrt(sum.first / static_cast<double>(sum.second));
  return fit;
}

}  // namespace ostraka::rig
