#include "stereo/hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/message.h"
#include "base/parallel.h"

namespace ostraka::stereo {
namespace {

constexpr double kMaxCubes = 6e6;        // 6 MB, about 0.6 mm on a plate of sherds
constexpr double kMaxCoarseCubes = 2e5;  // to find the bounds

/// A cube around the middle that every view sees whole.
Eigen::AlignedBox3f boxAround(const Eigen::Vector3f& middle, std::span<const Frame* const> frames) {
  float radius = 0;
  for (const Frame* f : frames) {
    const float distance = (middle - f->centre).norm();
    const float half = 0.5F * static_cast<float>(std::max(f->width, f->height));
    radius = std::max(radius, distance * half / std::min(f->fx, f->fy));
  }
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(radius);
  return {middle - reach, middle + reach};
}

Eigen::Vector3f axisOf(const Frame& frame) {
  return frame.rotation.row(2).transpose();
}

/// The point nearest to all optical axes.
Eigen::Vector3f whereAxesMeet(std::span<const Frame* const> frames) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const Frame* f : frames) {
    const Eigen::Vector3d axis = axisOf(*f).cast<double>();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
    a += across;
    b += across * f->centre.cast<double>();
  }
  return a.ldlt().solve(b).cast<float>();
}

/// The middle of where the optical axes meet the floor: photographs from straight above have axes
/// that meet nowhere, or above the cameras.
std::optional<Eigen::Vector3f> whereAxesMeetTheFloor(std::span<const Frame* const> frames,
                                                     float floor_z) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float count = 0;
  for (const Frame* f : frames) {
    const Eigen::Vector3f axis = axisOf(*f);
    const float along = (floor_z - f->centre.z()) / axis.z();
    if (!(along > 0) || !std::isfinite(along)) continue;
    sum += f->centre + along * axis;
    count += 1;
  }
  if (count == 0) return std::nullopt;
  return Eigen::Vector3f(sum / count);
}

/// Fewer views than this cannot give a depth that others confirm.
constexpr int kMinViews = 3;

enum class Seen { NotInPicture, Outside, Inside };

Seen seen(const Frame& f, const Eigen::Vector3f& p_plate, float margin_mm) {
  const Eigen::Vector3f p = f.toCamera(p_plate);
  if (p.z() <= 0) return Seen::NotInPicture;
  const Eigen::Vector2f pixel = f.project(p);
  if (!f.shows(pixel)) return Seen::NotInPicture;
  const Eigen::Vector2i nearest = (pixel.array() + 0.5F).cast<int>();
  const int x = nearest.x(), y = nearest.y();
  const int reach = static_cast<int>(std::ceil(margin_mm * f.fx / p.z()));
  for (int v = std::max(0, y - reach); v <= std::min(f.height - 1, y + reach); ++v)
    for (int u = std::max(0, x - reach); u <= std::min(f.width - 1, x + reach); ++u)
      if (f.coverage(v, u) > 0.01F) return Seen::Inside;
  return Seen::Outside;
}

bool maybeObject(std::span<const Frame* const> frames, const Eigen::Vector3f& p_plate,
                 float margin_mm) {
  int inside = 0, outside = 0;
  const int most_outside = masksThatMayErr(frames.size());
  for (const Frame* f : frames) {
    const Seen s = seen(*f, p_plate, margin_mm);
    outside += s == Seen::Outside ? 1 : 0;
    if (outside > most_outside) return false;
    inside += s == Seen::Inside ? 1 : 0;
  }
  return inside >= kMinViews;
}

Hull carve(std::span<const Frame* const> frames, const Eigen::AlignedBox3f& box, double max_cubes,
           int threads) {
  Hull hull;
  const Eigen::Vector3f extent = box.sizes();
  hull.edge_mm = static_cast<float>(
      std::cbrt(static_cast<double>(extent.x()) * extent.y() * extent.z() / max_cubes));
  hull.size = (extent / hull.edge_mm).array().ceil().cast<int>().max(1);
  hull.origin = box.min() + Eigen::Vector3f::Constant(hull.edge_mm / 2);
  const auto layer =
      static_cast<std::size_t>(hull.size.x()) * static_cast<std::size_t>(hull.size.y());
  hull.inside.assign(layer * static_cast<std::size_t>(hull.size.z()), 0);
  const float margin_mm = hull.edge_mm;  // a cube reaches 0.87 of its edge from its centre
  parallelFor(static_cast<std::size_t>(hull.size.z()), threads, [&](std::size_t k) {
    for (int j = 0; j < hull.size.y(); ++j)
      for (int i = 0; i < hull.size.x(); ++i) {
        const Eigen::Vector3f p =
            hull.origin + hull.edge_mm * Eigen::Vector3i(i, j, static_cast<int>(k)).cast<float>();
        const auto place = static_cast<std::size_t>(j) * static_cast<std::size_t>(hull.size.x()) +
                           static_cast<std::size_t>(i);
        hull.inside[k * layer + place] = maybeObject(frames, p, margin_mm) ? 1 : 0;
      }
  });
  return hull;
}

Eigen::AlignedBox3f boundsOf(const Hull& hull) {
  Eigen::AlignedBox3f box;
  std::size_t place = 0;
  for (int k = 0; k < hull.size.z(); ++k)
    for (int j = 0; j < hull.size.y(); ++j)
      for (int i = 0; i < hull.size.x(); ++i, ++place)
        if (hull.inside[place] != 0)
          box.extend(hull.origin + hull.edge_mm * Eigen::Vector3f(static_cast<float>(i),
                                                                  static_cast<float>(j),
                                                                  static_cast<float>(k)));
  return box;
}

/// Six million cubes of the box; nothing where none of them may be the object.
std::optional<Hull> carvedFinely(std::span<const Frame* const> frames,
                                 const Eigen::AlignedBox3f& box, int threads) {
  if (box.isEmpty()) return std::nullopt;
  Hull hull = carve(frames, box, kMaxCubes, threads);
  return boundsOf(hull).isEmpty() ? std::nullopt : std::optional(std::move(hull));
}

/// As many of what few cubes of the box bound.
std::optional<Hull> carvedWithin(std::span<const Frame* const> frames,
                                 const Eigen::AlignedBox3f& box, int threads) {
  if (box.isEmpty()) return std::nullopt;
  const Hull coarse = carve(frames, box, kMaxCoarseCubes, threads);
  const Eigen::AlignedBox3f found = boundsOf(coarse);
  if (found.isEmpty()) return std::nullopt;
  const Eigen::Vector3f margin = Eigen::Vector3f::Constant(2 * coarse.edge_mm);
  return carvedFinely(frames, box.intersection({found.min() - margin, found.max() + margin}),
                      threads);
}

Eigen::AlignedBox3f above(const std::optional<double>& floor_z_mm, Eigen::AlignedBox3f box) {
  if (floor_z_mm) box.min().z() = std::max(box.min().z(), static_cast<float>(*floor_z_mm));
  return box;
}

}  // namespace

int masksThatMayErr(std::size_t views) {
  return std::max(1, static_cast<int>(views / 24));
}

bool Hull::at(const Eigen::Vector3f& p_plate) const {
  const Eigen::Vector3f place = (p_plate - origin) / edge_mm + Eigen::Vector3f::Constant(0.5F);
  if ((place.array() < 0).any()) return false;
  const Eigen::Vector3i cube = place.cast<int>();
  if ((cube.array() >= size.array()).any()) return false;
  const auto layer = static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y());
  return inside[static_cast<std::size_t>(cube.z()) * layer +
                static_cast<std::size_t>(cube.y()) * static_cast<std::size_t>(size.x()) +
                static_cast<std::size_t>(cube.x())] != 0;
}

Result<Hull> carveHull(std::span<const Frame* const> frames, const DenseOptions& options,
                       int threads) {
  const std::optional<double>& floor = options.floor_z_mm;
  std::optional<Hull> hull;
  if (options.bounds)
    hull = carvedFinely(frames, above(floor, options.bounds->cast<float>()), threads);
  else
    hull = carvedWithin(frames, above(floor, boxAround(whereAxesMeet(frames), frames)), threads);
  if (!hull && !options.bounds && floor)
    if (const auto middle = whereAxesMeetTheFloor(frames, static_cast<float>(*floor)))
      hull = carvedWithin(frames, above(floor, boxAround(*middle, frames)), threads);
  if (hull) return std::move(*hull);
  return Error{
      ErrorCode::NotEnough,
      message("The masks of the views show no common object; check masks, cameras and bounds."),
      {}};
}

std::vector<DepthRange> depthRanges(const Hull& hull, const Frame& frame,
                                    const Eigen::AlignedBox3f& reach) {
  std::vector<DepthRange> ranges(static_cast<std::size_t>(frame.width) *
                                 static_cast<std::size_t>(frame.height));
  const Eigen::Vector3f half = Eigen::Vector3f::Constant(hull.edge_mm / 2);
  const Eigen::Vector3f low = hull.origin - half;
  const Eigen::Vector3f high = low + hull.edge_mm * hull.size.cast<float>();
  const float step_mm = hull.edge_mm * 0.7F;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      if (frame.coverage(y, x) < 0.01F) continue;
      // p = centre + s * direction with s the depth, as the ray's z is 1 in the camera's frame
      const Eigen::Vector3f direction =
          frame.rotation.transpose() * frame.ray(static_cast<float>(x), static_cast<float>(y));
      const Eigen::Array3f a = (low - frame.centre).array() / direction.array();
      const Eigen::Array3f b = (high - frame.centre).array() / direction.array();
      const float enter = std::max(1.0F, a.min(b).maxCoeff()), leave = a.max(b).minCoeff();
      DepthRange& range =
          ranges[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
                 static_cast<std::size_t>(x)];
      const float step = step_mm / direction.norm();
      float s = enter;
      bool within = false;
      while (s <= leave) {
        const Eigen::Vector3f p = frame.centre + s * direction;
        if (hull.at(p)) {
          if (range.far == 0) range.near = s - step;
          range.far = s + step;
          within = within || reach.contains(p);
        }
        s += step;
      }
      if (!within) range = {};
    }
  return ranges;
}

std::vector<DepthRange> depthRanges(const Hull& hull, const Frame& frame) {
  const Eigen::Vector3f far =
      Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
  return depthRanges(hull, frame, {-far, far});
}

}  // namespace ostraka::stereo
