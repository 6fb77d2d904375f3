#pragma once
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "base/result.h"
#include "rig/camera.h"
#include "rig/sheet_bend.h"

namespace ostraka::calibration {

/// Everything that is estimated together. Cameras and stops are indices here, not numbers.
/// camera_from_plate = camera_from_turntable[camera] * Rz(angles_rad[side][stop])
///                     * turntable_from_plate[side].
struct RigState {
  struct Camera {
    rig::Intrinsics intrinsics;
    Eigen::Isometry3d camera_from_turntable = Eigen::Isometry3d::Identity();
    double inset_px = 0;  ///< by which marker edges are seen inside of where they are
    double focal_sd_px = 0;
    /// Of fx fy cx cy k1 k2 p1 p2 k3, rotation vector (rad), translation (mm) of
    /// camera_from_turntable: 15 x 15 row by row; empty where it could not be computed.
    std::vector<double> covariance;
  };
  std::vector<Camera> cameras;
  std::array<std::vector<double>, 2> angles_rad;  ///< by side and stop
  std::array<Eigen::Isometry3d, 2> turntable_from_plate{Eigen::Isometry3d::Identity(),
                                                        Eigen::Isometry3d::Identity()};
  std::vector<Eigen::Isometry3d> camera_from_board;  ///< by board view
  /// By plate point: how far a printed corner lies from where plate.json says, mm. With
  /// Cameras::Separate plate points count per side, since a sheet lies otherwise each time.
  std::vector<Eigen::Vector3d> print_errors_mm;
  std::array<rig::SheetBend, 2> bends;  ///< by side; Cameras::Separate
  /// Size of the plate over that in plate.json, as known cameras see it; 1 where the cameras'
  /// places are estimated, since then the plate itself gives the scale.
  double plate_scale = 1;

  Eigen::Isometry3d cameraFromPlate(int camera, int side, int stop) const;
};

/// A marker's corner in a photograph of the batch.
struct PlateCorner {
  int camera = 0, side = 0, stop = 0;
  int plate_point = 0;    ///< the same for this corner in all photographs
  Eigen::Vector3d point;  ///< plate frame, mm
  Eigen::Vector2d pixel;
  Eigen::Vector2d outward;  ///< movement of the corner when all edges move outwards by 1 px
  double sd_px = 0.1;
};

/// A corner of the calibration board.
struct BoardCorner {
  int camera = 0, view = 0;
  Eigen::Vector3d point;  ///< board frame, mm
  Eigen::Vector2d pixel;
  double sd_px = 0.05;
};

/// Free: all is estimated; LensKnown: intrinsics are kept; Known: the cameras' poses as well.
/// Separate: each photograph is a camera of its own that stands anywhere over a sheet at rest, with
/// a lens tied to that of OwnLenses::lens_of_camera.
enum class Cameras { Free, LensKnown, Known, Separate };

/// What changes between photographs of one camera held by hand: autofocus moves the lens,
/// stabilisation shifts it. Telephones: some 0.4 % and 3 px of 1600.
struct OwnLenses {
  std::vector<int>
      lens_of_camera;            ///< by RigState::cameras; photographs of one lens share a number
  double focal_sd = 0.005;       ///< relative
  double centre_sd = 0.0025;     ///< of the principal point, in widths of the picture
  double distortion_sd = 0.002;  ///< of k1, k2 and k3; a tenth of it of p1 and p2
};

struct AdjustOptions {
  Cameras cameras = Cameras::Free;
  double table_repeatability_rad = 0.001;  ///< between the two sides' angles of a stop
  /// Printing, gluing and the plate's own flatness; what the pictures of a whole batch show of it.
  double print_sd_mm = 0.05;
  /// Cameras::Separate: paper does not lie flat. Its height is a polynomial of degree 4 over the
  /// sheet without a tilt, one per side, each coefficient with this standard deviation; 0: flat.
  double bend_sd_mm = 0;
  OwnLenses lenses;  ///< Cameras::Separate
  int max_rounds = 100;
};

/// Bundle adjustment of the rig (Ceres, one thread: repeats bit for bit). Gauge: the front's first
/// angle is kept, and with free cameras the front plate's turn about and height along the axis.
/// Errors: Failed when it does not converge to finite values.
Result<RigState> adjust(const RigState& start, const std::vector<PlateCorner>& plate,
                        const std::vector<BoardCorner>& board, const AdjustOptions& options);

/// Observed minus predicted, the inset taken into account.
Eigen::Vector2d residual(const RigState& state, const PlateCorner& corner);

}  // namespace ostraka::calibration
