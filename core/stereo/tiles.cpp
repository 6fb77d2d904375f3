#include "stereo/tiles.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "base/median.h"

namespace ostraka::stereo {
namespace {

/// As far as windows, slant and smoothing reach (32 pixels' widths, neighbourhood_mm), and a little
/// for the surface's tilt.
constexpr float kAround_px = 40;
/// Pixels beside the outermost cube's: half a window, and what the pyramid's blur reads.
constexpr int kBeside_px = 16;

using Cubes = std::vector<Eigen::Vector3i>;

class Divider {
 public:
  Divider(const Hull& hull, std::span<const Frame* const> outlines, int shrink,
          std::span<const cv::Rect> wholes, double most_pixels)
      : hull_(hull),
        outlines_(outlines),
        shrink_(static_cast<float>(shrink)),
        wholes_(wholes),
        most_pixels_(most_pixels) {}

  std::vector<Tile> divided() {
    for (int k = 0; k < hull_.size.z(); ++k)
      for (int j = 0; j < hull_.size.y(); ++j)
        for (int i = 0; i < hull_.size.x(); ++i)
          if (hull_.inside[placeOf({i, j, k})] != 0) all_.emplace_back(i, j, k);
    if (all_.empty()) return {};
    around_mm_ = kAround_px * pixel_mm();
    constexpr float far = std::numeric_limits<float>::infinity();
    divide(all_, {Eigen::Vector3f::Constant(-far), Eigen::Vector3f::Constant(far)});
    return std::move(tiles_);
  }

 private:
  std::size_t placeOf(const Eigen::Vector3i& c) const {
    const auto x = static_cast<std::size_t>(hull_.size.x()),
               y = static_cast<std::size_t>(hull_.size.y());
    return (static_cast<std::size_t>(c.z()) * y + static_cast<std::size_t>(c.y())) * x +
           static_cast<std::size_t>(c.x());
  }

  Eigen::Vector3f at(const Eigen::Vector3i& cube) const {
    return hull_.origin + hull_.edge_mm * cube.cast<float>();
  }

  /// The width on the object of a pixel of full size, in the median of the views.
  float pixel_mm() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3i& cube : all_) sum += at(cube).cast<double>();
    const Eigen::Vector3f middle = (sum / static_cast<double>(all_.size())).cast<float>();
    std::vector<float> widths;
    for (const Frame* f : outlines_)
      widths.push_back((middle - f->centre).norm() / (f->fx * shrink_));
    return medianOf(widths);
  }

  /// What the cubes cover of a view's picture, in pixels of full size.
  cv::Rect partOf(std::size_t view, const Cubes& cubes) const {
    const Frame& frame = *outlines_[view];
    Eigen::AlignedBox2f box;
    float beside = 0;
    for (const Eigen::Vector3i& cube : cubes) {
      const Eigen::Vector3f p = frame.toCamera(at(cube));
      if (p.z() <= 0) continue;
      box.extend(frame.project(p));
      beside = std::max(beside, hull_.edge_mm * frame.fx / p.z());
    }
    if (box.isEmpty()) return {};
    const Eigen::Array2f half = Eigen::Array2f::Constant(0.5F);
    const Eigen::Array2f low = (box.min().array() - beside + half) * shrink_ - half - kBeside_px;
    const Eigen::Array2f high = (box.max().array() + beside + half) * shrink_ - half + kBeside_px;
    // Begins at a whole pixel of the coarsest level, so that all parts have the same levels.
    const auto step = static_cast<int>(shrink_);
    const cv::Rect& whole = wholes_[view];
    const Eigen::Array2f size(static_cast<float>(whole.width), static_cast<float>(whole.height));
    const Eigen::Array2i first = low.max(0.0F).min(size).cast<int>() / step * step;
    const Eigen::Array2i last = high.max(0.0F).min(size).ceil().cast<int>();
    // The coarsest level needs a pixel inside its border.
    if (((last - first) < 4 * step).any()) return {};
    return {whole.x + first.x(), whole.y + first.y(), last.x() - first.x(), last.y() - first.y()};
  }

  Tile tileOf(const Cubes& cubes, const Eigen::AlignedBox3f& own) const {
    Tile tile;
    tile.own = own;
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3i& cube : cubes) box.extend(at(cube));
    const Eigen::Vector3f around = Eigen::Vector3f::Constant(around_mm_ + hull_.edge_mm);
    tile.reach = {box.min() - around, box.max() + around};
    Cubes near;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const Eigen::Vector3i& cube : all_)
      if (tile.reach.contains(at(cube))) {
        near.push_back(cube);
        sum += cube.cast<float>();
      }
    tile.middle = hull_.origin + hull_.edge_mm / static_cast<float>(near.size()) * sum;
    for (std::size_t view = 0; view < outlines_.size(); ++view)
      tile.parts.push_back(partOf(view, near));
    return tile;
  }

  struct Cut {
    Eigen::Index axis = 0;
    int before = 0;  ///< cubes of a smaller index along the axis come into the first half
  };

  /// Where the fewest cubes lie, among planes with a quarter of the cubes on each side.
  std::optional<Cut> cutOf(const Cubes& cubes) const {
    Eigen::AlignedBox3i box;
    for (const Eigen::Vector3i& cube : cubes) box.extend(cube);
    const Eigen::Vector3i layers = box.sizes().array() + 1;
    std::optional<Cut> best;
    std::int64_t fewest = 0, off_middle = 0;
    const auto count = static_cast<std::int64_t>(cubes.size());
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const int n = layers[axis];
      // Halves of a flat thing laid upon each other are seen by the same pixels.
      if (2 * n < layers.maxCoeff() ||
          static_cast<float>(n) * hull_.edge_mm < 3 * around_mm_)
        continue;
      std::vector<std::int64_t> of(static_cast<std::size_t>(n), 0);
      for (const Eigen::Vector3i& cube : cubes)
        ++of[static_cast<std::size_t>(cube[axis] - box.min()[axis])];
      std::int64_t below = 0;
      for (int k = 0; k + 1 < n; ++k) {
        below += of[static_cast<std::size_t>(k)];
        if (4 * below < count || 4 * below > 3 * count) continue;
        const std::int64_t here =
            std::min(of[static_cast<std::size_t>(k)], of[static_cast<std::size_t>(k) + 1]);
        const std::int64_t off = std::abs(2 * below - count);
        if (!best || here < fewest || (here == fewest && off < off_middle)) {
          best = Cut{axis, box.min()[axis] + k + 1};
          fewest = here;
          off_middle = off;
        }
      }
    }
    return best;
  }

  void divide(const Cubes& cubes, const Eigen::AlignedBox3f& own) {
    Tile tile = tileOf(cubes, own);
    double pixels = 0;
    for (const cv::Rect& part : tile.parts) pixels += part.area();
    const std::optional<Cut> cut = pixels > most_pixels_ ? cutOf(cubes) : std::nullopt;
    if (!cut) {
      tiles_.push_back(std::move(tile));
      return;
    }
    Cubes low, high;
    for (const Eigen::Vector3i& cube : cubes)
      (cube[cut->axis] < cut->before ? low : high).push_back(cube);
    const float plane = hull_.origin[cut->axis] +
                        hull_.edge_mm * (static_cast<float>(cut->before) - 0.5F);
    Eigen::AlignedBox3f lower = own, upper = own;
    lower.max()[cut->axis] = upper.min()[cut->axis] = plane;
    divide(low, lower);
    divide(high, upper);
  }

  const Hull& hull_;
  std::span<const Frame* const> outlines_;
  float shrink_;
  std::span<const cv::Rect> wholes_;
  double most_pixels_;
  Cubes all_ = {};
  float around_mm_ = 0;
  std::vector<Tile> tiles_ = {};
};

}  // namespace

bool Tile::owns(const Eigen::Vector3f& p_plate) const {
  return (p_plate.array() >= own.min().array()).all() &&
         (p_plate.array() < own.max().array()).all();
}

std::vector<Tile> tilesOf(const Hull& hull, std::span<const Frame* const> outlines, int shrink,
                          std::span<const cv::Rect> wholes, double most_pixels) {
  return Divider(hull, outlines, shrink, wholes, most_pixels).divided();
}

}  // namespace ostraka::stereo
