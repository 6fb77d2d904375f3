#include "calibration/calibrate.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "base/median.h"
#include "base/message.h"
#include "base/part_progress.h"
#include "base/text.h"
#include "calibration/batch_corners.h"
#include "calibration/bundle_adjustment.h"
#include "calibration/held_out.h"
#include "calibration/marker_poser.h"
#include "calibration/rig_start.h"
#include "rig/view_pose.h"

namespace ostraka::calibration {
namespace {

constexpr int kMinViewsPerSide = 3;
constexpr std::size_t kTellTale = 4;  // markers found: as many do not all err by chance
constexpr Template<1> kTooFewOfFront = translatable<1>(
    "Photographs of the front side with a pose: %1; at least 3 are needed. Check that the plate's "
    "markers are lit and in the picture.");
constexpr Template<1> kTooFewOfBack = translatable<1>(
    "Photographs of the back side with a pose: %1; at least 3 are needed. Check that the plate's "
    "markers are lit and in the picture.");

int indexOf(const std::vector<int>& sorted, int value) {
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

class Poser : MarkerPoser {
 public:
  Poser(const batch::Batch& batch, const std::optional<rig::Rig>& known, const PoseOptions& options,
        Progress& progress, std::stop_token stop)
      : MarkerPoser(batch, options, progress, std::move(stop)), known_(known) {}

  Result<BatchPoses> run() {
    PartProgress first(progress_, 0, 2);
    if (const Result<void> read = readMarkers(first); !read) return read.error();
    numberEverything();
    if (const Result<void> found = findIntrinsics(); !found) return found.error();
    if (const Result<void> found = findStart(); !found) return found.error();
    if (const Result<void> found = refine(); !found) return found.error();
    if (const Result<void> checked = holdOut(); !checked) return checked.error();
    return poses();
  }

 private:
  std::string letterOf(std::size_t index) const {
    return batch::cameraLetter(camera_numbers_[index]);
  }

  void numberEverything() {
    std::set<int> cameras, stops;
    for (const batch::Shot& shot : batch_.shots)
      cameras.insert(shot.camera), stops.insert(shot.stop);
    camera_numbers_.assign(cameras.begin(), cameras.end());
    stop_numbers_.assign(stops.begin(), stops.end());
    state_.cameras.resize(camera_numbers_.size());
    state_.print_errors_mm.assign(batch_.plate->markers.size() * 4, Eigen::Vector3d::Zero());
    intrinsics_rms_.assign(camera_numbers_.size(), 0);
    out_.cameras.resize(camera_numbers_.size());
    for (std::size_t c = 0; c < camera_numbers_.size(); ++c) {
      out_.cameras[c].camera = camera_numbers_[c];
      std::tie(out_.cameras[c].width, out_.cameras[c].height) = sizeOf(c);
    }
  }
  int cameraOf(std::size_t shot) const {
    return indexOf(camera_numbers_, batch_.shots[shot].camera);
  }
  int stopOf(std::size_t shot) const { return indexOf(stop_numbers_, batch_.shots[shot].stop); }
  // The known rig's cameras, when it has all of this batch with the same picture size.
  bool takeKnownRig() {
    if (!known_) return false;
    for (std::size_t i = 0; i < batch_.shots.size(); ++i) {
      const batch::Shot& shot = batch_.shots[i];
      const rig::RigCamera* camera = known_->find(shot.camera);
      if (camera == nullptr || camera->intrinsics.width != shot.width ||
          camera->intrinsics.height != shot.height) {
        warn(
            message("The known rig has no camera %1 with pictures of %2 x %3 pixels; the rig is "
                    "calibrated from this batch instead.",
                    batch::cameraLetter(shot.camera), shot.width, shot.height));
        return false;
      }
      RigState::Camera& own = state_.cameras[cameraOf(i)];
      own.intrinsics = camera->intrinsics;
      own.camera_from_turntable = camera->camera_from_turntable;
      own.inset_px = camera->marker_inset_px;
      own.focal_sd_px = camera->focal_sd_px;
      intrinsics_rms_[cameraOf(i)] = camera->intrinsics_rms_px;
    }
    return true;
  }

  Result<void> findIntrinsics() {
    if (takeKnownRig()) {
      mode_ = Cameras::Known;
      return {};
    }
    std::vector<TargetView> boards;
    if (batch_.board && !batch_.calibration.empty()) {
      PartProgress second(progress_, 1, 2);
      Result<std::vector<TargetView>> found =
          findBatchBoards(batch_, options_.threads, second, stop_);
      if (!found) return found.error();
      boards = std::move(*found);
    }
    for (std::size_t c = 0; c < camera_numbers_.size(); ++c)
      if (!intrinsicsFromBoards(c, boards))
        if (const Result<void> found = intrinsicsFromMarkers(c); !found) return found.error();
    return {};
  }

  std::pair<int, int> sizeOf(std::size_t camera) const {
    for (const batch::Shot& shot : batch_.shots)
      if (shot.camera == camera_numbers_[camera]) return {shot.width, shot.height};
    return {0, 0};
  }

  bool intrinsicsFromBoards(std::size_t camera, const std::vector<TargetView>& boards) {
    std::vector<TargetView> views;
    for (std::size_t v = 0; v < boards.size(); ++v)
      if (batch_.calibration[v].camera == camera_numbers_[camera] && !boards[v].points.empty())
        views.push_back(boards[v]);
    const auto [width, height] = sizeOf(camera);
    const Result<IntrinsicsReport> report = calibrateIntrinsics(views, width, height);
    if (!report) {
      warn(inOne(message("camera %1: %2", letterOf(camera), report.error().what),
                 message("Its lens is estimated from the plate's markers instead.")));
      return false;
    }
    out_.cameras[camera].lens = *report;
    for (const TargetView& view : views)
      out_.cameras[camera].board_pixels.insert(out_.cameras[camera].board_pixels.end(),
                                               view.pixels.begin(), view.pixels.end());
    for (const Message& advice : report->advice)
      warn(message("camera %1: %2", letterOf(camera), advice));
    if (!report->focal_determined) return false;
    state_.cameras[camera].intrinsics = report->intrinsics;
    intrinsics_rms_[camera] = report->rms_px;
    const double sd = std::max(0.02, report->rms_px * M_SQRT1_2);  // of one coordinate
    for (std::size_t v = 0; v < views.size(); ++v) {
      const int view = static_cast<int>(state_.camera_from_board.size());
      state_.camera_from_board.push_back(report->camera_from_target[v]);
      for (std::size_t k = 0; k < views[v].points.size(); ++k)
        board_corners_.push_back(
            {static_cast<int>(camera), view, views[v].points[k], views[v].pixels[k], sd});
    }
    inform("rig: camera " + letterOf(camera) + " " + fixed(report->rms_px, 3) + " px over " +
           std::to_string(views.size()) + " pictures of the board, focal length " +
           fixed(report->intrinsics.fx, 1) + " +- " + fixed(report->sd[0], 1) + " px");
    return true;
  }

  Result<void> intrinsicsFromMarkers(std::size_t camera) {
    std::vector<TargetView> views;
    for (std::size_t i = 0; i < markers_.size(); ++i) {
      if (cameraOf(i) != static_cast<int>(camera) || markers_[i].size() < 4) continue;
      views.push_back(viewOf(i));
    }
    const auto [width, height] = sizeOf(camera);
    const Result<IntrinsicsReport> report = intrinsicsFromPlate(views, width, height);
    if (!report)
      return Error::notEnough(
          message("The lens of camera %1 is unknown: no usable pictures of the board and "
                  "no plate markers were found; add pictures of the board to 'calib'.",
                  letterOf(camera)),
          batch_.folder.string());
    state_.cameras[camera].intrinsics = report->intrinsics;
    warn(
        message("The lens of camera %1 was estimated from the plate's markers alone; add 12 "
                "pictures of the board to 'calib' for accurate measurements.",
                letterOf(camera)));
    return {};
  }

  Result<void> findStart() {
    std::vector<ViewPose> views;
    dropped_.resize(markers_.size());
    for (std::size_t i = 0; i < markers_.size(); ++i) {
      dropped_[i].assign(markers_[i].size(), 0);
      const auto pose = rig::poseFromMarkers(markers_[i], state_.cameras[cameraOf(i)].intrinsics);
      if (!pose) continue;
      int agreeing = 0;
      for (std::size_t m = 0; m < markers_[i].size(); ++m) {
        agreeing += pose->agrees[m] ? 1 : 0;
        if (!pose->agrees[m]) drop(i, m, "it is not where the other markers place it");
      }
      views.push_back({cameraOf(i), sideOf(i), stopOf(i), pose->camera_from_plate, agreeing});
    }
    std::optional<RigStart> start = startRig(state_, views, stop_numbers_, mode_, sidesShot());
    if (!start) {
      int seen = 0;
      for (const auto& markers : markers_) seen += markers.empty() ? 0 : 1;
      return Error::notEnough(
          message("The plate's markers were found in %1 of %2 photographs, too few for a "
                  "pose of each side; check that plate.json belongs to this plate and "
                  "that the markers are lit and in the picture.",
                  seen, markers_.size()),
          batch_.folder.string());
    }
    start_ = std::move(*start);
    places_.clear();
    for (std::size_t i = 0; i < markers_.size(); ++i)
      places_.push_back(
          {start_.camera_posed[cameraOf(i)] ? cameraOf(i) : -1, sideOf(i), stopOf(i)});
    for (std::size_t c = 0; c < camera_numbers_.size(); ++c)
      if (!start_.camera_posed[c])
        warn(
            message("No photograph of camera %1 shows two markers of the plate; all its "
                    "photographs are left out.",
                    letterOf(c)));
    return {};
  }

  SidesShot sidesShot() const {
    const bool back = std::ranges::any_of(
        batch_.shots, [](const batch::Shot& shot) { return shot.side == batch::Side::Back; });
    return back ? SidesShot::Both : SidesShot::FrontOnly;
  }

  AdjustOptions adjustOptions() const {
    AdjustOptions options;
    options.cameras = mode_;
    options.table_repeatability_rad = options_.table_repeatability_rad;
    return options;
  }

  Result<void> refine() {
    state_ = start_.state;
    if (const Result<void> done = adjustOnce(1, adjustOptions()); !done) return done;
    if (mode_ == Cameras::Known && !knownRigFits()) {
      mode_ = Cameras::LensKnown;
      const RigState known = state_;
      if (const Result<void> found = findStart(); !found) return found;
      state_ = start_.state;
      if (const Result<void> done = adjustOnce(1, adjustOptions()); !done) return done;
      sayWhatMoved(known);
    }
    dropOutliers();
    return adjustOnce(sdScale(), adjustOptions());
  }

  std::vector<double> residualsOf(std::size_t camera) const {
    std::vector<double> errors;
    for (const PlateCorner& corner : plateCorners(1))
      if (corner.camera == static_cast<int>(camera))
        errors.push_back(residual(state_, corner).norm());
    return errors;
  }

  bool knownRigFits() {
    bool fits = true;
    for (std::size_t c = 0; c < camera_numbers_.size(); ++c) {
      const double typical = medianOf(residualsOf(c));
      out_.cameras[c].known_residual_px = typical;
      if (typical <= options_.max_known_rig_residual_px) continue;
      fits = false;
      warn(
          message("The known rig no longer fits: camera %1 misses the markers by %2 px. The camera "
                  "poses are re-estimated for this batch; recalibrate the rig.",
                  letterOf(c), decimal(typical, 2)));
    }
    return fits;
  }

  // Which camera stands elsewhere than the known rig has it, in words.
  void sayWhatMoved(const RigState& known) {
    auto& cameras = out_.cameras;
    const auto best = std::ranges::min_element(
        cameras, [](auto& a, auto& b) { return a.known_residual_px < b.known_residual_px; });
    const auto reference = static_cast<std::size_t>(best - cameras.begin());
    for (std::size_t c = 0; c < cameras.size(); ++c) {
      if (c == reference || !start_.camera_posed[c]) continue;
      const Move move = moveAgainst(known, state_, c, reference);
      cameras[c].moved_mm = move.moved_mm;
      cameras[c].turned_rad = move.turned_rad;
      if (cameras[c].known_residual_px > options_.max_known_rig_residual_px)
        warn(sentence(move, camera_numbers_[c], camera_numbers_[reference]));
    }
  }

  // Distances that the fit does not know: the adjustment once more without four markers.
  Result<void> holdOut() {
    const std::vector<PlateCorner> all = plateCorners(sdScale());
    out_.markers.resize(batch_.plate->markers.size());
    for (std::size_t m = 0; m < out_.markers.size(); ++m)
      out_.markers[m] = cornersInSpace(state_, ofMarker(all, m));
    const std::vector<std::size_t> chosen = markersToHoldOut(*batch_.plate, all);
    if (chosen.empty()) return {};
    std::vector<PlateCorner> others;
    for (const PlateCorner& corner : all)
      if (std::find(chosen.begin(), chosen.end(), corner.plate_point / 4) == chosen.end())
        others.push_back(corner);
    AdjustOptions options = adjustOptions();
    if (mode_ == Cameras::Free) options.cameras = Cameras::LensKnown;
    return fitWithout(chosen, all, others, options);
  }

  Result<BatchPoses> poses() {
    for (std::size_t i = 0; i < batch_.shots.size(); ++i) {
      if (!readable_[i] || places_[i].camera < 0) continue;
      const batch::Shot& shot = batch_.shots[i];
      const std::string file = shot.file.string();
      const std::vector<double> errors = errorsOf(i);
      if (errors.empty() && markers_[i].size() >= kTellTale) {
        warn(inOne(message("%1: none of its %2 markers is where this camera sees them at this "
                           "position.",
                           file, markers_[i].size()),
                   message("It has another photograph's name or was taken while the plate was "
                           "turning; it is left out.")));
        continue;
      }
      if (errors.empty())
        warn(
            message("%1: no marker is visible; check that the photograph shows this position. If "
                    "not, retake it.",
                    file));
      addImage({file, shot.side, shot.camera, shot.stop, state_.cameras[cameraOf(i)].intrinsics,
                state_.cameraFromPlate(cameraOf(i), sideOf(i), stopOf(i))},
               errors);
    }
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
      if (side == batch::Side::Back && sidesShot() == SidesShot::FrontOnly) break;
      const auto views = std::ranges::count(out_.images, side, &rig::PosedImage::side);
      if (views < kMinViewsPerSide)
        return Error::notEnough(
            message(side == batch::Side::Front ? kTooFewOfFront : kTooFewOfBack, views),
            batch_.folder.string());
    }
    for (std::size_t c = 0; c < out_.cameras.size(); ++c)
      out_.cameras[c].median_residual_px = medianOf(residualsOf(c));
    tellError("photographs");
    fillRig();
    return std::move(out_);
  }

  std::vector<double> knownCovariance(std::size_t camera) const {
    const rig::RigCamera* known = known_ ? known_->find(camera_numbers_[camera]) : nullptr;
    return known != nullptr && mode_ == Cameras::Known ? known->covariance : std::vector<double>();
  }

  void fillRig() {
    rig::Rig& rig = out_.rig;
    for (std::size_t c = 0; c < camera_numbers_.size(); ++c) {
      if (!start_.camera_posed[c]) continue;
      const RigState::Camera& camera = state_.cameras[c];
      rig.cameras.push_back({camera_numbers_[c], camera.intrinsics, camera.camera_from_turntable,
                             camera.focal_sd_px, intrinsics_rms_[c], camera.inset_px,
                             mode_ == Cameras::Free ? camera.covariance : knownCovariance(c)});
    }
    rig.stops = stop_numbers_;
    rig.stop_angles_rad = state_.angles_rad[0];
    for (double& angle : rig.stop_angles_rad) angle -= state_.angles_rad[0][0];
    rig.reprojection_rms_px = out_.reprojection_rms_px;
  }

  const std::optional<rig::Rig>& known_;
  Cameras mode_ = Cameras::Free;
  std::vector<int> camera_numbers_, stop_numbers_;  // ascending; their places are the indices
  std::vector<double> intrinsics_rms_;
  RigStart start_;
};

}  // namespace

Result<BatchPoses> poseBatch(const batch::Batch& batch, const std::optional<rig::Rig>& known,
                             const PoseOptions& options, Progress& progress, std::stop_token stop) {
  return Poser(batch, known, options, progress, std::move(stop)).run();
}

}  // namespace ostraka::calibration
