#include "review/orthophoto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "cloud/bounds.h"

namespace ostraka::review {
namespace {

constexpr double kCell_mm = 1.0;    // two or three points in each cell
constexpr double kAround_mm = 1.5;  // a photograph's edge lies this near to the scan's

constexpr double kPointReach_mm = 0.25;  // scans hold a point every 0.2 to 0.4 mm
constexpr Color kPlainClay = {176, 160, 144};

// Heights per cell; cells without points get their surroundings' height.
struct HeightField {
  cv::Mat1f height;
  cv::Mat1b filled;  ///< 255: a point lies there
  Eigen::Vector2d low;

  double at(const Eigen::Vector2d& p) const {
    const double x = std::clamp((p.x() - low.x()) / kCell_mm - 0.5, 0.0, height.cols - 1.001);
    const double y = std::clamp((p.y() - low.y()) / kCell_mm - 0.5, 0.0, height.rows - 1.001);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double u = x - i, v = y - j;
    return (1 - v) * ((1 - u) * height(j, i) + u * height(j, i + 1)) +
           v * ((1 - u) * height(j + 1, i) + u * height(j + 1, i + 1));
  }
};

HeightField heightsOf(std::span<const Eigen::Vector3f> points, Facing facing,
                      const PictureFrame& frame) {
  HeightField field;
  field.low = frame.low_mm;
  const int columns = static_cast<int>(frame.width * frame.px_mm / kCell_mm) + 2;
  const int rows = static_cast<int>(frame.height * frame.px_mm / kCell_mm) + 2;
  field.height.create(rows, columns);
  field.height = 0;
  field.filled = cv::Mat1b::zeros(rows, columns);
  for (const Eigen::Vector3f& p : points) {
    const int i = static_cast<int>(std::floor((p.x() - field.low.x()) / kCell_mm));
    const int j = static_cast<int>(std::floor((p.y() - field.low.y()) / kCell_mm));
    if (i < 0 || j < 0 || i >= columns || j >= rows) continue;
    float& z = field.height(j, i);
    const bool first = field.filled(j, i) == 0;
    if (first || (facing == Facing::Up ? p.z() > z : p.z() < z)) z = p.z();
    field.filled(j, i) = 255;
  }
  // Wider and wider surroundings, until everything has a height.
  cv::Mat1f known;
  field.filled.convertTo(known, CV_32F, 1.0 / 255);
  for (int size = 3; cv::countNonZero(known == 0) > 0 && size < 4 * (columns + rows); size *= 2) {
    cv::Mat1f sum, weight;
    cv::Mat1f weighted = field.height.mul(known);
    cv::blur(weighted, sum, {size | 1, size | 1}, {-1, -1}, cv::BORDER_CONSTANT);
    cv::blur(known, weight, {size | 1, size | 1}, {-1, -1}, cv::BORDER_CONSTANT);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        if (known(j, i) == 0 && weight(j, i) > 1e-4f) {
          field.height(j, i) = sum(j, i) / weight(j, i);
          known(j, i) = 1;
        }
  }
  return field;
}

// 255 near the scan's footprint, soft at its edge: neighbours in the picture are left out.
cv::Mat1b footprintIn(const HeightField& field, const PictureFrame& frame) {
  cv::Mat1b grown;
  const int reach = static_cast<int>(std::ceil(kAround_mm / kCell_mm));
  cv::dilate(field.filled, grown,
             cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * reach + 1, 2 * reach + 1}));
  cv::Mat1f x(frame.height, frame.width), y(frame.height, frame.width);
  for (int r = 0; r < frame.height; ++r)
    for (int c = 0; c < frame.width; ++c) {
      const Eigen::Vector2d p = (frame.at(c, r) - field.low) / kCell_mm;
      x(r, c) = static_cast<float>(p.x() - 0.5);
      y(r, c) = static_cast<float>(p.y() - 0.5);
    }
  cv::Mat1b out;
  cv::remap(grown, out, x, y, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  return out;
}

}  // namespace

PictureFrame frameAround(std::span<const Eigen::Vector3f> points, double px_mm, double margin_mm) {
  PictureFrame frame;
  frame.px_mm = px_mm;
  if (points.empty()) return frame;
  const auto [lowest, highest] = boundsOf(points);
  const Eigen::Vector2f low = lowest.head<2>(), high = highest.head<2>();
  frame.low_mm = low.cast<double>().array() - margin_mm;
  const Eigen::Vector2d size = (high - low).cast<double>().array() + 2 * margin_mm;
  // A metre is no sherd: a flying point must not cost all memory.
  frame.width = static_cast<int>(std::ceil(std::min(size.x(), 1000.0) / px_mm));
  frame.height = static_cast<int>(std::ceil(std::min(size.y(), 1000.0) / px_mm));
  return frame;
}

Picture orthophoto(const cv::Mat& photograph, const cv::Mat1b& mask, const rig::PosedImage& image,
                   std::span<const Eigen::Vector3f> points,
                   const Eigen::Isometry3d& plate_from_frame, Facing facing,
                   const PictureFrame& frame) {
  if (photograph.empty() || points.empty() || frame.width < 1 || frame.height < 1) return {};
  const HeightField field = heightsOf(points, facing, frame);
  cv::Mat1f x(frame.height, frame.width), y(frame.height, frame.width);
  for (int r = 0; r < frame.height; ++r)
    for (int c = 0; c < frame.width; ++c) {
      const Eigen::Vector2d p = frame.at(c, r);
      const Eigen::Vector2d pixel =
          image.project(plate_from_frame * Eigen::Vector3d(p.x(), p.y(), field.at(p)));
      x(r, c) = static_cast<float>(pixel.x());
      y(r, c) = static_cast<float>(pixel.y());
    }
  cv::Mat colours, rgba;
  cv::remap(photograph, colours, x, y, cv::INTER_CUBIC, cv::BORDER_REPLICATE);
  cv::Mat1b alpha = footprintIn(field, frame);
  if (mask.size() == photograph.size()) {
    cv::Mat1b seen;
    cv::remap(mask, seen, x, y, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
    alpha = cv::min(alpha, seen);
  }
  cv::cvtColor(colours, rgba, cv::COLOR_BGR2RGBA);
  cv::Mat planes[] = {alpha};
  const int from_to[] = {0, 3};
  cv::mixChannels(planes, 1, &rgba, 1, from_to, 1);
  Picture picture{rgba.cols, rgba.rows, {}};
  picture.rgba.assign(rgba.data, rgba.data + rgba.total() * 4);
  return picture;
}

Picture pointPicture(const PointCloud& cloud, const Eigen::Isometry3d& frame_from_cloud,
                     Facing facing, const PictureFrame& frame) {
  if (cloud.empty() || frame.width < 1 || frame.height < 1) return {};
  const PointCloud seen = transformed(cloud, frame_from_cloud);
  const float sign = facing == Facing::Up ? 1.0f : -1.0f;
  const int reach = std::max(1, static_cast<int>(std::ceil(kPointReach_mm / frame.px_mm)));
  cv::Mat1f nearest(frame.height, frame.width, -std::numeric_limits<float>::max());
  Picture picture{frame.width, frame.height, {}};
  picture.rgba.assign(static_cast<std::size_t>(frame.width) * frame.height * 4, 0);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const float lit = seen.hasNormals() ? sign * seen.normals[i].z() : 1.0f;
    if (lit < 0) continue;  // the other face
    const Color own = i < seen.colors.size() ? seen.colors[i] : kPlainClay;
    // Light from above, so that relief is seen where colours are missing.
    const float shade = seen.hasNormals() ? 0.35f + 0.65f * lit : 1.0f;
    const Eigen::Vector2d at =
        (seen.points[i].head<2>().cast<double>() - frame.low_mm) / frame.px_mm;
    const int column = static_cast<int>(at.x()), row = frame.height - 1 - static_cast<int>(at.y());
    const float height = sign * seen.points[i].z();
    for (int r = std::max(0, row - reach); r <= std::min(frame.height - 1, row + reach); ++r)
      for (int c = std::max(0, column - reach); c <= std::min(frame.width - 1, column + reach);
           ++c) {
        if (height <= nearest(r, c)) continue;
        nearest(r, c) = height;
        std::uint8_t* pixel = &picture.rgba[4 * (static_cast<std::size_t>(r) * frame.width +
                                                 static_cast<std::size_t>(c))];
        for (int k = 0; k < 3; ++k)
          pixel[k] = static_cast<std::uint8_t>(shade * own[static_cast<std::size_t>(k)]);
        pixel[3] = 255;
      }
  }
  return picture;
}

}  // namespace ostraka::review
