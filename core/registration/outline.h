#pragma once
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "registration/evidence.h"

namespace ostraka::registration {

/// How much of each cell's surroundings is covered, 0..1; cell (x, y) has its centre at
/// origin + cell * (x, y).
struct Coverage {
  cv::Mat1f picture;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double cell = 1;

  /// Bilinear; 0 outside.
  double at(const Eigen::Vector2d& p) const;
};
/// Cells with a point count as covered, then the picture is blurred (Gaussian, SD `blur`). Empty
/// for fewer than 10 points or a picture above 4096 cells a side.
Coverage coverageOf(std::span<const Eigen::Vector2f> points, double cell, double blur);

/// Where a coverage falls through a half: about one point per cell, with outward unit normals.
struct Outline {
  std::vector<Eigen::Vector2d> points, normals;
};
Outline outlineOf(const Coverage& coverage);

struct OutlineFit {
  Evidence evidence;
  double sigma_mm = 0;  ///< robust SD of the misfit about its median
  int pairs = 0;
};

/// Both sides of a sherd end, seen along one direction, at the same outermost line, however little
/// of the strip each of them shows. Says nothing of height. What is alike all around (fatness,
/// walls that slant evenly) is taken out.
OutlineFit fitOutlines(std::span<const Eigen::Vector3f> front,
                       std::span<const Eigen::Vector3f> back, double spacing_mm,
                       const Eigen::Isometry3d& front_from_back, const Eigen::Vector3d& up,
                       const Eigen::Vector3d& pivot);

/// A signed misfit and its derivative; both in one unit.
struct OutlineMatch {
  double residual;
  Vector6 row;
};
/// Robust evidence of matches after their median is taken out; `independent` is the share of them
/// that carries news. The SD is learnt from the matches, at least min_sigma.
OutlineFit weigh(std::span<const OutlineMatch> matches, double min_sigma, double independent);

}  // namespace ostraka::registration
