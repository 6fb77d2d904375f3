#pragma once
#include <Eigen/Core>

#include "model/indicator.h"
#include "model/point_bins.h"
#include "model/surfels.h"

namespace ostraka::model {

/// What the surface is near a place.
struct FieldSample {
  float distance = 0;                                  ///< mm, positive outside
  Eigen::Vector3f gradient = Eigen::Vector3f::Zero();  ///< unit, outward; zero without support
  float support = 0;  ///< 0 where no surfel is near, about 1 on a well-sampled surface
};

/// The sherd's surface as the zero set of a signed distance: robust implicit moving least squares
/// near surfels (Oeztireli, Guennebaud, Gross, Eurographics 2009: neighbours behind a crease lose
/// their say round by round), the indicator's level where there are none, both blended between.
class SurfaceField {
 public:
  /// Keeps references to both.
  SurfaceField(const Surfels& surfels, const Grid& indicator);
  FieldSample sample(const Eigen::Vector3f& p) const;
  /// From the indicator alone, mm, positive outside; its scale is rough.
  float farDistance(const Eigen::Vector3f& p) const;
  float radius_mm() const { return radius_; }

 private:
  const Surfels& surfels_;
  const Grid& indicator_;
  float radius_;
  float full_support_;
  PointBins bins_;
};

}  // namespace ostraka::model
