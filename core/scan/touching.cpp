#include "scan/touching.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace ostraka::scan {
namespace {

constexpr double kCell_mm = 0.5;  // two points of a scan, so that the outline has no holes

struct Plan {
  cv::Mat1b filled;  // 255 inside, with a free border
  Eigen::Vector2d origin;
  cv::Point cellOf(const Eigen::Vector3f& p) const {
    return {static_cast<int>((p.x() - origin.x()) / kCell_mm),
            static_cast<int>((p.y() - origin.y()) / kCell_mm)};
  }
};

Plan planOf(const PointCloud& piece) {
  Eigen::Vector2f low = piece.points[0].head<2>(), high = low;
  for (const Eigen::Vector3f& p : piece.points)
    low = low.cwiseMin(p.head<2>()), high = high.cwiseMax(p.head<2>());
  constexpr int kBorder = 4;
  Plan print;
  print.origin = low.cast<double>() - Eigen::Vector2d::Constant(kBorder * kCell_mm);
  const Eigen::Vector2d size = (high - low).cast<double>() / kCell_mm;
  print.filled = cv::Mat1b::zeros(static_cast<int>(size.y()) + 2 * kBorder + 1,
                                  static_cast<int>(size.x()) + 2 * kBorder + 1);
  for (const Eigen::Vector3f& p : piece.points) print.filled(print.cellOf(p)) = 255;
  // Points are up to a gap apart: close over 1.5 mm, then fill what the outline encloses.
  cv::morphologyEx(print.filled, print.filled, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(print.filled.clone(), outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::drawContours(print.filled, outlines, -1, 255, cv::FILLED);
  return print;
}

// One part of the worn outline: its widest place and its number among the parts.
struct Core {
  int number = 0;
  double half_width_mm = 0;
  double extent_mm = 0;
};

std::vector<Core> coresOf(const cv::Mat1b& worn, const cv::Mat1f& depth_mm, double eroded_mm,
                          cv::Mat1i& numbers) {
  cv::Mat statistics, centroids;
  const int count =
      cv::connectedComponentsWithStats(worn, numbers, statistics, centroids, 8, CV_32S);
  std::vector<Core> cores;
  for (int k = 1; k < count; ++k) {
    double widest = 0;
    cv::minMaxLoc(depth_mm, nullptr, &widest, nullptr, nullptr, numbers == k);
    const double longest = std::max(statistics.at<int>(k, cv::CC_STAT_WIDTH),
                                    statistics.at<int>(k, cv::CC_STAT_HEIGHT)) *
                           kCell_mm;
    cores.push_back({k, widest, longest + 2 * eroded_mm});
  }
  return cores;
}

// The first wearing-down at which two or more real parts separate; empty when there is none.
std::vector<Core> separatedCores(const cv::Mat1f& depth_mm, double neck_share, double min_extent_mm,
                                 double& half_neck_mm, cv::Mat1i& numbers) {
  double deepest = 0;
  cv::minMaxLoc(depth_mm, nullptr, &deepest);
  for (half_neck_mm = kCell_mm; half_neck_mm < neck_share * deepest; half_neck_mm += kCell_mm / 2) {
    std::vector<Core> cores = coresOf(depth_mm > half_neck_mm, depth_mm, half_neck_mm, numbers);
    std::erase_if(cores, [&](const Core& c) {
      return half_neck_mm > neck_share * c.half_width_mm || c.extent_mm < min_extent_mm;
    });
    if (cores.size() >= 2) return cores;
  }
  return {};
}

}  // namespace

TouchingParts cutTouching(const PointCloud& piece, double neck_share, double min_extent_mm) {
  TouchingParts parts;
  parts.part.assign(piece.size(), 0);
  if (piece.empty()) return parts;
  const Plan print = planOf(piece);
  cv::Mat1f depth_mm;
  cv::distanceTransform(print.filled, depth_mm, cv::DIST_L2, cv::DIST_MASK_5);
  depth_mm *= kCell_mm;
  double half_neck_mm = 0;
  cv::Mat1i numbers;
  const std::vector<Core> cores =
      separatedCores(depth_mm, neck_share, min_extent_mm, half_neck_mm, numbers);
  if (cores.size() < 2) return parts;

  // Distance from each core; what lies between belongs to the nearer one.
  std::vector<cv::Mat1f> from_core;
  for (const Core& core : cores) {
    cv::Mat1f distance;
    cv::distanceTransform(numbers != core.number, distance, cv::DIST_L2, cv::DIST_MASK_5);
    from_core.push_back(distance);
  }
  parts.count = static_cast<int>(cores.size());
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const cv::Point cell = print.cellOf(piece.points[i]);
    for (int k = 1; k < parts.count; ++k)
      if (from_core[static_cast<std::size_t>(k)](cell) <
          from_core[static_cast<std::size_t>(parts.part[i])](cell))
        parts.part[i] = k;
  }
  for (std::size_t k = 1; k < cores.size(); ++k) {
    cv::Mat1f both = from_core[0] + from_core[k];
    both.setTo(1e9f, print.filled == 0);
    cv::Point where;
    cv::minMaxLoc(both, nullptr, nullptr, &where);
    parts.necks.push_back(
        {print.origin + Eigen::Vector2d(where.x, where.y) * kCell_mm, 2 * half_neck_mm});
  }
  return parts;
}

}  // namespace ostraka::scan
