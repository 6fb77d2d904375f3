#pragma once
#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "calibration/intrinsics.h"
#include "rig/camera.h"
#include "rig/rig.h"
#include "rig/sheet_bend.h"

namespace ostraka::calibration {

struct PoseOptions {
  int threads = 0;  ///< <= 0: all processors of this process; the result does not depend on it
  /// How well a stop comes back on the other side of the batch: hobby turntables reach 0.05
  /// degrees. Markers (0.1 px) outweigh this by far; it carries stops without any marker.
  double table_repeatability_rad = 0.001;
  /// Median residual of a camera above which a known rig no longer fits (a camera was moved).
  double max_known_rig_residual_px = 0.5;
};

/// What was found of one camera on the way to the poses.
struct CameraFindings {
  int camera = 0;
  int width = 0, height = 0;
  std::optional<IntrinsicsReport> lens;       ///< from the board; nothing without its pictures
  std::vector<Eigen::Vector2d> board_pixels;  ///< all corners of the board that were used
  double median_residual_px = 0;              ///< of the plate's marker corners, in the end
  /// With a known rig: how well it fitted as it was; and where it did not, how far this camera has
  /// moved and turned since, seen from the camera that fits best.
  double known_residual_px = 0, moved_mm = 0, turned_rad = 0;
};

/// A distance between the middles of two markers that took no part in the fit.
struct HeldOutDistance {
  int first = 0, second = 0;  ///< ids
  double expected_mm = 0, measured_mm = 0;
  double error() const { return measured_mm / expected_mm - 1; }  ///< relative
};

/// The poses of a batch's photographs.
struct BatchPoses {
  rig::Rig rig;
  /// One per usable shot in the order of batch.shots; file is the photograph's path.
  /// camera_from_plate belongs to the plate as it has turned (its markers define the frame).
  std::vector<rig::PosedImage> images;
  double reprojection_rms_px = 0;         ///< of the marker corners that were used
  std::vector<double> rms_per_image_px;   ///< per image; 0 where no marker was seen
  std::vector<int> markers_per_image;     ///< per image; 0: the pose comes through the rig
  std::vector<Message> warnings;          ///< what was also noted as a warning
  std::vector<CameraFindings> cameras;    ///< one per camera of the batch, by number
  std::vector<HeldOutDistance> held_out;  ///< empty when fewer than eight markers were seen
  /// By index of Plate::markers: the corners as the photographs have them, plate frame, mm, where
  /// at least two views see the marker.
  std::vector<std::optional<std::array<Eigen::Vector3d, 4>>> markers;
  std::array<rig::SheetBend, 2> bends;  ///< by side; of a sheet below free cameras, else flat
};

/// Intrinsics from the ChArUco photographs (from the plate's markers where there are none), poses
/// from the plate's markers, all in one bundle adjustment that knows the rig: per camera one pose
/// against the turntable, one axis, one angle per stop and side, one plate pose per side.
/// With a known rig its cameras are kept, only angles and plate poses are estimated anew.
/// A batch without photographs of the back is one that calibrates: only the front gets poses.
/// An unreadable photograph is left out with a warning. Errors: NotEnough (no plate.json, markers
/// not found, no camera with a pose, fewer than 3 posed views on a side), Cancelled.
Result<BatchPoses> poseBatch(const batch::Batch& batch, const std::optional<rig::Rig>& known,
                             const PoseOptions& options, Progress& progress, std::stop_token stop);

}  // namespace ostraka::calibration
