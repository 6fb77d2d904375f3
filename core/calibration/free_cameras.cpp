#include "calibration/free_cameras.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "base/message.h"
#include "base/text.h"
#include "calibration/held_out.h"
#include "calibration/lenses.h"
#include "calibration/marker_poser.h"
#include "rig/view_pose.h"

namespace ostraka::calibration {
namespace {

constexpr int kFewestViews = 3;
constexpr double kBend = 0.02;          // of the sheet's half diagonal: 3.6 mm for A4
constexpr double kMostBent = 0.1;       // of the corner's distance from the middle
constexpr std::size_t kNamedAlone = 3;  // of more photographs one sentence tells
constexpr double kMostDropped = 0.5;    // of a photograph's markers; a pose from fewer is chance
constexpr double kNamedBend_mm = 1;     // a sheet this flat harms nothing

// Markers in one part of a picture do not determine the higher terms of a lens: what would move the
// picture's corner by a tenth is none's. Without them the adjustment finds those that it can.
rig::Intrinsics withinReason(rig::Intrinsics lens) {
  const double r2 = (Eigen::Vector2d(0.5 * lens.width, 0.5 * lens.height) / lens.fx).squaredNorm();
  const auto& d = lens.distortion;
  if (std::abs(d[1]) * r2 * r2 > kMostBent || std::abs(d[4]) * r2 * r2 * r2 > kMostBent)
    lens.distortion = {};
  return lens;
}

class FreePoser : MarkerPoser {
 public:
  FreePoser(const batch::Batch& batch, const PoseOptions& options, Progress& progress,
            std::stop_token stop)
      : MarkerPoser(batch, options, progress, std::move(stop)) {}

  Result<BatchPoses> run() {
    if (const Result<void> read = readMarkers(progress_); !read) return read.error();
    groupLenses();
    if (const Result<void> found = findStart(); !found) return found.error();
    if (const Result<void> done = adjustOnce(1, adjustOptions()); !done) return done.error();
    dropOutliers();
    if (const Result<void> done = adjustOnce(sdScale(), adjustOptions()); !done)
      return done.error();
    if (const Result<void> done = holdOut(); !done) return done.error();
    return poses();
  }

 private:
  int platePoints() const { return static_cast<int>(4 * batch_.plate->markers.size()); }

  void groupLenses() {
    by_exif_ = lensesOf(batch_.shots);
    std::vector<TargetView> views;
    for (std::size_t i = 0; i < markers_.size(); ++i) views.push_back(viewOf(i));
    lens_ = toldApart(by_exif_, batch_.shots, views);
    int count = 0;
    for (const int lens : lens_) count = std::max(count, lens + 1);
    out_.cameras.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < lens_.size(); ++i) {
      CameraFindings& found = out_.cameras[static_cast<std::size_t>(lens_[i])];
      found.camera = lens_[i];
      found.width = batch_.shots[i].width;
      found.height = batch_.shots[i].height;
    }
    if (lens_ != by_exif_)
      inform("rig: photographs of one camera were taken at several focal lengths; " +
             std::to_string(count) + " lenses are distinguished");
  }

  Result<rig::Intrinsics> lensFromMarkers(int lens) const {
    std::vector<TargetView> views;
    int width = 0, height = 0;
    for (std::size_t i = 0; i < markers_.size(); ++i) {
      if (lens_[i] != lens) continue;
      width = batch_.shots[i].width;
      height = batch_.shots[i].height;
      if (markers_[i].size() >= 4) views.push_back(viewOf(i));
    }
    Result<IntrinsicsReport> report = calibrateIntrinsics(views, width, height);
    if (!report) report = intrinsicsFromPlate(views, width, height);
    if (!report) return report.error();
    return withinReason(report->intrinsics);
  }

  Result<void> findStart() {
    std::vector<std::optional<rig::Intrinsics>> lenses;
    for (std::size_t k = 0; k < out_.cameras.size(); ++k) {
      const Result<rig::Intrinsics> lens = lensFromMarkers(static_cast<int>(k));
      lenses.push_back(lens ? std::optional(*lens) : std::nullopt);
    }
    std::vector<std::size_t> unposed;
    dropped_.resize(markers_.size());
    places_.clear();
    for (std::size_t i = 0; i < markers_.size(); ++i)
      places_.push_back({-1, sideOf(i), 0, sideOf(i) * platePoints()});
    for (std::size_t i = 0; i < markers_.size(); ++i) {
      dropped_[i].assign(markers_[i].size(), 0);
      const auto pose = poseByBestLens(i, lenses);
      const std::optional<rig::Intrinsics>& lens = lenses[static_cast<std::size_t>(lens_[i])];
      if (!pose) {
        if (readable_[i]) unposed.push_back(i);
        continue;
      }
      for (std::size_t m = 0; m < markers_[i].size(); ++m)
        if (!pose->agrees[m]) drop(i, m, "it is not where the other markers place it");
      places_[i].camera = static_cast<int>(state_.cameras.size());
      RigState::Camera& camera = state_.cameras.emplace_back();
      camera.intrinsics = *lens;
      camera.camera_from_turntable = pose->camera_from_plate;
      lens_of_camera_.push_back(lens_[i]);
    }
    nameUnposed(unposed);
    for (std::vector<double>& angles : state_.angles_rad) angles = {0};
    state_.print_errors_mm.assign(static_cast<std::size_t>(2 * platePoints()),
                                  Eigen::Vector3d::Zero());
    return enoughViews();
  }

  // One photograph does not always tell its own focal length: of the lenses that its camera was
  // found to have it gets the one with which most of its markers agree.
  std::optional<rig::PoseFromMarkers> poseByBestLens(
      std::size_t shot, const std::vector<std::optional<rig::Intrinsics>>& lenses) {
    std::optional<rig::PoseFromMarkers> best;
    std::ptrdiff_t most = -1;
    for (const int k : lensesOfCamera(by_exif_[shot], lens_[shot])) {
      const std::optional<rig::Intrinsics>& lens = lenses[static_cast<std::size_t>(k)];
      auto pose = lens ? rig::poseFromMarkers(markers_[shot], *lens) : std::nullopt;
      if (!pose) continue;
      const std::ptrdiff_t agree = std::count(pose->agrees.begin(), pose->agrees.end(), char{1});
      if (agree > most) most = agree, best = std::move(pose), lens_[shot] = k;
    }
    return best;
  }

  // All that were told apart of one by EXIF; `first` comes first.
  std::vector<int> lensesOfCamera(int by_exif, int first) const {
    std::vector<int> lenses{first};
    for (std::size_t i = 0; i < lens_.size(); ++i)
      if (by_exif_[i] == by_exif &&
          std::find(lenses.begin(), lenses.end(), lens_[i]) == lenses.end())
        lenses.push_back(lens_[i]);
    return lenses;
  }

  void nameUnposed(const std::vector<std::size_t>& shots) {
    if (shots.size() > kNamedAlone) {
      std::string names;
      for (std::size_t k = 0; k < kNamedAlone; ++k)
        names += (k > 0 ? ", " : "") + batch_.shots[shots[k]].file.filename().string();
      return warn(
          message("Photographs that show too few of the sheet's markers for a pose are left out "
                  "(%1 and %2 more); check that they show this sheet.",
                  names, shots.size() - kNamedAlone));
    }
    for (const std::size_t shot : shots)
      warn(
          message("%1: %2 of the sheet's markers can be read, too few for a pose; the photograph "
                  "is left out.",
                  batch_.shots[shot].file.string(), markers_[shot].size()));
  }

  Result<void> enoughViews() const {
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
      int shots = 0, posed = 0;
      for (std::size_t i = 0; i < markers_.size(); ++i) {
        if (batch_.shots[i].side != side) continue;
        ++shots;
        posed += places_[i].camera >= 0 ? 1 : 0;
      }
      if (shots == 0 || posed >= kFewestViews) continue;
      return Error::notEnough(
          message("The sheet's markers can be read in %1 of %2 photographs of the %3 side; at "
                  "least 3 are needed. Check that plate.json describes this sheet, that the "
                  "photographs are not mirrored, and that most of the markers are in the picture.",
                  posed, shots, batch::name(side)),
          (batch_.plate_file.empty() ? batch_.folder : batch_.plate_file).string());
    }
    return {};
  }

  AdjustOptions adjustOptions() const {
    AdjustOptions options;
    options.cameras = Cameras::Separate;
    options.lenses.lens_of_camera = lens_of_camera_;
    double half_diagonal = 0;
    for (const batch::Marker& marker : batch_.plate->markers)
      for (const Eigen::Vector3d& corner : marker.corners)
        half_diagonal = std::max(half_diagonal, corner.head<2>().norm());
    options.bend_sd_mm = kBend * half_diagonal;
    return options;
  }

  // Distances that the fit does not know, side by side: the adjustment once more without four
  // markers.
  Result<void> holdOut() {
    const std::vector<PlateCorner> all = plateCorners(sdScale());
    for (int side = 0; side < 2; ++side) {
      std::vector<PlateCorner> own;
      for (PlateCorner corner : all) {
        if (corner.side != side) continue;
        corner.plate_point -= side * platePoints();
        own.push_back(corner);
      }
      const std::vector<std::size_t> chosen = markersToHoldOut(*batch_.plate, own);
      if (chosen.empty()) continue;
      std::vector<PlateCorner> others;
      for (const PlateCorner& corner : all) {
        const int marker = (corner.plate_point - corner.side * platePoints()) / 4;
        if (corner.side != side || std::find(chosen.begin(), chosen.end(), marker) == chosen.end())
          others.push_back(corner);
      }
      const Result<void> done = fitWithout(chosen, own, others, adjustOptions());
      if (!done) return done;
    }
    return {};
  }

  // How far the sheet of a side leaves its plane where its corners were seen.
  double bendOf(int side) const {
    double most = 0;
    for (const PlateCorner& corner : plateCorners(1))
      if (corner.side == side)
        most = std::max(
            most,
            std::abs(state_.print_errors_mm[static_cast<std::size_t>(corner.plate_point)].z()));
    return most;
  }

  Result<BatchPoses> poses() {
    std::vector<std::vector<double>> residuals(out_.cameras.size());
    for (std::size_t i = 0; i < markers_.size(); ++i) {
      if (places_[i].camera < 0) continue;
      const RigState::Camera& camera = state_.cameras[static_cast<std::size_t>(places_[i].camera)];
      const batch::Shot& shot = batch_.shots[i];
      const std::vector<double> errors = errorsOf(i);
      std::vector<double>& of_lens = residuals[static_cast<std::size_t>(lens_[i])];
      of_lens.insert(of_lens.end(), errors.begin(), errors.end());
      const double read = static_cast<double>(markers_[i].size());
      if (static_cast<double>(errors.size()) < (1 - kMostDropped) * read) {
        warn(
            message("%1: most of the sheet's markers are not where the other photographs place "
                    "them; the photograph is left out.",
                    shot.file.string()));
        places_[i].camera = -1;
        continue;
      }
      addImage({shot.file.string(), shot.side, shot.camera, shot.stop, camera.intrinsics,
                camera.camera_from_turntable},
               errors);
    }
    if (const Result<void> enough = enoughViews(); !enough) return enough.error();
    for (std::size_t k = 0; k < residuals.size(); ++k)
      out_.cameras[k].median_residual_px = medianOf(residuals[k]);
    out_.bends = state_.bends;
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
      if (const double bend = bendOf(side == batch::Side::Front ? 0 : 1); bend > kNamedBend_mm)
        inform("rig: the sheet of the " + std::string(batch::name(side)) +
               " side is bent by up to " + fixed(bend, 1) + " mm; this is allowed for");
    tellError("photographs taken by hand");
    return std::move(out_);
  }

  std::vector<int> by_exif_;         // by shot: lenses as cameras tell them
  std::vector<int> lens_;            // by shot: as markers tell them, too
  std::vector<int> lens_of_camera_;  // by index in state_.cameras
};

}  // namespace

Result<BatchPoses> poseFreeCameras(const batch::Batch& batch, const PoseOptions& options,
                                   Progress& progress, std::stop_token stop) {
  return FreePoser(batch, options, progress, std::move(stop)).run();
}

}  // namespace ostraka::calibration
