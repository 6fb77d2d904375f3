#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "cloud/nearest.h"
#include "cloud/point_cloud.h"
#include "scan/boundary.h"
#include "scan/scan.h"

namespace ostraka::registration {

using scan::SilhouetteView;

/// What BBICP takes for the boundary of a scan.
enum class Boundary {
  Strip,  ///< the lowest points of the fracture strip
  Paper   ///< scan::findBoundary, by masks and neighbours, as in the paper
};
/// As options name them: "strip", "paper".
const std::map<std::string, Boundary>& boundariesByName();

struct StripOptions {
  double normal_radius_mm = 0.9;  ///< normals are averaged this far: two or three scan spacings
  double coarse_mm = 1.2;         ///< spacing of the first rounds: a third of the thinnest wall
  double max_up = 0.85;  ///< points whose normal leans more than this towards the viewer are face:
                         ///< the other side's views stop at 75 degrees of incidence
  Boundary boundary = Boundary::Strip;
};

/// What a point's colour differs from its surroundings, in SDs of each of three channels, and how
/// fast that changes along the surface (row c: gradient of channel c, per mm, frame of the scan).
struct ColourDetail {
  Eigen::Vector3f value = Eigen::Vector3f::Zero();
  Eigen::Matrix3f slope = Eigen::Matrix3f::Zero();
};

/// Points of one level of detail that the other side can have seen, with a tree over them.
struct StripLevel {
  std::vector<Eigen::Vector3f> points;   ///< mm, frame of the scan
  std::vector<Eigen::Vector3f> normals;  ///< unit, outward, averaged over neighbours
  std::vector<float> weights;            ///< 0..1, lower in the lowest, fattest band
  std::vector<ColourDetail> colours;     ///< as long as points, or empty: no colours
  KdTree tree{{}};
};

/// A scan made ready to be registered, once for all its pairs.
struct Strip {
  StripLevel coarse, fine;
  std::vector<Eigen::Vector3f> boundary;  ///< where the scan ends: what BBICP fits
  std::vector<Eigen::Vector3f> all;       ///< every point of the scan, for its outline
  std::vector<Eigen::Vector3f> shell;  ///< whole scan thinned and smoothed, for rest and crossing
  std::vector<Eigen::Vector3f> shell_normals;
  std::vector<std::uint8_t> shell_inside;  ///< 1 = all around is scanned face, not near the strip
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();     ///< towards the viewer, frame of the scan
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< mean of the shell, mm
  double radius_mm = 0;                              ///< RMS distance of the shell from the centre
  double noise_mm = 0;    ///< robust SD of the strip's points about their neighbours' planes
  double spacing_mm = 0;  ///< median distance of neighbours
};

/// views: of the scan's own side, in its frame; asked by Boundary::Paper alone, which does without
/// where there are none. Errors: NotEnough (fewer than 50 points on the strip, or no normals).
/// O(n log n), ~20 ms.
Result<Strip> prepareStrip(const scan::Scan& scan, const StripOptions& options,
                           std::span<const SilhouetteView> views = {});

/// The strip of the same scan with all lengths multiplied.
Strip scaled(const Strip& strip, double factor);

}  // namespace ostraka::registration
