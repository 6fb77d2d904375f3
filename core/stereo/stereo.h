#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/point_cloud.h"
#include "rig/camera.h"

namespace ostraka::stereo {

/// One photograph with its camera; those of one stop were lit alike. The mask has the photograph's
/// size: share of each pixel that the sherds cover, 0..255; an empty mask means that every pixel
/// may show the object.
struct View {
  rig::PosedImage camera;
  cv::Mat photograph;  ///< CV_8UC3, BGR, as it was shot (with the lens's distortion)
  cv::Mat1b mask;
};

/// The photograph of the view in this place, which may be read anew each time; from several threads
/// at once.
using ReadPhotograph = std::function<Result<cv::Mat>(std::size_t view)>;

/// What frames and planes take for each pixel of all photographs, about.
constexpr double kBytesAPixel = 30;

struct DenseOptions {
  int threads = 1;
  int readers = 0;  ///< photographs read at the same time, which are whole; 0: as many as threads
  std::optional<double> floor_z_mm;           ///< the plate's surface; nothing lies below it
  std::optional<Eigen::AlignedBox3d> bounds;  ///< plate frame, mm; found from the masks when absent
  /// Angles at the object between a view and the views it is compared with. Below the first depth
  /// is poorly determined, above the second a rough surface looks too different; where fewer than
  /// two views lie within both, the nearest up to the third are taken all the same.
  double min_source_angle_rad = 0.07;
  double max_source_angle_rad = 0.87;
  double last_source_angle_rad = 1.05;
  int max_sources = 8;  ///< per view: both other cameras of a stop and three at each stop beside it
  /// At full size each pixel keeps those that its plane from the level above fits best.
  int max_sources_per_pixel = 5;
  /// A point needs this many views that agree on it, its own included.
  int min_agreeing_views = 2;
  /// What frames and planes may take. An object whose photographs take more is reconstructed part
  /// by part.
  double memory_mb = 3000;
  std::uint64_t seed = 1;

  Result<void> check() const;
};

/// How far the photographs bear each other out, over the pixels of all views. With wrong cameras
/// PatchMatch finds a depth for nearly every pixel, too, but hardly one that another view confirms.
struct Agreement {
  std::int64_t shown = 0;         ///< inside the masks
  std::int64_t matched = 0;       ///< of these, on rays on which the object can lie
  std::int64_t confirmed = 0;     ///< of these, with a depth that another view has as well
  double confirmedShare() const;  ///< of the matched pixels
  double coveredShare() const;    ///< confirmed, of all that the masks show
  bool plausible() const;         ///< false: the cameras cannot be those of the photographs
};

struct Reconstruction {
  PointCloud cloud;
  Agreement agreement;
};

/// Oriented, coloured points of everything inside the masks, plate frame, mm; quality is the
/// confidence. PatchMatch stereo with slanted windows (Bleyer et al., BMVC 2011; Galliani et al.,
/// ICCV 2015) from coarse to fine, fused; each point is moved onto a quadric fitted around it, and
/// to where the photographs of one stop see it. Errors: NotEnough for fewer than 3 views or nothing
/// found, UnusableInput for sizes that differ, Cancelled; those of `read`.
Result<Reconstruction> reconstruct(std::span<const View> views, const ReadPhotograph& read,
                                   const DenseOptions& options, Progress& progress,
                                   std::stop_token stop);
/// With the photographs that the views hold.
Result<Reconstruction> reconstruct(std::span<const View> views, const DenseOptions& options,
                                   Progress& progress, std::stop_token stop);

}  // namespace ostraka::stereo
