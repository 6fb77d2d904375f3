#pragma once
#include <opencv2/core/mat.hpp>

#include "ground/plate_picture.h"

namespace ostraka::ground {

/// Correlation of the empty photograph with a stop's own marker ring: tells whether the plate stood
/// at that stop when it was taken.
struct RingAgreement {
  double whole = 0;
  double typical = 0;  ///< median over pieces of the ring: a cloth on some markers leaves it high
};

/// empty: log colours of the empty photograph; look: of the stop; paper: markerPaper.
RingAgreement ringAgreement(const cv::Mat3f& empty, const PlateLook& look, const cv::Mat1b& paper);

}  // namespace ostraka::ground
