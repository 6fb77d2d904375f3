#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <stop_token>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "capture/shot_checks.h"

namespace ostraka::capture {

/// The inside of the marker ring seen from straight above: rows from far (+y) to near, 0.5 mm a
/// pixel. Quick and rough: good for counting, not for measuring.
struct PlateMap {
  static constexpr double kPixelMm = 0.5;
  double radius_mm = 0;  ///< of the disc that is free of markers and their paper
  cv::Mat1b seen;        ///< 255 where the picture shows this part of the disc
  cv::Mat1b sherd;       ///< 255 where a sherd seems to lie

  Eigen::Vector2d plate_mm(double column, double row) const {
    return {column * kPixelMm - radius_mm, radius_mm - row * kPixelMm};
  }
};

/// The radius of the disc within the markers' paper; 0 without markers.
double freeRadius_mm(const batch::Plate& plate);

/// What differs from the plate's felt by colour, brightness or roughness; a smooth shadow does not.
/// picture: 8-bit BGR; pixel = pixel_from_plate * (x, y, 1). More than half of the disc must be
/// bare.
PlateMap mapPlate(const cv::Mat& picture, const Eigen::Matrix3d& pixel_from_plate,
                  double radius_mm);

/// Pieces of one map or of the votes of several.
struct MapPiece {
  std::vector<cv::Point> outline;  ///< pixels of the map, closed
  double extent_mm = 0;            ///< the longer side of its box
  double area_mm2 = 0;
  Eigen::Vector2d centre_mm{0, 0};
  bool cut_off = false;  ///< reaches what the picture does not show
};
std::vector<MapPiece> piecesOf(const PlateMap& map, double smallest_mm);

/// The shortest way between two outlines, mm; beyond 15 mm only that between their boxes.
double gapBetween_mm(const MapPiece& a, const MapPiece& b);

/// Sherds that one piece holds when they touch: it is cut where its outline has a narrow neck.
int sherdsInPiece(const MapPiece& piece);

/// Two notches with a way from one to the other that would cut the piece into two sherds, as where
/// two lie side by side.
bool hasOppositeNotches(const MapPiece& piece);

/// Worth a person's look: a waist as a single sherd rarely has one, a dent as deep, or
/// opposite notches. Never counted on.
bool mayBeSeveral(const MapPiece& piece);

/// inspectPlate with the map that it counted on; an empty map where the plate's place is not seen.
struct MappedInspection {
  PlateInspection inspection;
  PlateMap map;
};
Result<MappedInspection> inspectAndMap(std::string_view picture, const batch::Plate& plate,
                                       const InspectionOptions& options);

/// A photograph of a side; without an inspection it is read from its file.
struct SidePhotograph {
  std::filesystem::path file;
  std::shared_ptr<const MappedInspection> inspection;
};
/// As checkSide of shot_checks.h, without looking again at what was looked at.
SideCheck checkSide(const std::vector<std::vector<SidePhotograph>>& photographs,
                    const batch::Plate& plate, const InspectionOptions& options,
                    std::stop_token stop);

}  // namespace ostraka::capture
