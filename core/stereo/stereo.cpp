#include "stereo/stereo.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/limits.h"
#include "base/message.h"
#include "base/parallel.h"
#include "stereo/frame.h"
#include "stereo/fusion.h"
#include "stereo/hull.h"
#include "stereo/patch_match.h"
#include "stereo/same_light.h"
#include "stereo/slant.h"
#include "stereo/surface.h"

namespace ostraka::stereo {
namespace {

// Right cameras cover 0.96 to 0.99 of the masks of demo, light and hand; photographs under each
// other's cameras 0.015 at most there, and 0.10 of a ball whose masks are the same from all sides
// (0.3 megapixels, docs/experiments.md). In between nothing was seen.
constexpr double kLeastCoveredShare = 0.3;
constexpr int kLevels = 3;  // down to about 1 mm per pixel, where a wall is still a few pixels

struct Matching {
  std::span<const View> views;
  const DenseOptions& options;
  Progress& progress;
  std::stop_token stop;
  std::vector<std::vector<Frame>> pyramids = {};
  std::vector<std::vector<DepthRange>> ranges = {};  // per view, at the coarsest level, row by row
  std::vector<std::vector<Link>> links = {};
  std::vector<PlaneMap> planes = {};

  std::vector<const Frame*> framesAt(int level) const {
    std::vector<const Frame*> frames;
    for (const auto& p : pyramids) frames.push_back(&p[static_cast<std::size_t>(level)]);
    return frames;
  }
  Result<void> check() const;
  Result<void> prepare();
  std::vector<DepthRange> listPixels(std::size_t view, int level);
  void matchView(std::size_t view, int level);
  Result<void> match(int level);
  PointCloud coloured(const std::vector<SurfacePoint>& points) const;
};

Result<void> Matching::check() const {
  if (views.size() < 3)
    return Error{ErrorCode::NotEnough,
                 message("Stereo needs at least 3 photographs with known cameras."),
                 {}};
  for (const View& v : views) {
    if (v.photograph.empty() || v.photograph.type() != CV_8UC3 ||
        v.photograph.cols != v.camera.intrinsics.width ||
        v.photograph.rows != v.camera.intrinsics.height)
      return Error{
          ErrorCode::UnusableInput,
          message("The photograph differs in size from the images that its camera was calibrated "
                  "with; use the original photograph."),
          v.camera.file};
    if (std::min(v.photograph.cols, v.photograph.rows) < limits::kLeastPhotographSide)
      return Error{ErrorCode::UnusableInput,
                   message("The photograph is less than %1 pixels wide or high; use the original "
                           "photograph.",
                           limits::kLeastPhotographSide),
                   v.camera.file};
    if (!v.mask.empty() && v.mask.size() != v.photograph.size())
      return Error{ErrorCode::UnusableInput, message("The mask and its photograph differ in size."),
                   v.camera.file};
  }
  return {};
}

Result<void> Matching::prepare() {
  pyramids.resize(views.size());
  parallelFor(views.size(), options.threads,
              [&](std::size_t i) { pyramids[i] = buildPyramid(views[i], kLevels); });
  if (stop.stop_requested()) return Error::cancelled();
  const std::vector<const Frame*> coarse = framesAt(kLevels - 1);
  Result<Hull> hull = carveHull(coarse, options, options.threads);
  if (!hull) return hull.error();
  ranges.resize(views.size());
  parallelFor(views.size(), options.threads,
              [&](std::size_t i) { ranges[i] = depthRanges(*hull, *coarse[i]); });
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float count = 0;
  for (std::size_t i = 0, c = 0; c < hull->inside.size(); ++c, ++i)
    if (hull->inside[c] != 0) {
      const auto x = static_cast<std::size_t>(hull->size.x()),
                 y = static_cast<std::size_t>(hull->size.y());
      sum += Eigen::Vector3f(static_cast<float>(c % x), static_cast<float>(c / x % y),
                             static_cast<float>(c / (x * y)));
      count += 1;
    }
  links = chooseSources(coarse, hull->origin + hull->edge_mm / count * sum, options);
  planes.resize(views.size());
  return {};
}

/// Fills the frame's list of pixels: inside the mask and with the hull on their ray.
std::vector<DepthRange> Matching::listPixels(std::size_t view, int level) {
  Frame& frame = pyramids[view][static_cast<std::size_t>(level)];
  const Frame& coarse = pyramids[view].back();
  const int shift = kLevels - 1 - level;
  const float margin = level == kLevels - 1 ? 0.0F : 0.5F;
  std::vector<DepthRange> list;
  frame.index = cv::Mat1i(frame.height, frame.width, -1);
  for (int y = 1; y + 1 < frame.height; ++y)
    for (int x = 1; x + 1 < frame.width; ++x) {
      if (frame.coverage(y, x) < 0.5F) continue;
      const int u = std::min(x >> shift, coarse.width - 1),
                v = std::min(y >> shift, coarse.height - 1);
      const DepthRange range = ranges[view][static_cast<std::size_t>(v * coarse.width + u)];
      if (range.far <= 0) continue;
      frame.index(y, x) = static_cast<int>(frame.pixels.size());
      frame.pixels.emplace_back(x, y);
      list.push_back({range.near - margin, range.far + margin});
    }
  return list;
}

void Matching::matchView(std::size_t i, int level) {
  const std::vector<DepthRange> list = listPixels(i, level);
  PropagationOptions sweep;
  sweep.seed = options.seed + 1000 * static_cast<std::uint64_t>(level) + i;
  const auto place = static_cast<std::size_t>(level);
  const Frame& frame = pyramids[i][place];
  if (level == kLevels - 1) {
    startPlanes(frame, list, sweep.seed, planes[i]);
    sweep.rounds = 5;
    sweep.first_perturbation = 2;
  } else {
    PlaneMap finer;
    refinePlanes(pyramids[i][place + 1], planes[i], frame, finer);
    planes[i] = std::move(finer);
    sweep.rounds = level == 0 ? 2 : 3;
    sweep.first_perturbation = 0.5F;
    if (level == 0) sweep.max_active_sources = options.max_sources_per_pixel;
  }
  propagate(framesAt(level), static_cast<int>(i), links[i], list, sweep, planes[i], stop);
}

Result<void> Matching::match(int level) {
  // Seconds per view of the levels behave as 8 : 3 : 1.
  constexpr std::array<std::int64_t, kLevels> effort{8, 3, 1};
  std::int64_t before = 0, total = 0;
  for (int l = 0; l < kLevels; ++l) {
    total += effort[static_cast<std::size_t>(l)];
    if (l > level) before += effort[static_cast<std::size_t>(l)];
  }
  const auto count = static_cast<std::int64_t>(views.size());
  const std::size_t batch = 2 * static_cast<std::size_t>(std::max(
                                    1, options.threads > 0 ? options.threads : availableThreads()));
  for (std::size_t first = 0; first < views.size(); first += batch) {
    parallelFor(std::min(batch, views.size() - first), options.threads, [&](std::size_t i) {
      if (!stop.stop_requested()) matchView(first + i, level);
    });
    if (stop.stop_requested()) return Error::cancelled();
    const auto done = static_cast<std::int64_t>(std::min(first + batch, views.size()));
    progress.report(before * count + effort[static_cast<std::size_t>(level)] * done, total * count);
  }
  return {};
}

PointCloud Matching::coloured(const std::vector<SurfacePoint>& points) const {
  PointCloud cloud;
  for (const SurfacePoint& point : points) {
    const View& view = views[static_cast<std::size_t>(point.view)];
    const Eigen::Vector2d pixel = view.camera.project(point.position.cast<double>());
    const int x = std::clamp(static_cast<int>(std::lround(pixel.x())), 0, view.photograph.cols - 1);
    const int y = std::clamp(static_cast<int>(std::lround(pixel.y())), 0, view.photograph.rows - 1);
    const auto bgr = view.photograph.at<cv::Vec3b>(y, x);
    cloud.points.push_back(point.position);
    cloud.normals.push_back(point.normal);
    cloud.colors.push_back({bgr[2], bgr[1], bgr[0]});
    cloud.quality.push_back(point.confidence);
  }
  return cloud;
}

double share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

double Agreement::confirmedShare() const {
  return share(confirmed, matched);
}

double Agreement::coveredShare() const {
  return share(confirmed, shown);
}

bool Agreement::plausible() const {
  return coveredShare() >= kLeastCoveredShare;
}

Result<void> DenseOptions::check() const {
  if (max_sources < 1 || max_sources > 16)
    return Error{ErrorCode::UnusableInput, "max_sources must be 1 to 16.", {}};
  if (min_agreeing_views < 1)
    return Error{ErrorCode::UnusableInput, "min_agreeing_views must be at least 1.", {}};
  if (!(min_source_angle_rad >= 0 && min_source_angle_rad < max_source_angle_rad))
    return Error{ErrorCode::UnusableInput, "min_source_angle_rad must be below the maximum.", {}};
  return {};
}

Result<Reconstruction> reconstruct(std::span<const View> views, const DenseOptions& options,
                                   Progress& progress, std::stop_token stop) {
  if (Result<void> fine = options.check(); !fine) return fine.error();
  Matching work{views, options, progress, stop};
  if (Result<void> fine = work.check(); !fine) return fine.error();
  const auto start = std::chrono::steady_clock::now();
  const auto tell = [&](const std::string& what) {
    const std::chrono::duration<double> s = std::chrono::steady_clock::now() - start;
    char text[160];
    std::snprintf(text, sizeof text, "stereo: %s after %.1f s", what.c_str(), s.count());
    progress.note(NoteLevel::Info, text);
  };
  if (Result<void> fine = work.prepare(); !fine) return fine.error();
  tell("visual hull carved");
  for (int level = kLevels - 1; level >= 0; --level) {
    if (Result<void> fine = work.match(level); !fine) return fine.error();
    tell("level " + std::to_string(level) + " matched");
  }
  FusionOptions fusion;
  fusion.threads = options.threads;
  fusion.min_agreeing_views = options.min_agreeing_views;
  Agreement agreement;
  std::vector<SurfacePoint> points = fusePlanes(work.framesAt(0), work.planes, fusion, agreement);
  tell(std::to_string(points.size()) + " points fused");
  SlantOptions slant;
  slant.threads = options.threads;
  points = withoutSlant(std::move(points), slant);
  SurfaceOptions surface;
  surface.threads = options.threads;
  points = insideMasks(work.framesAt(0), points, surface);
  points = smoothed(points, surface);
  SameLightOptions same_light;
  same_light.threads = options.threads;
  points = settledInSameLight(work.framesAt(0), work.planes, std::move(points), same_light);
  tell(std::to_string(points.size()) + " points on the smoothed surface");
  if (points.empty())
    return Error{ErrorCode::NotEnough,
                 message("No two views agree on any surface point; check cameras and masks."),
                 {}};
  return Reconstruction{work.coloured(points), agreement};
}

}  // namespace ostraka::stereo
