#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "rig/camera.h"
#include "rig/sheet_bend.h"
#include "scan/scan.h"
#include "scan/touching.h"

namespace ostraka::scan {

/// What the lengths of a batch are. Limits of two kinds are written in mm all the same: those that
/// follow from a pixel's size on the object hold as they are, for without a known length a side is
/// brought to a usual pixel (checks/no_scale.h). Those that follow from the size of sherds (a
/// crumb, a part of a sherd, what is flat) hold in millimetres where these are true; else the usual
/// sherd of the batch stands for one of 45 mm, and they hold beside it.
enum class Lengths {
  Millimetres,  ///< a length is known
  Relative      ///< only how long things are beside each other
};

constexpr double kUsualSherd_mm = 45;

struct SplitOptions {
  rig::SheetBend ground;                   ///< of the sheet below; flat: z = 0
  Lengths lengths = Lengths::Millimetres;  ///< Relative: limits on sizes are beside the usual sherd
  double plate_mm = 0.25;      ///< points this low belong to the plate (stereo's height noise)
  double plate_flat_mm = 0.6;  ///< so do points this low that look straight up
  double gap_mm = 1.2;         ///< wider gaps separate sherds; 5 pixels at 0.24 mm per pixel
  /// A sherd stands on the plate: a piece that hovers by this much beside a far larger one is a
  /// part of its edge. Sherds whose lower edge is not seen nearer to the plate are large
  /// themselves.
  double hover_mm = 2.0;
  double hover_reach_mm = 3.0;  ///< from the larger piece's points: half of what sherds stay apart
  double hover_share = 0.05;    ///< of the larger piece's points at most
  double min_extent_mm = 10.0;  ///< smaller pieces are crumbs: no sherd is sorted below 1 cm
  double min_area_mm2 = 50;     ///< so are slivers: a sherd of 1 cm covers more, seen from above
  double min_height_mm = 1.5;   ///< flatter pieces are markers or dirt: walls are 3 mm and more
  TouchingOptions touching;
  /// Photographs and masks of the side, see outlines.h; without them gaps alone separate sherds.
  std::span<const rig::PosedImage> images = {};
  std::span<const cv::Mat1b> masks = {};
};

struct SplitResult {
  std::vector<Scan> scans;  ///< f001 ... or b001 ..., by rows from far (+y) to near, fracture found
  std::vector<Message> warnings;  ///< whole sentences with places on the plate in mm
  /// With Lengths::Relative: the sentences about what was left out and, its true size unknown, may
  /// be a sherd.
  std::vector<Message> doubtful;
};

/// One cloud per sherd: connected pieces above the plate, with what hovers beside them and what
/// stereo left without a connection to them within their outlines. Crumbs, plate points, markers
/// and flying points are dropped; touching sherds are cut apart; all of it is reported, pieces of
/// fewer than 100 points by their number and, where they are as large as a sherd, one by one.
/// plate_cloud: oriented points in the side's plate frame, mm. Errors: NotEnough when nothing is
/// left, UnusableInput without normals. Deterministic; numbers follow the places on the plate.
Result<SplitResult> splitScans(const PointCloud& plate_cloud, batch::Side side,
                               const SplitOptions& options, Progress& progress);

}  // namespace ostraka::scan
