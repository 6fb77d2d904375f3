#include "scan/touching.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "cloud/bounds.h"
#include "scan/seam.h"

namespace ostraka::scan {
namespace {

constexpr double kSeamBroken = 0.8;  // of the line between two parts, or it is no seam

Plan planOf(const PointCloud& piece) {
  const auto [lowest, highest] = boundsOf(piece.points);
  const Eigen::Vector2f low = lowest.head<2>(), high = highest.head<2>();
  constexpr int kBorder = 4;
  Plan print;
  print.origin = low.cast<double>() - Eigen::Vector2d::Constant(kBorder * kPlanCell_mm);
  const Eigen::Vector2d size = (high - low).cast<double>() / kPlanCell_mm;
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
    const cv::Rect box(
        statistics.at<int>(k, cv::CC_STAT_LEFT), statistics.at<int>(k, cv::CC_STAT_TOP),
        statistics.at<int>(k, cv::CC_STAT_WIDTH), statistics.at<int>(k, cv::CC_STAT_HEIGHT));
    double widest = 0;
    cv::minMaxLoc(depth_mm(box), nullptr, &widest, nullptr, nullptr, numbers(box) == k);
    const double longest = std::max(box.width, box.height) * kPlanCell_mm;
    cores.push_back({k, widest, longest + 2 * eroded_mm});
  }
  return cores;
}

struct Cut {
  std::vector<Core> cores;
  cv::Mat1i parts;  // the core's number in each cell, 0 outside
  double half_neck_mm = 0;
};

// Whether all parts that meet do so at a neck or along a seam.
bool divided(const Cut& cut, double neck_share, const std::optional<SeenSurface>& surface) {
  for (std::size_t i = 0; i < cut.cores.size(); ++i)
    for (std::size_t j = i + 1; j < cut.cores.size(); ++j) {
      const Core &a = cut.cores[i], &b = cut.cores[j];
      if (cut.half_neck_mm <= neck_share * std::min(a.half_width_mm, b.half_width_mm)) continue;
      if (surface && brokenShare(cut.parts, a.number, b.number, *surface) < kSeamBroken)
        return false;
    }
  return true;
}

// The first wearing-down at which two or more real parts are told apart.
std::optional<Cut> firstCut(const Plan& plan, const TouchingOptions& options,
                            const std::optional<SeenSurface>& surface) {
  cv::Mat1f depth_mm;
  cv::distanceTransform(plan.filled, depth_mm, cv::DIST_L2, cv::DIST_MASK_5);
  depth_mm *= kPlanCell_mm;
  double deepest = 0;
  cv::minMaxLoc(depth_mm, nullptr, &deepest);
  const double share = surface ? options.seam_share : options.neck_share;
  for (double worn_mm = kPlanCell_mm; worn_mm < share * deepest; worn_mm += kPlanCell_mm / 2) {
    Cut cut{{}, {}, worn_mm};
    cv::Mat1i numbers;
    cut.cores = coresOf(depth_mm > worn_mm, depth_mm, worn_mm, numbers);
    const auto end = std::stable_partition(cut.cores.begin(), cut.cores.end(), [&](const Core& c) {
      return worn_mm <= share * c.half_width_mm && c.extent_mm >= options.min_extent_mm;
    });
    if (end - cut.cores.begin() < 2) continue;
    cv::Mat1i cores = numbers.clone();
    for (auto small = end; small != cut.cores.end(); ++small)
      cores.setTo(0, numbers == small->number);
    cut.cores.erase(end, cut.cores.end());
    cut.parts = partsReached(plan, cores, surface ? &*surface : nullptr);
    if (divided(cut, options.neck_share, surface)) return cut;
  }
  return {};
}

// The middle of the line between two parts.
std::optional<Eigen::Vector2d> meetingPlace(const cv::Mat1i& parts, int a, int b) {
  const std::vector<cv::Point> seam = seamBetween(parts, a, b);
  if (seam.empty()) return {};
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const cv::Point& p : seam) sum += Eigen::Vector2d(p.x + 0.5, p.y + 0.5);
  return sum / static_cast<double>(seam.size());
}

// Where a part comes nearest to any other.
Eigen::Vector2d nearestPlace(const cv::Mat1i& parts, int own) {
  cv::Mat1f away;
  cv::distanceTransform((parts == 0) | (parts == own), away, cv::DIST_L2, cv::DIST_MASK_5);
  cv::Point nearest;
  cv::minMaxLoc(away, nullptr, nullptr, &nearest, nullptr, parts == own);
  return {nearest.x + 0.5, nearest.y + 0.5};
}

// One for each two parts that meet. Parts of one outline need not meet in what stereo found.
std::vector<Neck> necksOf(const Cut& cut, const Plan& plan) {
  std::vector<Neck> necks;
  const auto add = [&](const Eigen::Vector2d& cells) {
    necks.push_back({plan.origin + cells * kPlanCell_mm, 2 * cut.half_neck_mm});
  };
  for (std::size_t j = 1; j < cut.cores.size(); ++j) {
    const std::size_t before = necks.size();
    for (std::size_t i = 0; i < j; ++i)
      if (const auto cells = meetingPlace(cut.parts, cut.cores[i].number, cut.cores[j].number))
        add(*cells);
    if (necks.size() == before) add(nearestPlace(cut.parts, cut.cores[j].number));
  }
  return necks;
}

}  // namespace

TouchingParts cutTouching(const PointCloud& piece, const TouchingOptions& options) {
  TouchingParts whole{1, std::vector<int>(piece.size(), 0), {}};
  if (piece.empty()) return whole;
  const Plan plan = planOf(piece);
  std::optional<SeenSurface> surface;
  if (piece.hasNormals()) surface = surfaceFromAbove(piece, plan);
  const std::optional<Cut> cut = firstCut(plan, options, surface);
  if (!cut) return whole;
  TouchingParts found{0, whole.part, {}};
  for (const Core& core : cut->cores) {
    bool holds_points = false;
    for (std::size_t i = 0; i < piece.size(); ++i)
      if (cut->parts(plan.cellOf(piece.points[i])) == core.number)
        found.part[i] = found.count, holds_points = true;
    if (holds_points) ++found.count;
  }
  if (found.count < 2) return whole;
  found.necks = necksOf(*cut, plan);
  return found;
}

}  // namespace ostraka::scan
