#include "ground/plate_geometry.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace ostraka::ground {
namespace {

constexpr int kStep = 4;  // lattice of exact values; a perspective bends little over 4 px
constexpr float kNowhere = -1e4F;

// Evaluates `exact` on a lattice and fills between bilinearly.
template <class Exact>
cv::Mat2f interpolated(int width, int height, const Exact& exact) {
  const int columns = (width + kStep - 1) / kStep + 1;
  const int rows = (height + kStep - 1) / kStep + 1;
  cv::Mat2f nodes(rows, columns);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) nodes(r, c) = exact(c * kStep, r * kStep);
  cv::Mat2f full(height, width);
  for (int y = 0; y < height; ++y) {
    const float v = static_cast<float>(y % kStep) / kStep;
    const cv::Vec2f* top = nodes[y / kStep];
    const cv::Vec2f* bottom = nodes[y / kStep + 1];
    cv::Vec2f* to = full[y];
    for (int c = 0; c * kStep < width; ++c) {
      const int end = std::min(kStep, width - c * kStep);
      const bool whole = top[c][0] > kNowhere && top[c + 1][0] > kNowhere &&
                         bottom[c][0] > kNowhere && bottom[c + 1][0] > kNowhere;
      const cv::Vec2f left = top[c] * (1 - v) + bottom[c] * v,
                      right = top[c + 1] * (1 - v) + bottom[c + 1] * v;
      for (int k = 0; k < end; ++k) {
        const float u = static_cast<float>(k) / kStep;
        *to++ = whole ? left * (1 - u) + right * u : cv::Vec2f(kNowhere, kNowhere);
      }
    }
  }
  return full;
}

// Of the circle that the grid's square surrounds. A sheet's markers may all lie in its middle.
double radiusOf(const batch::Plate& plate) {
  const double marked = 0.5 * plate.diameter_mm;
  return plate.sheet ? std::max(marked, 0.5 * plate.sheet->sizes().maxCoeff()) : marked;
}

}  // namespace

double millimetresPerPixel(const rig::PosedImage& image) {
  const double depth = std::max(1.0, image.camera_from_plate.translation().z());
  return depth / image.intrinsics.fx;
}

double finestPitch_mm(const batch::Plate& plate) {
  return 2 * radiusOf(plate) / 1600;
}

PlateGrid gridOver(const batch::Plate& plate, double mm_per_pixel) {
  PlateGrid grid;
  grid.radius_mm = radiusOf(plate);
  grid.pitch_mm = 1.4 * mm_per_pixel;
  grid.pitch_mm = std::max(grid.pitch_mm, finestPitch_mm(plate));
  grid.size = 2 * static_cast<int>(std::ceil(grid.radius_mm / grid.pitch_mm)) + 1;
  grid.ring_inner_mm = grid.radius_mm;
  if (plate.sheet) return grid;  // sherds may lie on its markers
  for (const batch::Marker& marker : plate.markers) {
    const double side = (marker.corners[1] - marker.corners[0]).norm();
    double nearest = grid.radius_mm;
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector3d middle = 0.5 * (marker.corners[k] + marker.corners[(k + 1) % 4]);
      nearest = std::min(nearest, middle.norm() - side / 6);
    }
    // One in the middle of the plate is none of the ring: sherds lie around it.
    if (nearest > 0.5 * grid.radius_mm) grid.ring_inner_mm = std::min(grid.ring_inner_mm, nearest);
  }
  return grid;
}

cv::Mat2f gridOfPixels(const rig::PosedImage& image, const PlateGrid& grid,
                       const rig::SheetBend& bend) {
  const bool flat = bend.flat();
  const Eigen::Isometry3d plate_from_camera = image.camera_from_plate.inverse();
  const Eigen::Vector3d centre = plate_from_camera.translation();
  return interpolated(image.intrinsics.width, image.intrinsics.height, [&](int x, int y) {
    const Eigen::Vector2d n = image.intrinsics.unproject({static_cast<double>(x), y});
    const Eigen::Vector3d ray = plate_from_camera.linear() * n.homogeneous();
    const double scale = -centre.z() / ray.z();
    if (!(scale > 0)) return cv::Vec2f(kNowhere, kNowhere);
    Eigen::Vector3d p = centre + scale * ray;
    // A sheet rises by a few millimetres over decimetres: each round leaves a hundredth.
    for (int round = 0; round < 3 && !flat; ++round)
      p = centre + (bend.at(p.x(), p.y()) - centre.z()) / ray.z() * ray;
    return cv::Vec2f(static_cast<float>(p.x() / grid.pitch_mm + grid.middle()),
                     static_cast<float>(p.y() / grid.pitch_mm + grid.middle()));
  });
}

cv::Mat2f pixelsOfCells(const rig::PosedImage& image, const Eigen::Vector2d& first_mm,
                        double pitch_mm, cv::Size cells, const rig::SheetBend& bend) {
  const bool flat = bend.flat();
  return interpolated(cells.width, cells.height, [&](int column, int row) {
    Eigen::Vector3d p(first_mm.x() + column * pitch_mm, first_mm.y() + row * pitch_mm, 0);
    if (!flat) p.z() = bend.at(p.x(), p.y());
    const Eigen::Vector3d q = image.camera_from_plate * p;
    if (q.z() <= 0) return cv::Vec2f(kNowhere, kNowhere);
    const Eigen::Vector2d pixel = image.intrinsics.project(q);
    return cv::Vec2f(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  });
}

cv::Mat2f pixelsOfGrid(const rig::PosedImage& image, const PlateGrid& grid,
                       const rig::SheetBend& bend) {
  const double first = -grid.middle() * grid.pitch_mm;
  return pixelsOfCells(image, {first, first}, grid.pitch_mm, {grid.size, grid.size}, bend);
}

cv::Mat1b insideMarkers(const cv::Mat2f& grid_of_pixel, const PlateGrid& grid) {
  cv::Mat1b inside(grid_of_pixel.size(), uchar{0});
  const double limit = (grid.ring_inner_mm - 2) / grid.pitch_mm;
  const cv::Vec2f middle(static_cast<float>(grid.middle()), static_cast<float>(grid.middle()));
  for (int y = 0; y < inside.rows; ++y)
    for (int x = 0; x < inside.cols; ++x)
      if (cv::norm(grid_of_pixel(y, x) - middle) < limit) inside(y, x) = 255;
  return inside;
}

cv::Mat1b markerPaper(const batch::Plate& plate, const PlateGrid& grid) {
  cv::Mat1b paper(grid.size, grid.size, uchar{0});
  for (const batch::Marker& marker : plate.markers) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : marker.corners) middle += 0.25 * corner;
    std::vector<cv::Point> outline;
    for (const Eigen::Vector3d& corner : marker.corners) {
      // A 4 x 4 marker is 6 modules wide with its border; one module of white around makes 8.
      const Eigen::Vector3d p = middle + (corner - middle) * (8.0 / 6.0);
      outline.emplace_back(cvRound(p.x() / grid.pitch_mm + grid.middle()),
                           cvRound(p.y() / grid.pitch_mm + grid.middle()));
    }
    cv::fillConvexPoly(paper, outline, cv::Scalar(255));
  }
  return paper;
}

}  // namespace ostraka::ground
