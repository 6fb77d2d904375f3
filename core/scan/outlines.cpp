#include "scan/outlines.h"

#include <algorithm>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <unordered_map>

namespace ostraka::scan {
namespace {

constexpr std::size_t kSamples = 200;  // of a piece's points
constexpr double kHeld = 0.8;          // of the samples in a picture, which shows half of them
constexpr double kNearlyAll = 0.95;    // of the photographs that show both; a spoilt mask may miss
constexpr std::size_t kFewestViews = 3;

// The outline that holds most of a piece, or 0.
int outlineOf(const PointCloud& piece, const rig::PosedImage& image, const cv::Mat1i& labels) {
  const std::size_t step = std::max<std::size_t>(1, piece.size() / kSamples);
  std::unordered_map<int, int> votes;
  int seen = 0, all = 0;
  for (std::size_t i = 0; i < piece.size(); i += step, ++all) {
    const Eigen::Vector3d q = image.camera_from_plate * piece.points[i].cast<double>();
    if (q.z() <= 0) continue;
    const Eigen::Vector2d p = image.intrinsics.project(q);
    const int x = cvRound(p.x()), y = cvRound(p.y());
    if (x < 0 || y < 0 || x >= labels.cols || y >= labels.rows) continue;
    ++seen;
    ++votes[labels(y, x)];
  }
  if (2 * seen < all) return 0;
  for (const auto& [label, count] : votes)
    if (label > 0 && count >= kHeld * seen) return label;
  return 0;
}

// labels: by photograph, then by piece.
bool together(const std::vector<std::vector<int>>& labels, std::size_t a, std::size_t b) {
  std::size_t both = 0, same = 0;
  for (const std::vector<int>& view : labels) {
    if (view[a] == 0 || view[b] == 0) continue;
    ++both;
    if (view[a] == view[b]) ++same;
  }
  return both >= kFewestViews && 2 * both >= labels.size() &&
         static_cast<double>(same) >= kNearlyAll * static_cast<double>(both);
}

}  // namespace

std::vector<std::size_t> thingsOf(std::span<const PointCloud> pieces,
                                  std::span<const rig::PosedImage> images,
                                  std::span<const cv::Mat1b> masks) {
  std::vector<std::size_t> thing(pieces.size());
  std::iota(thing.begin(), thing.end(), std::size_t{0});
  if (pieces.size() < 2 || masks.empty()) return thing;
  std::vector<std::vector<int>> labels;
  for (std::size_t v = 0; v < masks.size(); ++v) {
    cv::Mat1i outlines;
    cv::connectedComponents(masks[v] >= 128, outlines, 8, CV_32S);
    std::vector<int>& of_piece = labels.emplace_back();
    for (const PointCloud& piece : pieces)
      of_piece.push_back(outlineOf(piece, images[v], outlines));
  }
  std::vector<std::size_t> by_size = thing;
  std::ranges::stable_sort(
      by_size, [&](std::size_t a, std::size_t b) { return pieces[a].size() > pieces[b].size(); });
  for (std::size_t i = 0; i < by_size.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::size_t larger = by_size[j];
      if (thing[larger] != larger || !together(labels, by_size[i], larger)) continue;
      thing[by_size[i]] = larger;
      break;
    }
  return thing;
}

}  // namespace ostraka::scan
