#include "rig/plate_markers.h"

#include <algorithm>
#include <map>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "batch/photograph.h"
#include "rig/marker_dictionary.h"

namespace ostraka::rig {
namespace {

// Errors of fitted edges (measured 0.06 px at edges of 60 to 100 px) and of contours, which follow
// whole pixels.
constexpr double kEdgeSdPx = 0.06;
constexpr double kContourSdPx = 0.5;

}  // namespace

Result<std::vector<SeenMarker>> findPlateMarkers(const cv::Mat& photograph,
                                                 const batch::Plate& plate) {
  const Result<cv::Ptr<cv::aruco::Dictionary>> dictionary = markerDictionary(plate.dictionary);
  if (!dictionary) return dictionary.error();
  const cv::Mat grey = batch::greyOf(photograph);
  const auto parameters = cv::aruco::DetectorParameters::create();
  // Lines through the contour start within a pixel; OpenCV's sub-pixel corners now and then run
  // away by several pixels along an edge.
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_CONTOUR;
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(grey, *dictionary, corners, ids, parameters);

  std::set<int> ours;
  for (const batch::Marker& marker : plate.markers) ours.insert(marker.id);
  std::map<int, int> times;
  for (const int id : ids) ++times[id];
  std::vector<SeenMarker> seen;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!ours.contains(ids[i]) || times[ids[i]] > 1) continue;
    SeenMarker marker{ids[i], toQuad(corners[i]), kContourSdPx};
    if (const auto refined = refineByEdges(grey, marker.corners, (*dictionary)->markerSize)) {
      marker.corners = *refined;
      marker.sd_px = kEdgeSdPx;
    }
    seen.push_back(marker);
  }
  std::sort(seen.begin(), seen.end(),
            [](const SeenMarker& a, const SeenMarker& b) { return a.id < b.id; });
  return seen;
}

}  // namespace ostraka::rig
