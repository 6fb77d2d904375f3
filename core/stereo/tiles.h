#pragma once
#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "stereo/hull.h"

namespace ostraka::stereo {

/// A part of the object that is matched and fused by itself.
struct Tile {
  /// Plate frame, mm. Every place belongs to one tile.
  Eigen::AlignedBox3f own;
  /// The same with what lies around it, on which windows and neighbourhoods near its border rest.
  Eigen::AlignedBox3f reach;
  Eigen::Vector3f middle;       ///< of the cubes within reach
  std::vector<cv::Rect> parts;  ///< of each view, as of StraightPart; empty: not in sight

  bool owns(const Eigen::Vector3f& p_plate) const;
};

/// The object in as few tiles as show no more pixels each than given, all views together. It is
/// halved where a plane cuts the fewest of the hull's cubes: between sherds where it can. Smaller
/// than three times what lies around it no tile gets. outlines: `shrink` pixels of the full size in
/// one, along each side; wholes: the parts that they show.
std::vector<Tile> tilesOf(const Hull& hull, std::span<const Frame* const> outlines, int shrink,
                          std::span<const cv::Rect> wholes, double most_pixels);

}  // namespace ostraka::stereo
