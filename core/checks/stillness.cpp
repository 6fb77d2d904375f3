#include "checks/stillness.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <set>

#include "base/median.h"
#include "base/parallel.h"
#include "base/text.h"

namespace ostraka::checks {
namespace {

constexpr std::size_t kMostPoints = 4000;  // of a scan; its outline needs no more

// Where a sherd's patch lies against its scan on one photograph, in the plane of its middle height.
struct Offset {
  std::size_t image = 0;
  Eigen::Vector2d mm;
  Eigen::Vector2d towards_camera;  // unit, horizontal
};

std::vector<Eigen::Vector3d> thinned(const scan::Scan& scan) {
  const std::size_t step = std::max<std::size_t>(1, scan.cloud.size() / kMostPoints);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < scan.cloud.size(); i += step)
    points.push_back(scan.cloud.points[i].cast<double>());
  return points;
}

double middleHeight(const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> heights;
  for (const Eigen::Vector3d& point : points) heights.push_back(point.z());
  return medianOf(heights);
}

std::optional<Eigen::Vector2d> hullCentre(const std::vector<cv::Point2f>& pixels) {
  if (pixels.size() < 3) return {};
  std::vector<cv::Point2f> hull;
  cv::convexHull(pixels, hull);
  const cv::Moments m = cv::moments(hull);
  if (m.m00 < 50) return {};  // pixels: too small to have a middle
  return Eigen::Vector2d(m.m10 / m.m00, m.m01 / m.m00);
}

// The point of the plane z = height that a pixel shows.
Eigen::Vector2d onPlane(const rig::PosedImage& image, const Eigen::Vector2d& pixel, double height) {
  const Eigen::Vector2d ray = image.intrinsics.unproject(pixel);
  const Eigen::Isometry3d plate_from_camera = image.camera_from_plate.inverse();
  const Eigen::Vector3d direction =
      plate_from_camera.linear() * Eigen::Vector3d(ray.x(), ray.y(), 1);
  const Eigen::Vector3d centre = plate_from_camera.translation();
  return (centre + (height - centre.z()) / direction.z() * direction).head<2>();
}

// Pixels of the patches' rims, by patch; a patch that the picture's edge cuts has none.
std::vector<std::vector<cv::Point2f>> patchRims(const cv::Mat1i& patches, int count) {
  std::vector<std::vector<cv::Point2f>> rims(static_cast<std::size_t>(count));
  std::set<int> cut;
  for (int y = 0; y < patches.rows; ++y)
    for (int x = 0; x < patches.cols; ++x) {
      const int patch = patches(y, x);
      if (patch == 0) continue;
      const bool edge = x == 0 || y == 0 || x == patches.cols - 1 || y == patches.rows - 1;
      if (edge)
        cut.insert(patch);
      else if (patches(y, x - 1) != patch || patches(y, x + 1) != patch ||
               patches(y - 1, x) != patch || patches(y + 1, x) != patch)
        rims[static_cast<std::size_t>(patch)].emplace_back(static_cast<float>(x),
                                                           static_cast<float>(y));
    }
  for (const int patch : cut) rims[static_cast<std::size_t>(patch)].clear();
  return rims;
}

// One photograph: the offset of each scan whose patch is its own.
std::vector<std::optional<Offset>> offsetsOn(const rig::PosedImage& image, const cv::Mat1b& mask,
                                             const std::vector<std::vector<Eigen::Vector3d>>& scans,
                                             const std::vector<double>& heights,
                                             const StillnessOptions& options) {
  cv::Mat1i patches;
  const int count = cv::connectedComponents(mask >= 128, patches, 8, CV_32S);
  const auto rims = patchRims(patches, count);
  std::vector<std::vector<cv::Point2f>> pixels(scans.size());
  std::vector<std::map<int, int>> votes(scans.size());  // points on each patch
  std::map<int, int> all;
  for (std::size_t k = 0; k < scans.size(); ++k)
    for (const Eigen::Vector3d& point : scans[k]) {
      const Eigen::Vector2d p = image.project(point);
      pixels[k].emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
      const int x = static_cast<int>(std::lround(p.x())), y = static_cast<int>(std::lround(p.y()));
      if (x < 0 || y < 0 || x >= patches.cols || y >= patches.rows || patches(y, x) == 0) continue;
      ++votes[k][patches(y, x)];
      ++all[patches(y, x)];
    }
  std::vector<std::optional<Offset>> offsets(scans.size());
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const auto most =
        std::ranges::max_element(votes[k], {}, [](const auto& one) { return one.second; });
    if (most == votes[k].end() || most->second < options.own_share * all[most->first]) continue;
    const auto patch = hullCentre(rims[static_cast<std::size_t>(most->first)]);
    const auto scan = hullCentre(pixels[k]);
    if (!patch || !scan) continue;
    const Eigen::Vector2d place = onPlane(image, *scan, heights[k]);
    offsets[k] = Offset{0, onPlane(image, *patch, heights[k]) - place,
                        (image.centre().head<2>() - place).normalized()};
  }
  return offsets;
}

// offset = constant + per camera a share towards it and one across [+ a step from a stop on];
// returns the step, and the sum of squares that is left.
std::pair<Eigen::Vector2d, double> fitted(const std::vector<Offset>& offsets,
                                          std::span<const rig::PosedImage> images,
                                          const std::map<int, int>& columns,
                                          std::optional<int> from_stop) {
  const auto n = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(offsets.size()),
                                            2 + 2 * n + (from_stop ? 2 : 0));
  Eigen::VectorXd b(a.rows());
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const Offset& o = offsets[i];
    const rig::PosedImage& image = images[o.image];
    const auto row = static_cast<Eigen::Index>(2 * i);
    const Eigen::Index column = 2 + 2 * columns.at(image.camera);
    a.block<2, 2>(row, 0).setIdentity();
    a.block<2, 1>(row, column) = o.towards_camera;
    a.block<2, 1>(row, column + 1) = Eigen::Vector2d(-o.towards_camera.y(), o.towards_camera.x());
    if (from_stop && image.stop >= *from_stop) a.block<2, 2>(row, 2 + 2 * n).setIdentity();
    b.segment<2>(row) = o.mm;
  }
  const Eigen::VectorXd x = a.completeOrthogonalDecomposition().solve(b);
  const Eigen::Vector2d step = from_stop ? Eigen::Vector2d(x.tail<2>()) : Eigen::Vector2d::Zero();
  return {step, (a * x - b).squaredNorm()};
}

std::optional<MovedSherd> movedOf(const std::vector<Offset>& offsets,
                                  std::span<const rig::PosedImage> images,
                                  const StillnessOptions& options) {
  if (static_cast<int>(offsets.size()) < options.least_views) return {};
  std::map<int, int> columns;  // by camera
  std::set<int> stops;
  for (const Offset& o : offsets) {
    columns.emplace(images[o.image].camera, static_cast<int>(columns.size()));
    stops.insert(images[o.image].stop);
  }
  // Unknowns with a step must be fewer than half of what was measured.
  if (2 * (4 + 2 * columns.size()) > 2 * offsets.size()) return {};
  const double still = fitted(offsets, images, columns, {}).second;
  std::optional<MovedSherd> best;
  double least = still / options.least_gain;
  for (const int stop : stops) {
    const auto after = std::ranges::count_if(
        offsets, [&](const Offset& o) { return images[o.image].stop >= stop; });
    const auto before = static_cast<std::ptrdiff_t>(offsets.size()) - after;
    if (std::min(before, after) < options.least_beyond) continue;
    const auto [step, left] = fitted(offsets, images, columns, stop);
    if (left >= least || step.norm() < options.least_move_mm) continue;
    least = left;
    best = MovedSherd{{}, stop, step.norm()};
  }
  return best;
}

}  // namespace

std::vector<MovedSherd> findMoved(std::span<const rig::PosedImage> images,
                                  std::span<const cv::Mat1b> masks,
                                  std::span<const scan::Scan> scans,
                                  const StillnessOptions& options) {
  std::vector<std::vector<Eigen::Vector3d>> points;
  std::vector<double> heights;
  for (const scan::Scan& scan : scans) {
    points.push_back(thinned(scan));
    heights.push_back(middleHeight(points.back()));
  }
  std::vector<std::vector<std::optional<Offset>>> found(images.size());
  parallelFor(images.size(), options.threads, [&](std::size_t i) {
    found[i] = offsetsOn(images[i], masks[i], points, heights, options);
  });
  std::vector<MovedSherd> moved;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    std::vector<Offset> offsets;
    for (std::size_t i = 0; i < images.size(); ++i)
      if (found[i][k]) {
        offsets.push_back(*found[i][k]);
        offsets.back().image = i;
      }
    if (std::optional<MovedSherd> one = movedOf(offsets, images, options)) {
      one->scan = scans[k].id;
      moved.push_back(*one);
    }
  }
  return moved;
}

Message movedWarning(const MovedSherd& sherd, batch::Side side, const std::string& photograph) {
  const Decimal by = decimal(sherd.by_mm, 0);
  const bool front = side == batch::Side::Front;
  if (!photograph.empty())
    return front ? message(
                       "%1 moved by about %2 mm on the front side: from %3 on, it is in another "
                       "place; reshoot this side.",
                       sherd.scan, by, photograph)
                 : message(
                       "%1 moved by about %2 mm on the back side: from %3 on, it is in another "
                       "place; reshoot this side.",
                       sherd.scan, by, photograph);
  const std::string file = formatted("%02d", sherd.from_stop);
  return front ? message(
                     "%1 moved by about %2 mm on the front side: from position %3 on (pos%4), it "
                     "is in another place; reshoot this side.",
                     sherd.scan, by, sherd.from_stop + 1, file)
               : message(
                     "%1 moved by about %2 mm on the back side: from position %3 on (pos%4), it is "
                     "in another place; reshoot this side.",
                     sherd.scan, by, sherd.from_stop + 1, file);
}

}  // namespace ostraka::checks
