#include <algorithm>
#include <cmath>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>

#include "base/message.h"
#include "batch/photograph.h"
#include "calibration/intrinsics.h"
#include "rig/marker_dictionary.h"
#include "rig/marker_edges.h"

namespace ostraka::calibration {
namespace {

struct FoundMarkers {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
};

FoundMarkers findMarkers(const cv::Mat& grey, const cv::Ptr<cv::aruco::Dictionary>& dictionary,
                         const cv::Ptr<cv::aruco::DetectorParameters>& parameters) {
  FoundMarkers found;
  cv::aruco::detectMarkers(grey, dictionary, found.corners, found.ids, parameters);
  return found;
}

// The shortest side of a marker on the photograph; 0 without markers.
double shortestSide(const FoundMarkers& found) {
  double shortest = 0;
  for (const auto& corners : found.corners)
    for (int c = 0; c < 4; ++c) {
      const double side = cv::norm(corners[c] - corners[(c + 1) % 4]);
      if (shortest == 0 || side < shortest) shortest = side;
    }
  return shortest;
}

void refine(const cv::Mat& grey, std::vector<cv::Point2f>& corners, int half_window) {
  if (corners.empty()) return;
  cv::cornerSubPix(grey, corners, cv::Size(half_window, half_window), cv::Size(-1, -1),
                   cv::TermCriteria(cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 60, 1e-4));
}

// Lines must not be the only thing seen: a view on one row of corners says nothing about tilt.
bool spansAPlane(const std::vector<Eigen::Vector3d>& points) {
  if (points.size() < 6) return false;
  const auto [x0, x1] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  const auto [y0, y1] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
  return x1->x() - x0->x() > 0 && y1->y() - y0->y() > 0;
}

}  // namespace

Result<TargetView> findBoard(const cv::Mat& photograph, const batch::Board& board) {
  const Result<cv::Ptr<cv::aruco::Dictionary>> dictionary = rig::markerDictionary(board.dictionary);
  if (!dictionary) return dictionary.error();
  if (board.squares_x * board.squares_y / 2 > (*dictionary)->bytesList.rows)
    return Error::unusable(
        message("The dictionary %1 has too few markers for the board.", board.dictionary));
  const auto charuco = cv::aruco::CharucoBoard::create(
      board.squares_x, board.squares_y, static_cast<float>(board.square_mm),
      static_cast<float>(board.marker_mm), *dictionary);
  const cv::Mat grey = batch::greyOf(photograph);
  TargetView view;
  const FoundMarkers found =
      findMarkers(grey, *dictionary, cv::aruco::DetectorParameters::create());
  if (found.ids.empty()) return view;
  std::vector<cv::Point2f> corners;
  std::vector<int> ids;
  cv::aruco::interpolateCornersCharuco(found.corners, found.ids, grey, charuco, corners, ids);
  // OpenCV 4.6 gives these corners half a pixel too far right and down.
  for (cv::Point2f& corner : corners) corner -= cv::Point2f(0.5F, 0.5F);
  // As far as the markers leave a corner its own: a fixed number of pixels would miss where the
  // corner is in large pictures, whose start is a few pixels off, and in soft ones.
  const double gap_px =
      shortestSide(found) * (board.square_mm - board.marker_mm) / 2 / board.marker_mm;
  refine(grey, corners, std::max(2, static_cast<int>(gap_px)));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const cv::Point3f p = charuco->chessboardCorners[ids[i]];
    view.points.emplace_back(p.x, p.y, p.z);
    view.pixels.emplace_back(corners[i].x, corners[i].y);
  }
  if (!spansAPlane(view.points)) view = {};
  return view;
}

Result<TargetView> findGrid(const cv::Mat& photograph, const MarkerGrid& grid) {
  const Result<cv::Ptr<cv::aruco::Dictionary>> dictionary = rig::markerDictionary(grid.dictionary);
  if (!dictionary) return dictionary.error();
  const cv::Mat grey = batch::greyOf(photograph);
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  const FoundMarkers found = findMarkers(grey, *dictionary, parameters);
  TargetView view;
  const double step = grid.marker_mm + grid.gap_mm;
  // The bands in which edges are looked for must end before the next marker.
  const int cells = std::max((*dictionary)->markerSize,
                             static_cast<int>(std::ceil(grid.marker_mm / grid.gap_mm)) - 2);
  for (std::size_t i = 0; i < found.ids.size(); ++i) {
    const int index = found.ids[i] - grid.first_id;
    if (index < 0 || index >= grid.markers_x * grid.markers_y) continue;
    // Edges, as on the plate: windows around corners would be of a fixed number of pixels, and find
    // them inside of the black by some tenths of the blur.
    const rig::Quad start = rig::toQuad(found.corners[i]);
    const rig::Quad corners = rig::refineByEdges(grey, start, cells).value_or(start);
    const Eigen::Vector3d origin(index % grid.markers_x * step, index / grid.markers_x * step, 0);
    for (std::size_t c = 0; c < 4; ++c) {
      view.points.push_back(origin + grid.marker_mm * Eigen::Vector3d(c == 1 || c == 2, c >= 2, 0));
      view.pixels.push_back(corners[c]);
    }
  }
  if (!spansAPlane(view.points)) view = {};
  return view;
}

}  // namespace ostraka::calibration
