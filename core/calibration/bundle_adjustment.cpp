#include "calibration/bundle_adjustment.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/message.h"
#include "calibration/covariance.h"

namespace ostraka::calibration {
namespace {

// A residual beyond three standard deviations counts less and less.
constexpr double kLossScale = 3.0;

using IntrinsicsBlock = std::array<double, 9>;  // fx fy cx cy, then the lens's first five terms
using rig::PoseBlock, rig::poseFrom, rig::toBlock;

IntrinsicsBlock toBlock(const rig::Intrinsics& i) {
  return {i.fx,
          i.fy,
          i.cx,
          i.cy,
          i.distortion[0],
          i.distortion[1],
          i.distortion[2],
          i.distortion[3],
          i.distortion[4]};
}

template <class T>
void transform(const T* pose, const T* p, T* out) {
  ceres::AngleAxisRotatePoint(pose, p, out);
  for (int k = 0; k < 3; ++k) out[k] += pose[3 + k];
}

// Intrinsics::project for derivatives.
template <class T>
void project(const rig::Distortion& lens, const T* i, const T* p, T* pixel) {
  T bent[2];
  rig::bend(lens, i + 4, T(p[0] / p[2]), T(p[1] / p[2]), bent);
  for (int k = 0; k < 2; ++k) pixel[k] = i[k] * bent[k] + i[2 + k];
}

struct PlateCornerCost {
  PlateCorner corner;
  rig::Distortion lens;
  template <class T>
  bool operator()(const T* intrinsics, const T* camera, const T* angle, const T* plate,
                  const T* inset, const T* print_error, const T* scale, T* out) const {
    T point[3];
    for (int k = 0; k < 3; ++k) point[k] = scale[0] * corner.point[k] + print_error[k];
    T on_table[3], in_camera[3], pixel[2];
    transform(plate, point, on_table);
    using std::cos;
    using std::sin;
    const T c = cos(angle[0]), s = sin(angle[0]);
    const T turned[3] = {c * on_table[0] - s * on_table[1], s * on_table[0] + c * on_table[1],
                         on_table[2]};
    transform(camera, turned, in_camera);
    if (in_camera[2] < T(1)) return false;  // behind or inside the lens
    project(lens, intrinsics, in_camera, pixel);
    for (int k = 0; k < 2; ++k)
      out[k] = (pixel[k] - inset[0] * corner.outward[k] - corner.pixel[k]) / corner.sd_px;
    return true;
  }
};

struct BoardCornerCost {
  BoardCorner corner;
  rig::Distortion lens;
  template <class T>
  bool operator()(const T* intrinsics, const T* pose, T* out) const {
    const T point[3] = {T(corner.point.x()), T(corner.point.y()), T(corner.point.z())};
    T in_camera[3], pixel[2];
    transform(pose, point, in_camera);
    if (in_camera[2] < T(1)) return false;
    project(lens, intrinsics, in_camera, pixel);
    for (int k = 0; k < 2; ++k) out[k] = (pixel[k] - corner.pixel[k]) / corner.sd_px;
    return true;
  }
};

// What is known of lenses beforehand; weak, so that terms the pictures do not determine stay small.
struct LensPrior {
  int width = 0, height = 0;
  template <class T>
  bool operator()(const T* i, T* out) const {
    out[0] = (i[0] / i[1] - T(1)) / T(1e-4);  // pixels are square
    out[1] = (i[2] - T((width - 1) / 2.0)) / T(0.02 * width);
    out[2] = (i[3] - T((height - 1) / 2.0)) / T(0.02 * width);
    out[3] = i[4] / T(0.5);
    out[4] = i[5] / T(0.5);
    out[5] = i[6] / T(0.005);
    out[6] = i[7] / T(0.005);
    out[7] = i[8] / T(0.2);
    return true;
  }
};

struct DifferencePrior {
  double sd = 1;
  template <class T>
  bool operator()(const T* a, const T* b, T* out) const {
    out[0] = (a[0] - b[0]) / T(sd);
    return true;
  }
};

struct PlatePrior {
  template <class T>
  bool operator()(const T* plate, T* out) const {
    // The plate lies on the turntable: nearly level, nearly centred, at nearly the same height.
    for (int k = 0; k < 2; ++k) out[k] = plate[k] / T(0.05);
    for (int k = 3; k < 6; ++k) out[k - 1] = plate[k] / T(20.0);
    return true;
  }
};

struct PrintPrior {
  double sd_mm = 1;
  template <class T>
  bool operator()(const T* error, T* out) const {
    for (int k = 0; k < 3; ++k) out[k] = error[k] / T(sd_mm);
    return true;
  }
};

// A printed corner lies on the bent sheet. x, y: in half diagonals of the sheet.
struct BentPrintPrior {
  double x = 0, y = 0, sd_mm = 1;
  template <class T>
  bool operator()(const T* error, const T* bend, T* out) const {
    for (int k = 0; k < 3; ++k) out[k] = error[k] / T(sd_mm);
    out[2] -= rig::SheetBend::height(bend, x, y) / T(sd_mm);
    return true;
  }
};

struct BendPrior {
  double sd_mm = 1;
  template <class T>
  bool operator()(const T* bend, T* out) const {
    for (int k = 0; k < rig::SheetBend::kTerms; ++k) out[k] = bend[k] / T(sd_mm);
    return true;
  }
};

// A photograph's own lens against that of its camera.
struct OwnLensPrior {
  double width = 0, focal_sd = 1, centre_sd = 1, distortion_sd = 1;
  template <class T>
  bool operator()(const T* own, const T* lens, T* out) const {
    for (int k = 0; k < 2; ++k) out[k] = (own[k] / lens[k] - T(1)) / T(focal_sd);
    out[2] = (own[0] / own[1] - lens[0] / lens[1]) / T(1e-4);
    for (int k = 2; k < 4; ++k) out[k + 1] = (own[k] - lens[k]) / T(centre_sd * width);
    for (int k = 4; k < 6; ++k) out[k + 1] = (own[k] - lens[k]) / T(distortion_sd);
    for (int k = 6; k < 8; ++k) out[k + 1] = (own[k] - lens[k]) / T(0.1 * distortion_sd);
    out[9] = (own[8] - lens[8]) / T(distortion_sd);
    return true;
  }
};

// Wide, so that a plate of another size is seen for what it is and not bent to fit.
struct ScalePrior {
  template <class T>
  bool operator()(const T* scale, T* out) const {
    out[0] = (scale[0] - T(1)) / T(0.05);
    return true;
  }
};

struct InsetPrior {
  template <class T>
  bool operator()(const T* inset, T* out) const {
    out[0] = inset[0] / T(0.3);  // px: what blur, printing and the tone curve do
    return true;
  }
};

class Adjustment {
 public:
  Adjustment(const RigState& start, const AdjustOptions& options)
      : state_(start), options_(options) {
    if (options.cameras != Cameras::Known) state_.plate_scale = 1;
    for (const RigState::Camera& camera : start.cameras) {
      intrinsics_.push_back(toBlock(camera.intrinsics));
      cameras_.push_back(toBlock(camera.camera_from_turntable));
      insets_.push_back(camera.inset_px);
    }
    for (int s = 0; s < 2; ++s) plates_[s] = toBlock(start.turntable_from_plate[s]);
    for (const Eigen::Isometry3d& pose : start.camera_from_board) boards_.push_back(toBlock(pose));
  }

  Result<RigState> run(const std::vector<PlateCorner>& plate,
                       const std::vector<BoardCorner>& board) {
    for (const PlateCorner& corner : plate) add(corner);
    for (const BoardCorner& corner : board) add(corner);
    if (options_.cameras == Cameras::Separate)
      addSeparatePriors(plate);
    else
      addPriors();
    keepUndeterminedTerms();
    fixGauge();
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    // Not SuiteSparse: its BLAS rounds by where the memory happens to lie.
    options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    options.max_num_iterations = options_.max_rounds;
    options.num_threads = 1;
    options.function_tolerance = 1e-10;
    options.parameter_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    if (!summary.IsSolutionUsable() || !std::isfinite(summary.final_cost))
      return Error::failed(
          message("The bundle adjustment of the rig did not converge; check that plate.json and "
                  "board.json describe what was photographed."));
    store();
    if (options_.cameras == Cameras::Free) storeCovariance();
    return state_;
  }

 private:
  void add(const PlateCorner& c) {
    side_seen_[c.side] = true;
    using Cost = ceres::AutoDiffCostFunction<PlateCornerCost, 2, 9, 6, 1, 6, 1, 3, 1>;
    problem_.AddResidualBlock(new Cost(new PlateCornerCost{c, lensOf(c.camera)}),
                              new ceres::CauchyLoss(kLossScale), intrinsics_[c.camera].data(),
                              cameras_[c.camera].data(), &state_.angles_rad[c.side][c.stop],
                              plates_[c.side].data(), &insets_[c.camera],
                              state_.print_errors_mm[c.plate_point].data(), &state_.plate_scale);
  }

  void add(const BoardCorner& c) {
    using Cost = ceres::AutoDiffCostFunction<BoardCornerCost, 2, 9, 6>;
    problem_.AddResidualBlock(new Cost(new BoardCornerCost{c, lensOf(c.camera)}),
                              new ceres::CauchyLoss(kLossScale), intrinsics_[c.camera].data(),
                              boards_[c.view].data());
  }

  const rig::Distortion& lensOf(int camera) const {
    return state_.cameras[camera].intrinsics.distortion;
  }

  void addLensPrior(const rig::Intrinsics& size, IntrinsicsBlock& lens) {
    using Lens = ceres::AutoDiffCostFunction<LensPrior, 8, 9>;
    problem_.AddResidualBlock(new Lens(new LensPrior{size.width, size.height}), nullptr,
                              lens.data());
  }

  void addInsetPriors() {
    using Inset = ceres::AutoDiffCostFunction<InsetPrior, 1, 1>;
    for (double& inset : insets_)
      problem_.AddResidualBlock(new Inset(new InsetPrior), nullptr, &inset);
  }

  // Each lens starts as the first of its photographs has it. All its terms are free: that of sixth
  // order, as a calibration by a flat sheet alone leaves it, costs focal lengths 0.15 %.
  void addSeparatePriors(const std::vector<PlateCorner>& corners) {
    const OwnLenses& own = options_.lenses;
    for (std::size_t c = 0; c < intrinsics_.size(); ++c) {
      const rig::Intrinsics& i = state_.cameras[c].intrinsics;
      const auto [lens, first] = lenses_.try_emplace(own.lens_of_camera[c], intrinsics_[c]);
      if (first) addLensPrior(i, lens->second);
      using Own = ceres::AutoDiffCostFunction<OwnLensPrior, 10, 9, 9>;
      problem_.AddResidualBlock(new Own(new OwnLensPrior{static_cast<double>(i.width), own.focal_sd,
                                                         own.centre_sd, own.distortion_sd}),
                                nullptr, intrinsics_[c].data(), lens->second.data());
    }
    addInsetPriors();
    addBendPriors(corners);
  }

  void addBendPriors(const std::vector<PlateCorner>& corners) {
    double half_diagonal = 1;
    for (const PlateCorner& corner : corners)
      half_diagonal = std::max(half_diagonal, corner.point.head<2>().norm());
    for (rig::SheetBend& bend : state_.bends) bend.reach_mm = half_diagonal;
    std::vector<char> known(state_.print_errors_mm.size(), 0);
    for (const PlateCorner& corner : corners) {
      if (std::exchange(known[static_cast<std::size_t>(corner.plate_point)], 1) != 0) continue;
      using Cost = ceres::AutoDiffCostFunction<BentPrintPrior, 3, 3, rig::SheetBend::kTerms>;
      problem_.AddResidualBlock(
          new Cost(new BentPrintPrior{corner.point.x() / half_diagonal,
                                      corner.point.y() / half_diagonal, options_.print_sd_mm}),
          nullptr, state_.print_errors_mm[corner.plate_point].data(),
          state_.bends[corner.side].coefficients_mm.data());
    }
    for (int s = 0; s < 2; ++s) {
      if (!side_seen_[s]) continue;
      if (options_.bend_sd_mm > 0) {
        using Cost =
            ceres::AutoDiffCostFunction<BendPrior, rig::SheetBend::kTerms, rig::SheetBend::kTerms>;
        problem_.AddResidualBlock(new Cost(new BendPrior{options_.bend_sd_mm}), nullptr,
                                  state_.bends[s].coefficients_mm.data());
      } else {
        problem_.SetParameterBlockConstant(state_.bends[s].coefficients_mm.data());
      }
    }
  }

  void addPriors() {
    for (std::size_t c = 0; c < intrinsics_.size(); ++c) {
      addLensPrior(state_.cameras[c].intrinsics, intrinsics_[c]);
      problem_.AddParameterBlock(cameras_[c].data(), 6);
    }
    addInsetPriors();
    for (Eigen::Vector3d& error : state_.print_errors_mm) {
      using Cost = ceres::AutoDiffCostFunction<PrintPrior, 3, 3>;
      problem_.AddResidualBlock(new Cost(new PrintPrior{options_.print_sd_mm}), nullptr,
                                error.data());
    }
    using Scale = ceres::AutoDiffCostFunction<ScalePrior, 1, 1>;
    problem_.AddResidualBlock(new Scale(new ScalePrior), nullptr, &state_.plate_scale);
    for (PoseBlock& plate : plates_) {
      using Cost = ceres::AutoDiffCostFunction<PlatePrior, 5, 6>;
      problem_.AddResidualBlock(new Cost(new PlatePrior), nullptr, plate.data());
    }
    for (std::size_t stop = 0; stop < state_.angles_rad[0].size(); ++stop) {
      using Cost = ceres::AutoDiffCostFunction<DifferencePrior, 1, 1, 1>;
      problem_.AddResidualBlock(new Cost(new DifferencePrior{options_.table_repeatability_rad}),
                                new ceres::CauchyLoss(kLossScale), &state_.angles_rad[0][stop],
                                &state_.angles_rad[1][stop]);
    }
  }

  // A sixth-order term that the start leaves at zero is not determined by what was photographed;
  // free, it would trade off against k2 and the principal point. Terms of more than the standard
  // lens make up for each other, and what is known of lenses beforehand is not about them.
  void keepUndeterminedTerms() {
    if (options_.cameras != Cameras::Free) return;
    for (std::size_t c = 0; c < intrinsics_.size(); ++c) {
      double* i = intrinsics_[c].data();
      if (lensOf(static_cast<int>(c)).lens != rig::Lens::Standard)
        problem_.SetManifold(i, new ceres::SubsetManifold(9, {4, 5, 6, 7, 8}));
      else if (i[8] == 0)
        problem_.SetManifold(i, new ceres::SubsetManifold(9, {8}));
    }
  }

  void fixGauge() {
    if (options_.cameras == Cameras::Separate) {  // the sheet itself is the frame
      problem_.SetParameterBlockConstant(&state_.plate_scale);
      for (int s = 0; s < 2; ++s) {
        if (!side_seen_[s]) continue;
        problem_.SetParameterBlockConstant(plates_[s].data());
        problem_.SetParameterBlockConstant(&state_.angles_rad[s][0]);
      }
      return;
    }
    problem_.SetParameterBlockConstant(&state_.angles_rad[0][0]);
    if (options_.cameras != Cameras::Known) {
      problem_.SetManifold(plates_[0].data(), new ceres::SubsetManifold(6, {2, 5}));
      problem_.SetParameterBlockConstant(&state_.plate_scale);
    }
    for (int s = 0; s < 2; ++s)
      if (!side_seen_[s]) problem_.SetParameterBlockConstant(plates_[s].data());
    for (std::size_t c = 0; c < intrinsics_.size(); ++c) {
      if (options_.cameras != Cameras::Free)
        problem_.SetParameterBlockConstant(intrinsics_[c].data());
      if (options_.cameras == Cameras::Known)
        problem_.SetParameterBlockConstant(cameras_[c].data());
    }
  }

  void store() {
    for (std::size_t c = 0; c < intrinsics_.size(); ++c) {
      RigState::Camera& camera = state_.cameras[c];
      camera.inset_px = insets_[c];
      if (options_.cameras != Cameras::Known) camera.camera_from_turntable = poseFrom(cameras_[c]);
      if (options_.cameras != Cameras::Free && options_.cameras != Cameras::Separate) continue;
      const IntrinsicsBlock& i = intrinsics_[c];
      camera.intrinsics.fx = i[0];
      camera.intrinsics.fy = i[1];
      camera.intrinsics.cx = i[2];
      camera.intrinsics.cy = i[3];
      std::copy(i.begin() + 4, i.end(), camera.intrinsics.distortion.terms.begin());
    }
    for (int s = 0; s < 2; ++s) state_.turntable_from_plate[s] = poseFrom(plates_[s]);
    for (std::size_t v = 0; v < boards_.size(); ++v)
      state_.camera_from_board[v] = poseFrom(boards_[v]);
  }

  // Nothing is stored where the covariance cannot be computed.
  void storeCovariance() {
    std::vector<double*> blocks;
    for (std::size_t c = 0; c < intrinsics_.size(); ++c)
      blocks.insert(blocks.end(), {intrinsics_[c].data(), cameras_[c].data()});
    const std::size_t wanted = blocks.size();
    for (PoseBlock& plate : plates_) blocks.push_back(plate.data());
    for (std::vector<double>& angles : state_.angles_rad)
      for (double& angle : angles) blocks.push_back(&angle);
    for (double& inset : insets_) blocks.push_back(&inset);
    for (Eigen::Vector3d& error : state_.print_errors_mm) blocks.push_back(error.data());
    for (PoseBlock& board : boards_) blocks.push_back(board.data());
    const std::optional<Eigen::MatrixXd> all = covarianceOfFirst(problem_, blocks, wanted);
    if (!all) return;
    for (std::size_t c = 0; c < intrinsics_.size(); ++c) {
      const Eigen::Matrix<double, 15, 15, Eigen::RowMajor> own =
          all->block<15, 15>(15 * static_cast<Eigen::Index>(c), 15 * static_cast<Eigen::Index>(c));
      state_.cameras[c].covariance.assign(own.data(), own.data() + own.size());
      state_.cameras[c].focal_sd_px = std::sqrt(std::max(0.0, own(0, 0)));
    }
  }

  // The problem points into these; it is declared last to be destroyed first.
  RigState state_;
  AdjustOptions options_;
  std::vector<IntrinsicsBlock> intrinsics_;
  std::vector<PoseBlock> cameras_, boards_;
  std::array<PoseBlock, 2> plates_{};
  std::vector<double> insets_;
  std::array<bool, 2> side_seen_{};
  std::map<int, IntrinsicsBlock> lenses_;  // Cameras::Separate
  ceres::Problem problem_;
};

}  // namespace

Eigen::Isometry3d RigState::cameraFromPlate(int camera, int side, int stop) const {
  return cameras[camera].camera_from_turntable *
         Eigen::AngleAxisd(angles_rad[side][stop], Eigen::Vector3d::UnitZ()) *
         turntable_from_plate[side];
}

Result<RigState> adjust(const RigState& start, const std::vector<PlateCorner>& plate,
                        const std::vector<BoardCorner>& board, const AdjustOptions& options) {
  return Adjustment(start, options).run(plate, board);
}

Eigen::Vector2d residual(const RigState& state, const PlateCorner& corner) {
  const RigState::Camera& camera = state.cameras[corner.camera];
  const Eigen::Vector3d p =
      state.cameraFromPlate(corner.camera, corner.side, corner.stop) *
      (state.plate_scale * corner.point + state.print_errors_mm[corner.plate_point]);
  return corner.pixel + camera.inset_px * corner.outward - camera.intrinsics.project(p);
}

}  // namespace ostraka::calibration
