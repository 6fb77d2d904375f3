#include "stereo/stereo.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "base/limits.h"
#include "base/message.h"
#include "base/parallel.h"
#include "base/part_progress.h"
#include "stereo/frame.h"
#include "stereo/fusion.h"
#include "stereo/hull.h"
#include "stereo/patch_match.h"
#include "stereo/same_light.h"
#include "stereo/surface.h"
#include "stereo/tiles.h"

namespace ostraka::stereo {
namespace {

// Right cameras cover 0.96 to 0.99 of the masks of demo, light and hand; photographs under each
// other's cameras 0.015 at most there, and 0.10 of a ball whose masks are the same from all sides
// (0.3 megapixels, docs/experiments.md). In between nothing was seen.
constexpr double kLeastCoveredShare = 0.3;
constexpr int kLevels = 3;  // down to about 1 mm per pixel, where a wall is still a few pixels
// Seconds per view of the levels behave as 8 : 3 : 1, those of the surface as 3.
constexpr std::array<std::int64_t, kLevels> kEffort{8, 3, 1};
constexpr std::int64_t kSurfaceEffort = 3, kAllEffort = 8 + 3 + 1 + kSurfaceEffort;

Result<void> checkViews(std::span<const View> views) {
  if (views.size() < 3)
    return Error{ErrorCode::NotEnough,
                 message("Stereo needs at least 3 photographs with known cameras."),
                 {}};
  for (const View& v : views) {
    const rig::Intrinsics& camera = v.camera.intrinsics;
    if (std::min(camera.width, camera.height) < limits::kLeastPhotographSide)
      return Error{ErrorCode::UnusableInput,
                   message("The photograph is less than %1 pixels wide or high; use the original "
                           "photograph.",
                           limits::kLeastPhotographSide),
                   v.camera.file};
    if (!v.mask.empty() && v.mask.size() != cv::Size(camera.width, camera.height))
      return Error{ErrorCode::UnusableInput, message("The mask and its photograph differ in size."),
                   v.camera.file};
  }
  return {};
}

Result<cv::Mat> photographOf(std::span<const View> views, const ReadPhotograph& read,
                             std::size_t view) {
  Result<cv::Mat> photograph = read(view);
  if (!photograph) return photograph;
  const rig::Intrinsics& camera = views[view].camera.intrinsics;
  if (photograph->type() != CV_8UC3 || photograph->size() != cv::Size(camera.width, camera.height))
    return Error{
        ErrorCode::UnusableInput,
        message("The photograph differs in size from the images that its camera was calibrated "
                "with; use the original photograph."),
        views[view].camera.file};
  return photograph;
}

/// work(view, its photograph), for each of these views. A whole photograph takes up to a second to
/// read: a stop is looked for before each.
template <typename Work>
Result<void> withPhotographs(std::span<const View> views, const ReadPhotograph& read,
                             const std::vector<std::size_t>& of, const DenseOptions& options,
                             const std::stop_token& stop, const Work& work) {
  std::vector<std::optional<Error>> errors(of.size());
  parallelFor(of.size(), options.readers > 0 ? options.readers : options.threads,
              [&](std::size_t i) {
                if (stop.stop_requested()) return;
                const Result<cv::Mat> photograph = photographOf(views, read, of[i]);
                if (photograph)
                  work(i, *photograph);
                else
                  errors[i] = photograph.error();
              });
  if (stop.stop_requested()) return Error::cancelled();
  for (const std::optional<Error>& error : errors)
    if (error) return *error;
  return {};
}

/// One tile, matched in the views that show it.
struct Matching {
  std::span<const View> views;
  const Hull& hull;
  const Tile& tile;
  const DenseOptions& options;
  Progress& progress;
  std::stop_token stop;
  std::vector<std::size_t> of = {};  // places among the views; all below are in this order
  std::vector<std::vector<Frame>> pyramids = {};
  std::vector<std::vector<DepthRange>> ranges = {};  // per view, at the coarsest level, row by row
  std::vector<std::vector<Link>> links = {};
  std::vector<PlaneMap> planes = {};

  std::vector<const Frame*> framesAt(int level) const {
    std::vector<const Frame*> frames;
    for (const auto& p : pyramids) frames.push_back(&p[static_cast<std::size_t>(level)]);
    return frames;
  }
  Result<void> prepare(const ReadPhotograph& read);
  std::vector<DepthRange> listPixels(std::size_t view, int level);
  void matchView(std::size_t view, int level);
  Result<void> match(int level);
  std::vector<SurfacePoint> surface(Agreement& agreement) const;
};

Result<void> Matching::prepare(const ReadPhotograph& read) {
  for (std::size_t i = 0; i < views.size(); ++i)
    if (!tile.parts[i].empty()) of.push_back(i);
  pyramids.resize(of.size());
  const Result<void> built = withPhotographs(
      views, read, of, options, stop, [&](std::size_t i, const cv::Mat& photograph) {
        pyramids[i] = buildPyramid(views[of[i]], photograph, tile.parts[of[i]], kLevels);
      });
  if (!built) return built;
  const std::vector<const Frame*> coarse = framesAt(kLevels - 1);
  ranges.resize(of.size());
  parallelFor(of.size(), options.threads,
              [&](std::size_t i) { ranges[i] = depthRanges(hull, *coarse[i], tile.reach); });
  links = chooseSources(coarse, tile.middle, options);
  planes.resize(of.size());
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
  sweep.seed = options.seed + 1000 * static_cast<std::uint64_t>(level) + of[i];
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
  std::int64_t before = 0;
  for (int l = level + 1; l < kLevels; ++l) before += kEffort[static_cast<std::size_t>(l)];
  const auto count = static_cast<std::int64_t>(of.size());
  const std::size_t batch = 2 * static_cast<std::size_t>(std::max(
                                    1, options.threads > 0 ? options.threads : availableThreads()));
  for (std::size_t first = 0; first < of.size(); first += batch) {
    parallelFor(std::min(batch, of.size() - first), options.threads, [&](std::size_t i) {
      if (!stop.stop_requested()) matchView(first + i, level);
    });
    if (stop.stop_requested()) return Error::cancelled();
    const auto done = static_cast<std::int64_t>(std::min(first + batch, of.size()));
    progress.report(before * count + kEffort[static_cast<std::size_t>(level)] * done,
                    kAllEffort * count);
  }
  return {};
}

/// The points that the tile owns; `view` is the place among all views.
std::vector<SurfacePoint> Matching::surface(Agreement& agreement) const {
  std::int64_t left = kSurfaceEffort;
  const auto step = [&] { progress.report(kAllEffort - --left, kAllEffort); };
  const std::vector<const Frame*> frames = framesAt(0);
  FusionOptions fusion;
  fusion.threads = options.threads;
  fusion.min_agreeing_views = options.min_agreeing_views;
  fusion.tile = &tile;
  std::vector<SurfacePoint> points = fusePlanes(frames, planes, fusion, agreement);
  step();
  SlantOptions slant;
  slant.threads = options.threads;
  points = withoutSlant(std::move(points), slant);
  SurfaceOptions smoothing;
  smoothing.threads = options.threads;
  points = insideMasks(frames, points, smoothing);
  points = smoothed(points, smoothing);
  step();
  SameLightOptions same_light;
  same_light.threads = options.threads;
  points = settledInSameLight(frames, planes, std::move(points), same_light);
  step();
  std::erase_if(points, [&](const SurfacePoint& point) { return !tile.owns(point.position); });
  for (SurfacePoint& point : points)
    point.view = static_cast<int>(of[static_cast<std::size_t>(point.view)]);
  return points;
}

Result<PointCloud> coloured(std::span<const View> views, const ReadPhotograph& read,
                            const std::vector<SurfacePoint>& points, const DenseOptions& options,
                            const std::stop_token& stop) {
  PointCloud cloud;
  std::vector<std::vector<std::size_t>> seen(views.size());  // the points of each view
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.points.push_back(points[i].position);
    cloud.normals.push_back(points[i].normal);
    cloud.quality.push_back(points[i].confidence);
    seen[static_cast<std::size_t>(points[i].view)].push_back(i);
  }
  cloud.colors.resize(points.size());
  std::vector<std::size_t> of;
  for (std::size_t view = 0; view < views.size(); ++view)
    if (!seen[view].empty()) of.push_back(view);
  const Result<void> done = withPhotographs(
      views, read, of, options, stop, [&](std::size_t k, const cv::Mat& photograph) {
        for (const std::size_t i : seen[of[k]]) {
          const Eigen::Vector2d pixel =
              views[of[k]].camera.project(points[i].position.cast<double>());
          const int x =
              std::clamp(static_cast<int>(std::lround(pixel.x())), 0, photograph.cols - 1);
          const int y =
              std::clamp(static_cast<int>(std::lround(pixel.y())), 0, photograph.rows - 1);
          const auto bgr = photograph.at<cv::Vec3b>(y, x);
          cloud.colors[i] = {bgr[2], bgr[1], bgr[0]};
        }
      });
  if (!done) return done.error();
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

Result<Reconstruction> reconstruct(std::span<const View> views, const ReadPhotograph& read,
                                   const DenseOptions& options, Progress& progress,
                                   std::stop_token stop) {
  if (Result<void> fine = options.check(); !fine) return fine.error();
  if (Result<void> fine = checkViews(views); !fine) return fine.error();
  const auto start = std::chrono::steady_clock::now();
  const auto tell = [&](const std::string& what) {
    const std::chrono::duration<double> s = std::chrono::steady_clock::now() - start;
    char text[160];
    std::snprintf(text, sizeof text, "stereo: %s after %.1f s", what.c_str(), s.count());
    progress.note(NoteLevel::Info, text);
  };
  Agreement agreement;
  std::vector<Outline> outlines(views.size());
  parallelFor(views.size(), options.readers > 0 ? options.readers : options.threads,
              [&](std::size_t i) { outlines[i] = outlineOf(views[i], kLevels); });
  std::vector<const Frame*> coarse;
  std::vector<cv::Rect> wholes;
  for (std::size_t i = 0; i < views.size(); ++i) {
    agreement.shown += outlines[i].shown;
    coarse.push_back(&outlines[i].frame);
    wholes.push_back(outlines[i].whole);
  }
  if (stop.stop_requested()) return Error::cancelled();
  const Result<Hull> hull = carveHull(coarse, options, options.threads);
  if (!hull) return hull.error();
  const std::vector<Tile> tiles =
      tilesOf(*hull, coarse, 1 << (kLevels - 1), wholes, options.memory_mb * 1e6 / kBytesAPixel);
  tell("visual hull carved, in " + std::to_string(tiles.size()) +
       (tiles.size() == 1 ? " part," : " parts,"));
  std::vector<SurfacePoint> points;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    PartProgress part(progress, t, tiles.size());
    Matching work{views, *hull, tiles[t], options, part, stop};
    if (Result<void> fine = work.prepare(read); !fine) return fine.error();
    if (work.of.size() < 3) continue;
    for (int level = kLevels - 1; level >= 0; --level)
      if (Result<void> fine = work.match(level); !fine) return fine.error();
    Agreement own;
    const std::vector<SurfacePoint> found = work.surface(own);
    points.insert(points.end(), found.begin(), found.end());
    agreement.matched += own.matched;
    agreement.confirmed += own.confirmed;
    tell(std::to_string(points.size()) + " points on the smoothed surface");
  }
  if (points.empty())
    return Error{ErrorCode::NotEnough,
                 message("No two views agree on any surface point; check cameras and masks."),
                 {}};
  Result<PointCloud> cloud = coloured(views, read, points, options, stop);
  if (!cloud) return cloud.error();
  return Reconstruction{std::move(*cloud), agreement};
}

Result<Reconstruction> reconstruct(std::span<const View> views, const DenseOptions& options,
                                   Progress& progress, std::stop_token stop) {
  const auto held = [&](std::size_t view) -> Result<cv::Mat> { return views[view].photograph; };
  return reconstruct(views, held, options, progress, std::move(stop));
}

}  // namespace ostraka::stereo
