#pragma once
#include <opencv2/core/mat.hpp>

#include "batch/batch.h"
#include "rig/camera.h"
#include "rig/sheet_bend.h"

namespace ostraka::ground {

/// Square cells over the plate: cell (column, row) is centred at plate x = (column - middle) *
/// pitch, y = (row - middle) * pitch, z = 0.
struct PlateGrid {
  double pitch_mm = 0.35;
  int size = 0;              ///< cells per side, odd
  double radius_mm = 0;      ///< of the plate's edge
  double ring_inner_mm = 0;  ///< the markers' paper begins here; no sherd stands beyond
  double middle() const { return 0.5 * (size - 1); }
};

/// The finest cells over a plate: finer than 1/1600 of it they would cost memory, and no outline
/// gets better by it.
double finestPitch_mm(const batch::Plate& plate);

/// A grid whose cells are about 1.4 pixels wide, so that neighbours are hardly correlated and the
/// mosaic of a camera fits into memory.
PlateGrid gridOver(const batch::Plate& plate, double mm_per_pixel);

/// Millimetres per pixel at the plate's centre.
double millimetresPerPixel(const rig::PosedImage& image);

/// CV_32FC2 of the photograph's size: grid coordinates (column, row) of the plate point behind each
/// pixel; (-1e4, -1e4) where the ray misses the plane. Interpolated on a 4-pixel lattice (< 0.01
/// px). bend: of a sheet that leaves its plane.
cv::Mat2f gridOfPixels(const rig::PosedImage& image, const PlateGrid& grid,
                       const rig::SheetBend& bend = {});

/// CV_32FC2: pixel of each of `cells` points of the plate, the first of them at first_mm, pitch_mm
/// apart; (-1e4, -1e4) behind the camera. Interpolated as gridOfPixels.
cv::Mat2f pixelsOfCells(const rig::PosedImage& image, const Eigen::Vector2d& first_mm,
                        double pitch_mm, cv::Size cells, const rig::SheetBend& bend = {});

/// CV_32FC2 of the grid's size: pixel of each cell's centre; (-1e4, -1e4) behind the camera.
cv::Mat2f pixelsOfGrid(const rig::PosedImage& image, const PlateGrid& grid,
                       const rig::SheetBend& bend = {});

/// 255 where a photograph sees the plate inside the markers, where sherds lie. grid_of_pixel:
/// gridOfPixels.
cv::Mat1b insideMarkers(const cv::Mat2f& grid_of_pixel, const PlateGrid& grid);

/// 255 on the markers' paper (marker and a quiet zone of one module), 0 elsewhere.
cv::Mat1b markerPaper(const batch::Plate& plate, const PlateGrid& grid);

}  // namespace ostraka::ground
