#include "calibration/marker_poser.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "base/message.h"
#include "base/text.h"
#include "calibration/batch_corners.h"
#include "calibration/held_out.h"

namespace ostraka::calibration {
namespace {

double rms(double sum_of_squares, double count) {
  return count > 0 ? std::sqrt(sum_of_squares / count) : 0;
}

}  // namespace

void MarkerPoser::warn(const Message& text) {
  out_.warnings.push_back(text);
  progress_.note(NoteLevel::Warning, text);
}

Result<void> MarkerPoser::readMarkers(Progress& progress) {
  if (!batch_.plate)
    return Error::notEnough(
        message("plate.json is missing, so the plate's markers cannot be used; copy the file "
                "that 'ostraka plate' wrote with the plate into this folder."),
        batch_.folder.string());
  const Result<std::vector<ShotMarkers>> shots =
      findBatchMarkers(batch_, options_.threads, progress, stop_);
  if (!shots) return shots.error();
  for (const ShotMarkers& shot : *shots) {
    if (!shot.unreadable.empty())
      warn(inOne(shot.unreadable, message("This photograph is left out.")));
    markers_.push_back(rig::placed(shot.markers, *batch_.plate));
    readable_.push_back(shot.unreadable.empty());
  }
  return {};
}

TargetView MarkerPoser::viewOf(std::size_t shot) const {
  TargetView view;
  view.file = batch_.shots[shot].file.string();
  for (const rig::PlacedMarker& marker : markers_[shot])
    for (int c = 0; c < 4; ++c) {
      view.points.push_back(marker.corners[c]);
      view.pixels.push_back(marker.seen.corners[c]);
    }
  return view;
}

void MarkerPoser::drop(std::size_t shot, std::size_t marker, const std::string& reason) {
  dropped_[shot][marker] = 1;
  inform("rig: marker " + std::to_string(markers_[shot][marker].seen.id) + " in " +
         batch_.shots[shot].file.string() + " is not used: " + reason);
}

void MarkerPoser::append(std::vector<PlateCorner>& corners, std::size_t shot,
                         const rig::PlacedMarker& marker, double sd_scale) const {
  const rig::Quad outward = rig::outwardPerPixel(marker.seen.corners);
  const ShotPlace& place = places_[shot];
  const int first = place.first_point + static_cast<int>(marker.plate_index * 4);
  for (int c = 0; c < 4; ++c)
    corners.push_back({place.camera, place.side, place.stop, first + c, marker.corners[c],
                       marker.seen.corners[c], outward[c], marker.seen.sd_px * sd_scale});
}

std::vector<PlateCorner> MarkerPoser::plateCorners(double sd_scale) const {
  std::vector<PlateCorner> corners;
  for (std::size_t i = 0; i < markers_.size(); ++i)
    for (std::size_t m = 0; places_[i].camera >= 0 && m < markers_[i].size(); ++m)
      if (!dropped_[i][m]) append(corners, i, markers_[i][m], sd_scale);
  return corners;
}

Result<void> MarkerPoser::adjustOnce(double sd_scale, const AdjustOptions& options) {
  if (stop_.stop_requested()) return Error::cancelled();
  Result<RigState> state = adjust(state_, plateCorners(sd_scale), board_corners_, options);
  if (!state) return state.error();
  state_ = std::move(*state);
  return {};
}

double MarkerPoser::sdScale() const {
  std::vector<double> ratios;
  for (const PlateCorner& corner : plateCorners(1)) {
    const Eigen::Vector2d r = residual(state_, corner) / corner.sd_px;
    ratios.push_back(std::abs(r.x()));
    ratios.push_back(std::abs(r.y()));
  }
  return std::max(0.2, 1.4826 * medianOf(ratios));
}

double MarkerPoser::errorOf(std::size_t shot, const rig::PlacedMarker& marker) const {
  std::vector<PlateCorner> corners;
  append(corners, shot, marker, 1);
  double sum = 0;
  for (const PlateCorner& corner : corners) sum += residual(state_, corner).squaredNorm();
  return rms(sum, 4);
}

void MarkerPoser::dropOutliers() {
  const double scale = sdScale();
  for (std::size_t i = 0; i < markers_.size(); ++i)
    for (std::size_t m = 0; places_[i].camera >= 0 && m < markers_[i].size(); ++m) {
      if (dropped_[i][m]) continue;
      const double error = errorOf(i, markers_[i][m]);
      if (error > std::max(0.5, 6 * scale * markers_[i][m].seen.sd_px))
        drop(i, m, "it is off its place by " + fixed(error, 2) + " px");
    }
}

std::vector<double> MarkerPoser::errorsOf(std::size_t shot) const {
  std::vector<double> errors;
  for (std::size_t m = 0; m < markers_[shot].size(); ++m)
    if (!dropped_[shot][m]) errors.push_back(errorOf(shot, markers_[shot][m]));
  return errors;
}

Result<void> MarkerPoser::fitWithout(const std::vector<std::size_t>& markers,
                                     const std::vector<PlateCorner>& theirs,
                                     const std::vector<PlateCorner>& others,
                                     const AdjustOptions& options) {
  if (stop_.stop_requested()) return Error::cancelled();
  const Result<RigState> state = adjust(state_, others, {}, options);
  if (!state) return state.error();
  for (const HeldOutDistance& d : heldOutDistances(*batch_.plate, markers, *state, theirs)) {
    out_.held_out.push_back(d);
    if (const std::optional<Message> doubt = scaleDoubt(d))
      warn(*doubt);
    else
      inform(
          said("rig: markers %1 and %2, held out of the fit, are %3 mm apart instead of %4 (%5 mm, "
               "%6 %)",
               d));
  }
  return {};
}

void MarkerPoser::addImage(rig::PosedImage image, const std::vector<double>& errors) {
  double squares = 0;
  for (const double error : errors) squares += 4 * error * error;
  const double count = 4.0 * static_cast<double>(errors.size());
  squares_ += squares;
  corners_ += count;
  out_.images.push_back(std::move(image));
  out_.rms_per_image_px.push_back(rms(squares, count));
  out_.markers_per_image.push_back(static_cast<int>(errors.size()));
}

void MarkerPoser::tellError(const std::string& of_photographs) {
  out_.reprojection_rms_px = rms(squares_, corners_);
  inform("rig: " + fixed(out_.reprojection_rms_px, 3) + " px over " + fixed(corners_, 0) +
         " marker corners in " + std::to_string(out_.images.size()) + " " + of_photographs);
}

}  // namespace ostraka::calibration
