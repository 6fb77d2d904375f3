#pragma once
#include <array>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "ground/plate_geometry.h"

namespace ostraka::ground {

/// The sheet as it was printed: share of bare paper (not ink) in each cell of the grid, 0..1;
/// negative beyond the sheet's edge. Errors: UnusableInput (dictionary).
Result<cv::Mat1f> printedSheet(const batch::Plate& plate, const PlateGrid& grid);

/// What the photographs of one side say about a bare sheet that they look down on from anywhere.
struct SheetPicture {
  /// How one photograph shows paper and ink: log colour of white paper as a quadratic over the
  /// sheet (1 u v uu uv vv, u and v in units of the grid's radius), and of ink against it. Light,
  /// exposure, white balance and vignetting are all in it.
  struct Tone {
    std::array<cv::Vec3f, 6> paper{};
    cv::Vec3f ink{-1.5F, -1.5F, -1.5F};
    cv::Vec3f paperAt(float u, float v) const;
  };
  std::vector<Tone> tones;  ///< by photograph
  /// Grid; log colour by which the sheet differs from its printed picture wherever it was seen
  /// bare: stains, creases, print that plate.json does not know.
  cv::Mat3f correction;
  /// Grid; 255 where so many photographs agree on what lies in the sheet's plane that it must be
  /// bare, lit or in a shadow that lasts. Empty where light does not stand still.
  cv::Mat1b witnessed;
  cv::Mat1b shade;  ///< of these the ones that lie in a shadow; empty likewise
  /// Grid; 255 where something stands: plain paper at which enough photographs look and of which
  /// too few see the same. Empty likewise.
  cv::Mat1b standing;
  /// Whether light and shade stand still on the sheet from photograph to photograph, as they do
  /// when the camera moves; with a camera at rest over a sheet that is turned they do not.
  bool still_light = true;
};

/// samples: per photograph the 8-bit colours at the grid's cells, (0,0,0) where the cell is not in
/// the picture; printed: printedSheet. What covers the sheet is left out as far as it is darker,
/// brighter or of another tint than paper or ink.
/// covered: empty, or per photograph 255 where it is known to look at something that stands before
/// the cell; its sample there is (0,0,0).
SheetPicture buildSheetPicture(std::span<const cv::Mat3b> samples, const cv::Mat1f& printed,
                               std::span<const cv::Mat1b> covered = {});

/// The bare sheet as photograph `index` would show it, log colours; 0 where the pixel does not see
/// the sheet. known: 255 where it does.
cv::Mat3f predictBareSheet(const SheetPicture& picture, std::size_t index, const cv::Mat1f& printed,
                           const cv::Mat2f& grid_of_pixel, cv::Mat1b& known);

/// Where a photograph would show the sheet's ink: 255 where less than half of what is printed
/// behind the pixel is paper.
cv::Mat1b inkBehind(const cv::Mat1f& printed, const cv::Mat2f& grid_of_pixel);

/// Where a photograph looks at a place of the sheet on which something stands (SheetPicture), 255;
/// the thing shows there, or what hides its foot, whatever its colour.
cv::Mat1b somethingStands(const SheetPicture& picture, const cv::Mat2f& grid_of_pixel);

/// How surely a photograph sees the bare sheet where others do (SheetPicture::witnessed), 0..1, by
/// its residual against predictBareSheet. Grain, by which clay is told from even plates, says
/// nothing there: the darker paper lies, the more a sensor's noise looks like it.
cv::Mat1f seenBare(const SheetPicture& picture, const cv::Mat3f& residual,
                   const cv::Mat2f& grid_of_pixel);

}  // namespace ostraka::ground
