#include "stereo/outside_adapter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "base/message.h"
#include "base/parallel.h"
#include "cloud/ply.h"
#include "colmap/colmap_files.h"
#include "colmap/colmap_program.h"
#include "files/files.h"
#include "images/png_image.h"
#include "stereo/frame.h"
#include "stereo/hull.h"

namespace ostraka::stereo {
namespace {

namespace fs = std::filesystem;

constexpr int kOutsideLevels =
    3;  // of the pyramid; the hull is carved at its coarsest, as elsewhere
/// Points of the sparse model: neighbours and depths of a view are found from a few hundred.
constexpr std::size_t kSparsePoints = 6000;

Result<void> writePicture(const fs::path& file, const cv::Mat& picture) {
  return writeFileAtomically(file, images::encodedPng(picture, 1));
}

Result<void> check(std::span<const View> views) {
  if (views.size() < 3)
    return Error{ErrorCode::NotEnough,
                 message("Stereo needs at least 3 photographs with known cameras."),
                 {}};
  for (const View& v : views)
    if (v.photograph.type() != CV_8UC3 || v.photograph.cols != v.camera.intrinsics.width ||
        v.photograph.rows != v.camera.intrinsics.height ||
        (!v.mask.empty() && v.mask.size() != v.photograph.size()))
      return Error{
          ErrorCode::UnusableInput,
          message("The photograph or its mask differs in size from its camera's images; use "
                  "photographs of the size that the camera was calibrated with."),
          v.camera.file};
  return {};
}

// The view as a pinhole camera would have shown it; what the photograph does not show is outside.
Result<void> writeView(const View& view, const fs::path& folder, const std::string& name,
                       MaskStyle style) {
  const StraightPart straight(view.camera.intrinsics, wholeOf(view));
  cv::Mat photograph = straight.of(view.photograph, cv::INTER_LANCZOS4, cv::BORDER_REPLICATE);
  const cv::Mat1b all(view.photograph.size(), uchar{255});
  const cv::Mat1b mask =
      straight.of(view.mask.empty() ? all : view.mask, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  const cv::Mat1b inside = mask >= 128;
  if (style == MaskStyle::Colmap) {
    cv::Mat painted(photograph.size(), photograph.type(), cv::Scalar::all(0));
    photograph.copyTo(painted, inside);
    photograph = painted;
  }
  if (const Result<void> r = writePicture(folder / "images" / (name + ".png"), photograph); !r)
    return r;
  const char* ending = style == MaskStyle::Colmap ? ".png.png" : ".mask.png";
  return writePicture(folder / "masks" / (name + ending), inside);
}

// Cubes of the hull with a free side, thinned evenly.
std::vector<Eigen::Vector3f> surfaceOf(const Hull& hull) {
  const std::array<Eigen::Vector3f, 6> sides{Eigen::Vector3f::UnitX(),  Eigen::Vector3f::UnitY(),
                                             Eigen::Vector3f::UnitZ(),  -Eigen::Vector3f::UnitX(),
                                             -Eigen::Vector3f::UnitY(), -Eigen::Vector3f::UnitZ()};
  std::vector<Eigen::Vector3f> surface, thin;
  std::size_t c = 0;
  for (int z = 0; z < hull.size.z(); ++z)
    for (int y = 0; y < hull.size.y(); ++y)
      for (int x = 0; x < hull.size.x(); ++x, ++c) {
        if (hull.inside[c] == 0) continue;
        const Eigen::Vector3f p =
            hull.origin + hull.edge_mm * Eigen::Vector3i(x, y, z).cast<float>();
        if (std::any_of(sides.begin(), sides.end(), [&](const Eigen::Vector3f& side) {
              return !hull.at(p + hull.edge_mm * side);
            }))
          surface.push_back(p);
      }
  const std::size_t step = surface.size() / kSparsePoints + 1;
  for (std::size_t i = 0; i < surface.size(); i += step) thin.push_back(surface[i]);
  return thin;
}

// Adds the hull's surface to the model, each point with the views whose rays meet it first.
Result<void> addPoints(std::span<const View> views, const std::vector<rig::PosedImage>& cameras,
                       const DenseOptions& options, colmap::ColmapModel& model,
                       const std::stop_token& stop) {
  std::vector<Frame> frames(views.size());
  parallelFor(views.size(), options.threads, [&](std::size_t i) {
    frames[i] = std::move(buildPyramid(views[i], kOutsideLevels).back());
  });
  if (stop.stop_requested()) return Error::cancelled();
  std::vector<const Frame*> pointers;
  for (const Frame& frame : frames) pointers.push_back(&frame);
  const Result<Hull> hull = carveHull(pointers, options, options.threads);
  if (!hull) return hull.error();
  std::vector<std::vector<DepthRange>> ranges(views.size());
  parallelFor(views.size(), options.threads,
              [&](std::size_t i) { ranges[i] = depthRanges(*hull, frames[i]); });
  if (stop.stop_requested()) return Error::cancelled();
  for (const Eigen::Vector3f& p : surfaceOf(*hull)) {
    colmap::ColmapPoint point;
    point.id = model.points.size() + 1;
    point.position = p.cast<double>();
    point.colour = {128, 128, 128};
    std::vector<std::pair<std::size_t, Eigen::Vector2d>> seen;
    for (std::size_t i = 0; i < views.size(); ++i) {
      const Frame& frame = frames[i];
      const Eigen::Vector3f q = frame.toCamera(p);
      if (q.z() <= 0) continue;
      const Eigen::Vector2f pixel = frame.project(q);
      if (!frame.holds(pixel)) continue;
      const auto x = static_cast<int>(std::lround(pixel.x())),
                 y = static_cast<int>(std::lround(pixel.y()));
      const DepthRange range = ranges[i][static_cast<std::size_t>(y * frame.width + x)];
      if (range.far <= 0 || q.z() > range.near + 2 * hull->edge_mm) continue;
      seen.emplace_back(i, cameras[i].intrinsics.project(q.cast<double>()).array() + 0.5);
    }
    if (seen.size() < 2) continue;
    for (const auto& [i, pixel] : seen) {
      auto& observations = model.images[i].observations;
      point.track.push_back({model.images[i].id, static_cast<std::uint32_t>(observations.size())});
      observations.push_back({pixel, static_cast<std::int64_t>(point.id)});
    }
    model.points.push_back(std::move(point));
  }
  return {};
}

enum class Place { Beyond, Inside, Outside };

// A point beyond a view's picture is not seen by it; one on a mask's edge is inside.
Place placeOf(const View& view, const cv::Mat1b& wide_mask, const Eigen::Vector3d& p) {
  const Eigen::Vector3d q = view.camera.camera_from_plate * p;
  if (q.z() <= 0) return Place::Beyond;
  const Eigen::Vector2d pixel = view.camera.intrinsics.project(q);
  if (!(pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= view.photograph.cols - 1 &&
        pixel.y() <= view.photograph.rows - 1))
    return Place::Beyond;
  if (wide_mask.empty()) return Place::Inside;
  return wide_mask(static_cast<int>(std::lround(pixel.y())),
                   static_cast<int>(std::lround(pixel.x()))) < 128
             ? Place::Outside
             : Place::Inside;
}

}  // namespace

std::string viewName(std::size_t view) {
  const std::string digits = std::to_string(view);
  return std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
}

Result<FolderLock> writeOutsideFolder(std::span<const View> views, const DenseOptions& options,
                                      const fs::path& folder, MaskStyle style,
                                      std::stop_token stop) {
  if (const Result<void> good = check(views); !good) return good.error();
  if (const Result<void> good = options.check(); !good) return good.error();
  Result<FolderLock> held = colmap::claimWorkspace(folder);
  if (!held) return held;
  std::vector<rig::PosedImage> cameras;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < views.size(); ++i) {
    cameras.push_back(views[i].camera);
    rig::Intrinsics& pinhole = cameras.back().intrinsics;
    const cv::Rect whole = wholeOf(views[i]);
    pinhole = {whole.width,          whole.height,         pinhole.fx, pinhole.fy,
               pinhole.cx - whole.x, pinhole.cy - whole.y, {}};
    names.push_back(viewName(i) + ".png");
  }
  std::vector<std::optional<Error>> errors(views.size());
  parallelFor(views.size(), options.threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const Result<void> written = writeView(views[i], folder, viewName(i), style);
    if (!written) errors[i] = written.error();
  });
  if (stop.stop_requested()) return Error::cancelled();
  for (const std::optional<Error>& error : errors)
    if (error) return *error;
  colmap::ColmapModel model = colmap::toColmap(cameras, names);
  const Result<void> added = addPoints(views, cameras, options, model, stop);
  if (!added) return added.error();
  const Result<void> written = colmap::writeColmapModel(folder / "sparse", model);
  if (!written) return written.error();
  return held;
}

Result<PointCloud> readOutsideCloud(const fs::path& file, const std::string& program,
                                    const fs::path& log, std::span<const View> views,
                                    const DenseOptions& options) {
  const Error nothing{ErrorCode::NotEnough,
                      message("%1 found no points of the object; its output is in this file, and "
                              "--dense builtin needs no other program.",
                              program),
                      log.string()};
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return nothing;
  const Result<PlyContents> contents = readPly(file);
  if (!contents) return contents.error();
  PointCloud cloud;
  cloud.points = contents->mesh.vertices;
  cloud.normals = contents->mesh.normals;
  cloud.colors = contents->mesh.colors;
  if (cloud.empty()) return nothing;
  if (!cloud.hasNormals())
    return Error{
        ErrorCode::Failed,
        message("%1 wrote points without normals; install a newer version, or use --dense builtin.",
                program),
        file.string()};
  std::vector<cv::Mat1b> wide(views.size());
  parallelFor(views.size(), options.threads, [&](std::size_t i) {
    if (!views[i].mask.empty()) cv::dilate(views[i].mask, wide[i], cv::Mat());
  });
  const int most_outside = masksThatMayErr(views.size());  // as the built-in stereo cuts
  std::vector<std::uint8_t> keep(cloud.size(), 0);
  parallelFor(cloud.size(), options.threads, [&](std::size_t i) {
    const Eigen::Vector3d p = cloud.points[i].cast<double>();
    const float length = cloud.normals[i].norm();
    if (!(length > 1e-6F) || !std::isfinite(length)) return;
    cloud.normals[i] /= length;
    if (options.floor_z_mm && p.z() < *options.floor_z_mm) return;
    if (options.bounds && !options.bounds->contains(p)) return;
    int outside = 0, inside = 0;
    for (std::size_t v = 0; v < views.size(); ++v) {
      const Place place = placeOf(views[v], wide[v], p);
      outside += place == Place::Outside ? 1 : 0;
      inside += place == Place::Inside ? 1 : 0;
    }
    keep[i] = outside <= most_outside && inside >= options.min_agreeing_views ? 1 : 0;
  });
  std::vector<int> kept;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i] != 0) kept.push_back(static_cast<int>(i));
  if (kept.empty()) return nothing;
  return subset(cloud, kept);
}

Result<fs::path> outsideProgram(const std::string& name, const std::string& option) {
  const std::optional<fs::path> program = colmap::findProgram(name);
  if (program) return *program;
  return Error{ErrorCode::Missing,
               message("The program %1 is not on the PATH, but --dense %2 needs it; install it, or "
                       "use --dense builtin, which needs no other program.",
                       name, option),
               {}};
}

}  // namespace ostraka::stereo
