#pragma once
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "ground/plate_geometry.h"

namespace ostraka::ground {

/// Colours are compared as log(value + kDarkLevel): a shadow and an exposure are then a shift, and
/// the noise of the darkest levels (sensor, 8 bits, JPEG: about 1-2 levels) stays bounded.
inline constexpr float kDarkLevel = 4;

/// CV_32FC3 log(value + kDarkLevel) of a CV_8UC3 photograph.
cv::Mat3f logColours(const cv::Mat& photograph);

/// What one camera's photographs of one side say about the bare plate.
struct PlatePicture {
  cv::Mat3f albedo;   ///< grid; log colour against the light field
  cv::Mat1f support;  ///< grid; number of bare looks behind each cell (the empty plate counts 4)
  cv::Mat3f light;    ///< image lattice of kLightStep pixels; log light, vignetting included
  std::vector<cv::Vec3f> exposure;  ///< per photograph; log
  cv::Mat3f room;          ///< CV_32FC3 of the photograph's size: log colour of what does not turn
  bool has_empty = false;  ///< the empty photograph fitted and was used
};

inline constexpr int kLightStep = 64;  ///< pixels; light on a plate varies over centimetres

/// One photograph's part in the picture.
struct PlateLook {
  cv::Mat3f log_colours;    ///< of the photograph
  cv::Mat2f grid_of_pixel;  ///< gridOfPixels
  cv::Mat2f pixel_of_cell;  ///< pixelsOfGrid
};

/// Light, exposure and the plate's own colours, estimated in turns with weights that fade for
/// samples that do not look like bare plate. The lamps stand still while the plate turns, so for
/// one camera the light is a smooth field over its pixels: log I(x) = albedo(cell(x)) + light(x) +
/// exposure. looks: the stops of one camera; empty: log colours of the empty plate at stop 0 with
/// look `empty_look`, or an empty Mat. Cells that were never bare take their neighbours' colours.
PlatePicture buildPlatePicture(std::span<const PlateLook> looks, const cv::Mat3f& empty,
                               int empty_look, const PlateGrid& grid, const cv::Mat1b& paper);

/// The bare plate (and the still room around it) as this look would show it, log colours.
cv::Mat3f predictBare(const PlatePicture& picture, const PlateLook& look, std::size_t index,
                      const PlateGrid& grid);

}  // namespace ostraka::ground
