#include "rig/sheet_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <opencv2/calib3d.hpp>
#include <optional>
#include <set>
#include <string>

#include "base/median.h"
#include "base/message.h"
#include "base/parallel.h"
#include "batch/photograph.h"
#include "rig/marker_dictionary.h"
#include "rig/sheet_bundle.h"

namespace ostraka::rig {
namespace fs = std::filesystem;
namespace {

// Of each family the largest, of which the smaller ones are the first markers.
struct Family {
  const char* name;
  std::array<int, 4> sizes;  // 0: the family has no smaller ones, and its name is whole
};
constexpr std::array<Family, 9> kFamilies{{{"DICT_4X4_", {50, 100, 250, 1000}},
                                           {"DICT_5X5_", {50, 100, 250, 1000}},
                                           {"DICT_6X6_", {50, 100, 250, 1000}},
                                           {"DICT_7X7_", {50, 100, 250, 1000}},
                                           {"DICT_ARUCO_ORIGINAL", {}},
                                           {"DICT_APRILTAG_16h5", {}},
                                           {"DICT_APRILTAG_25h9", {}},
                                           {"DICT_APRILTAG_36h10", {}},
                                           {"DICT_APRILTAG_36h11", {}}}};

constexpr double kProbedMegapixels = 2;  // markers that are read at all are read there
constexpr std::size_t kLeastMarkers = 4, kLeastPhotographs = 3;
// Longer side over focal length: a telephone, a camera's usual lens, a portrait lens.
constexpr std::array<double, 3> kFocalLengths{0.8, 1.2, 2.2};
constexpr double kElsewhere = 6;  // times the usual error: not on this sheet

std::string largest(const Family& family) {
  return family.sizes[3] == 0 ? family.name : family.name + std::to_string(family.sizes[3]);
}

std::string smallest(const Family& family, int id) {
  for (const int size : family.sizes)
    if (id < size) return family.name + std::to_string(size);
  return family.name;
}

// A plate of which only the ids matter.
Result<batch::Plate> allOf(const std::string& dictionary) {
  const auto found = markerDictionary(dictionary);
  if (!found) return found.error();
  batch::Plate plate;
  plate.dictionary = dictionary;
  plate.markers.resize(static_cast<std::size_t>((*found)->bytesList.rows));
  for (std::size_t i = 0; i < plate.markers.size(); ++i) plate.markers[i].id = static_cast<int>(i);
  return plate;
}

std::vector<fs::path> spread(const std::vector<fs::path>& files, std::size_t most) {
  std::vector<fs::path> chosen;
  for (std::size_t i = 0, n = std::min(most, files.size()); i < n; ++i)
    chosen.push_back(files[i * files.size() / n]);
  return chosen;
}

// Markers of the photographs that can be read; of all ids in the dictionary.
Result<std::vector<SheetView>> viewsOf(const std::vector<fs::path>& files,
                                       const std::string& dictionary, double megapixels,
                                       int threads, const std::stop_token& stop) {
  const Result<batch::Plate> plate = allOf(dictionary);
  if (!plate) return plate.error();
  std::vector<SheetView> views(files.size());
  parallelFor(files.size(), threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const Result<cv::Mat> whole = batch::readPhotograph(files[i]);
    if (!whole) return;
    const double less = std::sqrt(1e6 * megapixels / static_cast<double>(whole->total()));
    const cv::Mat picture =
        less >= 1 ? *whole
                  : batch::reducedTo(*whole, static_cast<int>(std::lround(less * whole->cols)),
                                     static_cast<int>(std::lround(less * whole->rows)));
    views[i].width = picture.cols;
    views[i].height = picture.rows;
    if (auto seen = findPlateMarkers(picture, *plate)) views[i].markers = std::move(*seen);
  });
  if (stop.stop_requested()) return Error::cancelled();
  return views;
}

// Ids that more than one photograph shows: a false reading seldom comes twice.
std::map<int, int> timesSeen(const std::vector<SheetView>& views) {
  std::map<int, int> times;
  for (const SheetView& view : views)
    for (const SeenMarker& seen : view.markers) ++times[seen.id];
  std::erase_if(times, [](const auto& id) { return id.second < 2; });
  return times;
}

struct Read {
  std::string dictionary;
  int markers = 0;
};

Result<Read> readMost(const std::vector<fs::path>& files, const SheetLayoutOptions& options,
                      Progress& progress, const std::stop_token& stop) {
  Read best;
  for (std::size_t f = 0; f < kFamilies.size(); ++f) {
    progress.report(static_cast<std::int64_t>(f), static_cast<std::int64_t>(kFamilies.size() + 1));
    const auto views =
        viewsOf(files, largest(kFamilies[f]), kProbedMegapixels, options.threads, stop);
    if (!views) return views.error();
    const std::map<int, int> times = timesSeen(*views);
    const int seen = std::accumulate(times.begin(), times.end(), 0,
                                     [](int sum, const auto& id) { return sum + id.second; });
    if (seen <= best.markers) continue;
    best = {smallest(kFamilies[f], times.rbegin()->first), seen};
  }
  return best;
}

cv::Matx33d cameraOf(const SheetView& view, double focal) {
  const double f = focal * std::max(view.width, view.height);
  return {f, 0, 0.5 * (view.width - 1), 0, f, 0.5 * (view.height - 1), 0, 0, 1};
}

Eigen::Isometry3d poseOf(const cv::Mat& turn, const cv::Mat& shift) {
  cv::Matx33d r;
  cv::Rodrigues(turn, r);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) pose.linear()(i, k) = r(i, k);
    pose.translation()[i] = shift.at<double>(i);
  }
  return pose;
}

// Poses that a flat target may have, at most two; the first meets the corners better.
std::vector<Eigen::Isometry3d> posesOf(const std::vector<cv::Point3d>& corners,
                                       const std::vector<cv::Point2d>& pixels,
                                       const cv::Matx33d& camera) {
  std::vector<cv::Mat> turns, shifts;
  std::vector<Eigen::Isometry3d> poses;
  try {
    cv::solvePnPGeneric(corners, pixels, camera, cv::noArray(), turns, shifts, false,
                        cv::SOLVEPNP_IPPE);
  } catch (const cv::Exception&) {
    return {};
  }
  for (std::size_t i = 0; i < turns.size(); ++i) poses.push_back(poseOf(turns[i], shifts[i]));
  std::erase_if(poses, [](const Eigen::Isometry3d& pose) {
    return !pose.matrix().allFinite() || pose.translation().z() <= 0;
  });
  return poses;
}

void append(const FlatMarker& marker, double side_mm, const SeenMarker& seen,
            std::vector<cv::Point3d>& corners, std::vector<cv::Point2d>& pixels) {
  const auto flat = cornersOf(marker, side_mm);
  for (std::size_t c = 0; c < 4; ++c) {
    corners.emplace_back(flat[c].x(), flat[c].y(), 0);
    pixels.emplace_back(seen.corners[c].x(), seen.corners[c].y());
  }
}

// Where the ray of a pixel meets the sheet.
Eigen::Vector2d onSheet(const Eigen::Vector2d& pixel, const cv::Matx33d& camera,
                        const Eigen::Isometry3d& sheet_from_camera) {
  const Eigen::Vector3d ray((pixel.x() - camera(0, 2)) / camera(0, 0),
                            (pixel.y() - camera(1, 2)) / camera(1, 1), 1);
  const Eigen::Vector3d direction = sheet_from_camera.linear() * ray;
  const Eigen::Vector3d centre = sheet_from_camera.translation();
  return (centre - centre.z() / direction.z() * direction).head<2>();
}

FlatMarker flatOf(const SeenMarker& seen, const cv::Matx33d& camera,
                  const Eigen::Isometry3d& sheet_from_camera) {
  std::array<Eigen::Vector2d, 4> at;
  for (std::size_t c = 0; c < 4; ++c) at[c] = onSheet(seen.corners[c], camera, sheet_from_camera);
  const Eigen::Vector2d middle = 0.25 * (at[0] + at[1] + at[2] + at[3]);
  const Eigen::Vector2d right = at[1] - at[0] + at[2] - at[3];
  return {middle.x(), middle.y(), std::atan2(right.y(), right.x())};
}

// The pose of one photograph: the plane in which most of its markers, each a square, agree.
std::optional<Eigen::Isometry3d> planeOf(const SheetView& view, double side_mm,
                                         const cv::Matx33d& camera) {
  std::vector<Eigen::Isometry3d> poses;
  for (const SeenMarker& seen : view.markers) {
    std::vector<cv::Point3d> corners;
    std::vector<cv::Point2d> pixels;
    append({0, 0, 0}, side_mm, seen, corners, pixels);
    for (const Eigen::Isometry3d& pose : posesOf(corners, pixels, camera)) poses.push_back(pose);
  }
  constexpr double kAgree = 0.97;  // cosine of 14 degrees
  std::size_t best = 0, most = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    std::size_t agree = 0;
    for (const Eigen::Isometry3d& other : poses)
      agree += poses[i].linear().col(2).dot(other.linear().col(2)) > kAgree ? 1 : 0;
    if (agree <= most) continue;
    most = agree;
    best = i;
  }
  if (most == 0) return {};
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(), middle = Eigen::Vector3d::Zero();
  for (const Eigen::Isometry3d& pose : poses)
    if (poses[best].linear().col(2).dot(pose.linear().col(2)) > kAgree) {
      normal += pose.linear().col(2);
      middle += pose.translation() / static_cast<double>(most);
    }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      Eigen::Quaterniond::FromTwoVectors(poses[best].linear().col(2), normal).toRotationMatrix() *
      poses[best].linear();
  pose.translation() = middle;
  return pose;
}

// Goes from the photograph with the most markers to those that share most with what is known.
SheetBundle started(const std::vector<SheetView>& all, double side_mm, double focal) {
  SheetBundle sheet{side_mm, focal, {}, {}};
  std::vector<const SheetView*> left;
  for (const SheetView& view : all) left.push_back(&view);
  while (!left.empty()) {
    const auto shared = [&sheet](const SheetView* view) {
      if (sheet.views.empty()) return view->markers.size();
      return static_cast<std::size_t>(
          std::count_if(view->markers.begin(), view->markers.end(),
                        [&](const SeenMarker& m) { return sheet.markers.contains(m.id); }));
    };
    const auto next = std::max_element(
        left.begin(), left.end(),
        [&](const SheetView* a, const SheetView* b) { return shared(a) < shared(b); });
    if (shared(*next) < 2) break;
    SheetView view = **next;
    left.erase(next);
    const cv::Matx33d camera = cameraOf(view, focal);
    std::vector<cv::Point3d> corners;
    std::vector<cv::Point2d> pixels;
    for (const SeenMarker& seen : view.markers)
      if (const auto at = sheet.markers.find(seen.id); at != sheet.markers.end())
        append(at->second, side_mm, seen, corners, pixels);
    std::optional<Eigen::Isometry3d> pose;
    if (sheet.views.empty())
      pose = planeOf(view, side_mm, camera);
    else if (const auto poses = posesOf(corners, pixels, camera); !poses.empty())
      pose = poses.front();
    if (!pose) continue;
    view.camera_from_sheet = *pose;
    for (const SeenMarker& seen : view.markers)
      sheet.markers.emplace(seen.id, flatOf(seen, camera, pose->inverse()));
    sheet.views.push_back(std::move(view));
  }
  return sheet;
}

// The best of several focal lengths to start with; markers that do not lie on the sheet are left
// out of a second fit.
std::optional<std::pair<SheetBundle, SheetFit>> fitted(const std::vector<SheetView>& views,
                                                       double side_mm, std::vector<int>& left_out,
                                                       const std::stop_token& stop) {
  std::optional<std::pair<SheetBundle, SheetFit>> best;
  for (const double focal : kFocalLengths) {
    if (stop.stop_requested()) return {};
    SheetBundle sheet = started(views, side_mm, focal);
    if (sheet.views.size() < kLeastPhotographs || sheet.markers.size() < kLeastMarkers) continue;
    const SheetFit fit = fitSheet(sheet);
    if (fit.converged && (!best || fit.rms_px < best->second.rms_px)) best = {sheet, fit};
  }
  if (!best) return {};
  std::vector<double> errors;
  for (const auto& [id, rms] : best->second.marker_rms_px) errors.push_back(rms);
  const double usual = medianOf(errors);
  for (const auto& [id, rms] : best->second.marker_rms_px)
    if (rms > kElsewhere * usual) {
      left_out.push_back(id);
      best->first.markers.erase(id);
    }
  if (!left_out.empty()) best->second = fitSheet(best->first);
  return best;
}

// Along the sheet's edges, tops upwards as most are, the middle of all in the origin.
batch::Plate plateOf(const SheetBundle& sheet, const std::string& dictionary) {
  Eigen::Vector2d quarter = Eigen::Vector2d::Zero();
  for (const auto& [id, marker] : sheet.markers)
    quarter += Eigen::Vector2d(std::cos(4 * marker[2]), std::sin(4 * marker[2]));
  const double along = 0.25 * std::atan2(quarter.y(), quarter.x());
  std::array<int, 4> tops{};
  for (const auto& [id, marker] : sheet.markers)
    ++tops[static_cast<std::size_t>(std::lround((marker[2] - along) / M_PI_2) & 3)];
  const double turn =
      along +
      M_PI_2 * static_cast<double>(std::max_element(tops.begin(), tops.end()) - tops.begin());
  const Eigen::Rotation2Dd upright(-turn);
  Eigen::AlignedBox2d box;
  double gap_mm = 1e9;
  for (const auto& [id, marker] : sheet.markers)
    for (const Eigen::Vector2d& corner : cornersOf(marker, sheet.side_mm)) {
      box.extend(upright * corner);
      for (const auto& [other, beside] : sheet.markers)
        if (other != id)
          for (const Eigen::Vector2d& to : cornersOf(beside, sheet.side_mm))
            gap_mm = std::min(gap_mm, (to - corner).norm());
    }
  batch::Plate plate;
  plate.dictionary = dictionary;
  for (const auto& [id, marker] : sheet.markers) {
    batch::Marker out;
    out.id = id;
    const auto corners = cornersOf(marker, sheet.side_mm);
    for (std::size_t c = 0; c < 4; ++c) out.corners[c] << upright * corners[c] - box.center(), 0;
    for (const Eigen::Vector3d& corner : out.corners)
      plate.diameter_mm = std::max(plate.diameter_mm, 2 * corner.norm());
    plate.markers.push_back(out);
  }
  const Eigen::Vector2d half = 0.5 * box.sizes() + Eigen::Vector2d::Constant(gap_mm);
  plate.sheet = Eigen::AlignedBox2d(-half, half);
  return plate;
}

Error unread(std::size_t photographs) {
  return Error::notEnough(message(
      "No sheet with at least %1 markers of OpenCV's dictionaries was found in these %2 "
      "photographs; take photographs that show more of the sheet, or specify its plate.json.",
      kLeastMarkers, photographs));
}

}  // namespace

Result<void> checkMarkerSide(double marker_mm) {
  if (marker_mm > 0.5 && marker_mm < 1000) return {};
  return Error::unusable(
      message("The side of a marker must be between 0.5 and 1000 mm; measure a black square on the "
              "paper."));
}

Result<SheetLayout> proposeSheet(const std::vector<fs::path>& photographs,
                                 const SheetLayoutOptions& options, Progress& progress,
                                 std::stop_token stop) {
  if (const Result<void> good = checkMarkerSide(options.marker_mm); !good) return good.error();
  const Result<Read> read = readMost(spread(photographs, static_cast<std::size_t>(options.probed)),
                                     options, progress, stop);
  if (!read) return read.error();
  if (read->markers == 0) return unread(photographs.size());
  Result<std::vector<SheetView>> views =
      viewsOf(spread(photographs, static_cast<std::size_t>(options.photographs)), read->dictionary,
              1e6, options.threads, stop);
  if (!views) return views.error();
  const std::map<int, int> times = timesSeen(*views);
  SheetLayout layout;
  std::set<int> once;
  for (SheetView& view : *views)
    std::erase_if(view.markers, [&](const SeenMarker& seen) {
      if (times.contains(seen.id)) return false;
      once.insert(seen.id);
      return true;
    });
  std::vector<int> elsewhere;
  const auto sheet = fitted(*views, options.marker_mm, elsewhere, stop);
  if (stop.stop_requested()) return Error::cancelled();
  if (!sheet || sheet->first.markers.size() < kLeastMarkers) return unread(photographs.size());
  layout.plate = plateOf(sheet->first, read->dictionary);
  layout.photographs = static_cast<int>(sheet->first.views.size());
  layout.rms_px = sheet->second.rms_px;
  layout.left_out.assign(once.begin(), once.end());
  layout.left_out.insert(layout.left_out.end(), elsewhere.begin(), elsewhere.end());
  std::sort(layout.left_out.begin(), layout.left_out.end());
  return layout;
}

}  // namespace ostraka::rig
