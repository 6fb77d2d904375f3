#include "checks/photo_checks.h"

#include <algorithm>
#include <array>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <set>

#include "base/median.h"
#include "base/parallel.h"
#include "base/text.h"
#include "batch/photograph.h"
#include "rig/edge_width.h"

namespace ostraka::checks {
namespace {

struct Look {
  double edge_px = 0;     ///< 0: too few edges to say
  std::vector<int> seen;  ///< ids of the markers with edges
};

// How much lighter it is outside of a marker's edges than inside: the median of twelve places.
// Cloth and shadows have edges of their own, but not these.
double stepAcross(const cv::Mat1b& soft, const std::array<Eigen::Vector2d, 4>& corners) {
  std::vector<double> steps;
  for (std::size_t c = 0; c < 4; ++c) {
    const Eigen::Vector2d a = corners[c], along = corners[(c + 1) % 4] - a;
    const Eigen::Vector2d out = Eigen::Vector2d(along.y(), -along.x()) / 10;  // within the margin
    for (const double t : {0.3, 0.5, 0.7}) {
      std::array<double, 2> values{};
      for (const int side : {0, 1}) {
        const Eigen::Vector2d p = a + t * along + (side == 1 ? out : Eigen::Vector2d(-out));
        const cv::Point pixel(cvRound(p.x()), cvRound(p.y()));
        if (!cv::Rect({0, 0}, soft.size()).contains(pixel)) return 0;
        values[static_cast<std::size_t>(side)] = soft(pixel);
      }
      steps.push_back(values[1] - values[0]);
    }
  }
  return medianOf(steps);
}

Result<Look> lookAt(const rig::PosedImage& image, const batch::Plate& plate,
                    const PhotoCheckOptions& options) {
  const Result<cv::Mat> photograph = batch::readPhotograph(image.file);
  if (!photograph) return photograph.error();
  cv::Mat1b grey;
  cv::cvtColor(*photograph, grey, cv::COLOR_BGR2GRAY);
  cv::Mat1b soft;
  cv::blur(grey, soft, {3, 3});
  Look look;
  std::vector<double> widths;
  for (const batch::Marker& marker : plate.markers) {
    std::array<Eigen::Vector2d, 4> corners;
    for (std::size_t c = 0; c < 4; ++c) corners[c] = image.project(marker.corners[c]);
    if (stepAcross(soft, corners) < options.least_step) continue;
    const std::vector<double> found = rig::edgeWidths(grey, corners);
    look.seen.push_back(marker.id);
    widths.insert(widths.end(), found.begin(), found.end());
  }
  look.edge_px = rig::typicalWidth(std::move(widths));
  return look;
}

Message blurWarning(const std::string& file, double edge_px, double sharpest_px, bool left_out) {
  const Decimal edge = decimal(edge_px, 1), sharpest = decimal(sharpest_px, 1);
  return left_out ? message(
                        "%1: The photograph is blurred: its edges are %2 pixels wide, those of "
                        "the camera's sharpest %3; it is left out, retake it.",
                        file, edge, sharpest)
                  : message(
                        "%1: The photograph is blurred: its edges are %2 pixels wide, those of "
                        "the camera's sharpest %3; retake it.",
                        file, edge, sharpest);
}

// Nothing is left out: they are all there is.
Message allBlurredWarning(batch::Side side, double edge_px) {
  const Decimal edge = decimal(edge_px, 0);
  return side == batch::Side::Front
             ? message(
                   "All photographs of the front side are blurred: even in the sharpest, the "
                   "markers' edges are %1 pixels wide, so its scans are coarse. Check focus "
                   "and shutter speed, and reshoot this side.",
                   edge)
             : message(
                   "All photographs of the back side are blurred: even in the sharpest, the "
                   "markers' edges are %1 pixels wide, so its scans are coarse. Check focus "
                   "and shutter speed, and reshoot this side.",
                   edge);
}

Message coverWarning(batch::Side side, const std::vector<int>& covered, std::size_t markers) {
  std::string ids;
  for (const int id : covered) ids += (ids.empty() ? "" : ", ") + std::to_string(id);
  return side == batch::Side::Front
             ? message(
                   "%1 of the plate's %2 markers are not visible in any photograph of the front "
                   "side (%3); the camera poses depend on the others, so uncover these.",
                   covered.size(), markers, ids)
             : message(
                   "%1 of the plate's %2 markers are not visible in any photograph of the back "
                   "side (%3); the camera poses depend on the others, so uncover these.",
                   covered.size(), markers, ids);
}

}  // namespace

Result<PhotoFindings> checkPhotographs(std::span<const rig::PosedImage> images,
                                       const batch::Plate& plate, const PhotoCheckOptions& options,
                                       std::stop_token stop) {
  std::vector<std::optional<Result<Look>>> looks(images.size());
  parallelFor(images.size(), options.threads, [&](std::size_t i) {
    if (!stop.stop_requested()) looks[i] = lookAt(images[i], plate, options);
  });
  if (stop.stop_requested()) return Error::cancelled();
  for (const auto& look : looks)
    if (!*look) return look->error();

  // By camera; its focus is the same on both sides. By hand, pictures of another size are another
  // camera's, or another lens's, and as sharp as they can be at another width.
  std::map<int, double> sharpest;
  const auto cameraOf = [&](std::size_t i) {
    const rig::Intrinsics& lens = images[i].intrinsics;
    return options.one_camera ? lens.width * lens.height : images[i].camera;
  };
  std::map<batch::Side, std::set<int>> seen;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Look& look = **looks[i];
    seen[images[i].side].insert(look.seen.begin(), look.seen.end());
    double& best = sharpest[cameraOf(i)];
    if (look.edge_px > 0) best = best > 0 ? std::min(best, look.edge_px) : look.edge_px;
  }
  std::vector<std::size_t> blurred;
  std::map<batch::Side, double> shares;  // of the side's photographs that are blurred
  for (std::size_t i = 0; i < images.size(); ++i) {
    const double width = (*looks[i])->edge_px, best = sharpest[cameraOf(i)];
    if (width <= options.most_edge_growth * best || width <= best + options.wide_edge_px) continue;
    blurred.push_back(i);
    shares[images[i].side] += 1;
  }
  for (auto& [side, share] : shares)
    share /= static_cast<double>(std::ranges::count_if(
        images, [&, of = side](const rig::PosedImage& image) { return image.side == of; }));
  PhotoFindings findings;
  std::map<batch::Side, double> sharpest_used;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const rig::Intrinsics& whole = images[i].intrinsics;
    const double used =
        (*looks[i])->edge_px * rig::reducedTo(whole, options.megapixels).width / whole.width;
    double& best = sharpest_used[images[i].side];
    if (used > 0) best = best > 0 ? std::min(best, used) : used;
  }
  for (const auto& [side, edge_px] : sharpest_used)
    if (edge_px > options.widest_sharp_px)
      findings.warnings.push_back(allBlurredWarning(side, edge_px));
  for (const std::size_t i : blurred) {
    const bool left_out = shares[images[i].side] <= options.most_left_out;
    findings.warnings.push_back(
        blurWarning(images[i].file, (*looks[i])->edge_px, sharpest[cameraOf(i)], left_out));
    if (left_out) findings.spoilt.push_back(i);
  }
  for (const auto& [side, ids] : seen) {
    std::vector<int> covered;
    for (const batch::Marker& marker : plate.markers)
      if (!ids.contains(marker.id)) covered.push_back(marker.id);
    const auto markers = static_cast<double>(plate.markers.size());
    if (static_cast<double>(covered.size()) > options.most_covered * markers)
      findings.warnings.push_back(coverWarning(side, covered, plate.markers.size()));
  }
  return findings;
}

}  // namespace ostraka::checks
