#pragma once
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"
#include "calibration/bundle_adjustment.h"
#include "calibration/calibrate.h"
#include "calibration/intrinsics.h"
#include "rig/view_pose.h"

namespace ostraka::calibration {

/// What is alike on the way from a plate's markers to poses, for cameras of a rig and in a hand:
/// markers are read, those that err are dropped, and the fit is tried on distances that it does not
/// know.
class MarkerPoser {
 protected:
  /// What of RigState places a photograph's markers.
  struct ShotPlace {
    int camera = -1;  ///< -1: without a pose
    int side = 0, stop = 0;
    int first_point = 0;  ///< of its plate's points
  };

  MarkerPoser(const batch::Batch& batch, const PoseOptions& options, Progress& progress,
              std::stop_token stop)
      : batch_(batch), options_(options), progress_(progress), stop_(std::move(stop)) {}

  void warn(const Message& text);
  void inform(const Message& text) { progress_.note(NoteLevel::Info, text); }
  int sideOf(std::size_t shot) const {
    return batch_.shots[shot].side == batch::Side::Front ? 0 : 1;
  }

  /// Errors: NotEnough without plate.json, those of findBatchMarkers.
  Result<void> readMarkers(Progress& progress);
  TargetView viewOf(std::size_t shot) const;
  void drop(std::size_t shot, std::size_t marker, const std::string& reason);
  /// Of the markers in use, in photographs that have a pose.
  std::vector<PlateCorner> plateCorners(double sd_scale) const;
  Result<void> adjustOnce(double sd_scale, const AdjustOptions& options);
  /// How far residuals really scatter against what was expected of them.
  double sdScale() const;
  /// A marker that is bent, covered in part or foreign: beyond six standard deviations and half a
  /// pixel.
  void dropOutliers();
  /// Root mean square of its corners, pixels, for each marker in use.
  std::vector<double> errorsOf(std::size_t shot) const;
  /// Adjusts to `others` alone and tells the distances between the markers left out.
  Result<void> fitWithout(const std::vector<std::size_t>& markers,
                          const std::vector<PlateCorner>& theirs,
                          const std::vector<PlateCorner>& others, const AdjustOptions& options);
  /// errors: errorsOf(its shot).
  void addImage(rig::PosedImage image, const std::vector<double>& errors);
  /// Over all images, with the sentence that says so.
  void tellError(const std::string& of_photographs);

  const batch::Batch& batch_;
  const PoseOptions& options_;
  Progress& progress_;
  std::stop_token stop_;
  std::vector<char> readable_;                           // by shot
  std::vector<std::vector<rig::PlacedMarker>> markers_;  // by shot
  std::vector<std::vector<char>> dropped_;               // by shot and marker
  std::vector<ShotPlace> places_;                        // by shot
  std::vector<BoardCorner> board_corners_;
  RigState state_;
  BatchPoses out_;

 private:
  void append(std::vector<PlateCorner>& corners, std::size_t shot, const rig::PlacedMarker& marker,
              double sd_scale) const;
  double errorOf(std::size_t shot, const rig::PlacedMarker& marker) const;

  double squares_ = 0, corners_ = 0;  // of all images
};

}  // namespace ostraka::calibration
