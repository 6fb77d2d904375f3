#pragma once
#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>

#include "base/result.h"
#include "cloud/points_and_meshes.h"
#include "colour/ciede2000.h"

namespace ostraka::colour {

/// A value for each patch of a ColorChecker Classic, row by row from dark skin to black.
template <class T>
using Patches = std::array<T, 24>;

/// What the patches are: X-Rite's 'November 2014 edition and newer', D50.
const Patches<Lab>& referenceLab();

/// From the colours as photographed to those that the chart's maker states.
struct Correction {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();  ///< of linear RGB
  double median = 0, within_95 = 0;  ///< CIEDE2000 that the patches are still off by

  Color of(const Color& colour) const;
  /// BGR, sRGB.
  cv::Mat3b of(const cv::Mat3b& picture) const;
};

/// A chart in a photograph.
struct Chart {
  Patches<Eigen::Vector3d> light;  ///< linear RGB, 0 to 1, median over each patch
  int clipped = 0;                 ///< patches with a channel at 255, or all at 0
};

/// By robust least squares. What is left says how well a matrix can explain the chart.
Correction fitted(const Patches<Eigen::Vector3d>& light);

/// The same for a chart that may be used. Errors: NotEnough, which say why it cannot be.
Result<Correction> correctionBy(const Chart& chart);

}  // namespace ostraka::colour
