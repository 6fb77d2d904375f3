#include "registration/strip.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"
#include "base/message.h"
#include "registration/fracture_colour.h"

namespace ostraka::registration {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr float kSameFace = 0.5f;    // normals within 60 degrees: 9 degrees of noise, 26 on strips
constexpr float kSmoothFace = 0.8f;  // of the shell: a broken edge must not round the face
constexpr double kUsefulSpacingMm =
    0.25;                               // noise is alike over 0.9 mm: finer points only cost time
constexpr double kPixelMm = 0.25;       // photographs show no finer detail
constexpr float kLowBandMm = 0.7f;      // above the plate, where scans are fat and noisy
constexpr float kLowBandWeight = 0.4f;  // noise there is up to 1.5 times as large: 1 / 1.5^2

// The face around a point: mean normal, mean position, how far the mean lies aside.
struct Patch {
  Vector3f normal = Vector3f::Zero(), mean = Vector3f::Zero();
  float aside = 0;  // distance of the mean within the plane, as a share of the radius
  Vector3f towards = Vector3f::Zero();  // the same as a vector
  int count = 0;
};

Patch patchAround(const PointCloud& cloud, const KdTree& tree, int i, float radius, float min_cos,
                  std::vector<Neighbour>& found) {
  Patch patch;
  const Vector3f& p = cloud.points[i];
  tree.within(p, radius, found);
  for (const Neighbour& n : found) {
    if (cloud.normals[n.index].dot(cloud.normals[i]) < min_cos) continue;
    patch.normal += cloud.normals[n.index];
    patch.mean += cloud.points[n.index];
    ++patch.count;
  }
  patch.normal.normalize();
  patch.mean /= static_cast<float>(std::max(1, patch.count));
  const Vector3f offset = patch.mean - p;
  patch.towards = (offset - patch.normal * patch.normal.dot(offset)) / radius;
  patch.aside = patch.towards.norm();
  return patch;
}

Vector3d viewerDirection(const scan::Scan& scan) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3f& n : scan.cloud.normals) mean += n.cast<double>();
  mean.normalize();
  // A scanner's own frame has its viewer anywhere; then the scan's normals know better.
  return scan.up.dot(mean) < 0.5 ? mean : scan.up.normalized();
}

// One point per cube, the first met, with the mean colour of all; keeps normals and weights as they
// are. colours: as long as the points, or empty.
StripLevel thinnedLevel(const StripLevel& fine, const std::vector<Color>& colours, double edge_mm) {
  PointCloud cloud;
  cloud.points = fine.points;
  std::vector<int> kept;
  std::vector<std::array<int, 4>> cells;
  for (int i = 0; i < static_cast<int>(cloud.size()); ++i) {
    const Vector3f c = cloud.points[i] / static_cast<float>(edge_mm);
    cells.push_back({static_cast<int>(std::floor(c.x())), static_cast<int>(std::floor(c.y())),
                     static_cast<int>(std::floor(c.z())), i});
  }
  std::sort(cells.begin(), cells.end());
  for (std::size_t k = 0; k < cells.size(); ++k)
    if (k == 0 || !std::equal(cells[k].begin(), cells[k].begin() + 3, cells[k - 1].begin()))
      kept.push_back(cells[k][3]);
  StripLevel level;
  for (int i : kept) {
    level.points.push_back(fine.points[i]);
    level.normals.push_back(fine.normals[i]);
    level.weights.push_back(fine.weights[i]);
  }
  level.tree = KdTree(level.points);
  std::vector<std::array<double, 3>> sums;
  std::vector<double> counts;
  for (std::size_t k = 0; k < cells.size() && !colours.empty(); ++k) {
    if (k == 0 || !std::equal(cells[k].begin(), cells[k].begin() + 3, cells[k - 1].begin())) {
      sums.push_back({});
      counts.push_back(0);
    }
    const Color& colour = colours[static_cast<std::size_t>(cells[k][3])];
    for (std::size_t c = 0; c < 3; ++c) sums.back()[c] += colour[c];
    ++counts.back();
  }
  std::vector<Color> means(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      means[i][c] = static_cast<std::uint8_t>(std::lround(sums[i][c] / counts[i]));
  level.colours = colourDetail(level.points, level.normals, means, level.tree, 0.75 * edge_mm);
  return level;
}

void addShell(const PointCloud& cloud, const KdTree& tree, double edge_mm, Strip& strip) {
  const PointCloud thin = thinned(cloud, edge_mm);
  std::vector<Neighbour> found;
  for (std::size_t k = 0; k < thin.size(); ++k) {
    const int i = tree.nearest(thin.points[k]).index;
    const Patch patch =
        patchAround(cloud, tree, i, static_cast<float>(edge_mm), kSmoothFace, found);
    if (patch.count < 4) continue;  // flying points stand alone
    const Vector3f& p = cloud.points[i];
    strip.shell.push_back(p + patch.normal * patch.normal.dot(patch.mean - p));
    strip.shell_normals.push_back(patch.normal);
    // All around is face when nearly every neighbour belongs to it and they surround the point.
    const bool whole = patch.count >= 0.95 * static_cast<double>(found.size());
    strip.shell_inside.push_back(whole && patch.aside < 0.2f ? 1 : 0);
  }
  for (const Vector3f& p : strip.shell) strip.centre += p.cast<double>();
  strip.centre /= std::max<double>(1.0, static_cast<double>(strip.shell.size()));
  double sum = 0;
  for (const Vector3f& p : strip.shell) sum += (p.cast<double>() - strip.centre).squaredNorm();
  strip.radius_mm = std::sqrt(sum / std::max<double>(1.0, static_cast<double>(strip.shell.size())));
}

std::vector<Vector3f> scaledPoints(const std::vector<Vector3f>& points, double factor) {
  std::vector<Vector3f> sized = points;
  for (Vector3f& p : sized) p *= static_cast<float>(factor);
  return sized;
}

StripLevel scaledLevel(const StripLevel& level, double factor) {
  StripLevel sized;
  sized.points = scaledPoints(level.points, factor);
  sized.normals = level.normals;
  sized.weights = level.weights;
  sized.colours = level.colours;
  for (ColourDetail& colour : sized.colours) colour.slope /= static_cast<float>(factor);
  sized.tree = KdTree(sized.points);
  return sized;
}

}  // namespace

Strip scaled(const Strip& strip, double factor) {
  Strip sized;
  sized.coarse = scaledLevel(strip.coarse, factor);
  sized.fine = scaledLevel(strip.fine, factor);
  sized.boundary = scaledPoints(strip.boundary, factor);
  sized.all = scaledPoints(strip.all, factor);
  sized.shell = scaledPoints(strip.shell, factor);
  sized.shell_normals = strip.shell_normals;
  sized.shell_inside = strip.shell_inside;
  sized.up = strip.up;
  sized.centre = factor * strip.centre;
  sized.radius_mm = factor * strip.radius_mm;
  sized.noise_mm = factor * strip.noise_mm;
  sized.spacing_mm = factor * strip.spacing_mm;
  return sized;
}

const std::map<std::string, Boundary>& boundariesByName() {
  static const std::map<std::string, Boundary> kBoundaries = {{"strip", Boundary::Strip},
                                                              {"paper", Boundary::Paper}};
  return kBoundaries;
}

Result<Strip> prepareStrip(const scan::Scan& scan, const StripOptions& options,
                           std::span<const SilhouetteView> views) {
  if (!scan.cloud.hasNormals())
    return Error::notEnough(message("The scan has no normals; export it with normals."), scan.id);
  const bool dense = medianSpacing(scan.cloud) < 0.7 * kUsefulSpacingMm;
  const PointCloud cloud = dense ? thinned(scan.cloud, kUsefulSpacingMm) : scan.cloud;
  Strip strip;
  strip.up = viewerDirection(scan);
  const Vector3f up = strip.up.cast<float>();
  const KdTree tree(cloud.points);
  strip.all = cloud.points;
  strip.spacing_mm = medianSpacing(cloud);
  std::vector<float> heights;
  for (const Vector3f& p : cloud.points) heights.push_back(p.dot(up));
  std::vector<float> sorted = heights;
  const auto lowest = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 200);
  std::nth_element(sorted.begin(), lowest, sorted.end());
  const float low_end = *lowest + kLowBandMm;
  std::vector<Neighbour> found;
  std::vector<double> offsets;
  std::vector<Color> colours;
  const float radius =
      static_cast<float>(std::max(options.normal_radius_mm, 2.2 * strip.spacing_mm));
  for (int i = 0; i < static_cast<int>(cloud.size()); ++i) {
    if (cloud.normals[i].dot(up) > 0.97f) continue;  // surely face: saves the search
    const Patch patch = patchAround(cloud, tree, i, radius, kSameFace, found);
    if (patch.count < 4 || patch.normal.dot(up) > options.max_up) continue;
    strip.fine.points.push_back(cloud.points[i]);
    strip.fine.normals.push_back(patch.normal);
    if (!cloud.colors.empty()) colours.push_back(cloud.colors[static_cast<std::size_t>(i)]);
    strip.fine.weights.push_back(heights[i] < low_end ? kLowBandWeight : 1.0f);
    if (options.boundary == Boundary::Strip && patch.towards.dot(up) > 0.25f)
      strip.boundary.push_back(cloud.points[i]);
    offsets.push_back(std::abs(patch.normal.dot(cloud.points[i] - patch.mean)));
  }
  if (strip.fine.points.size() < 50)
    return Error::notEnough(
        message(
            "Fewer than 50 points are on the fracture; rescan the sherd including its fracture."),
        scan.id);
  if (options.boundary == Boundary::Paper) {
    const std::vector<std::uint8_t> boundary = scan::findBoundary(cloud, views, {});
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (boundary[i] != 0) strip.boundary.push_back(cloud.points[i]);
  }
  strip.noise_mm = 1.4826 * medianOf(offsets);
  strip.fine.tree = KdTree(strip.fine.points);
  strip.fine.colours = colourDetail(strip.fine.points, strip.fine.normals, colours, strip.fine.tree,
                                    std::max(kPixelMm, 1.25 * strip.spacing_mm));
  strip.coarse = thinnedLevel(strip.fine, colours, options.coarse_mm);
  addShell(cloud, tree, 1.0, strip);
  return strip;
}

}  // namespace ostraka::registration
