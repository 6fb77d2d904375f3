#pragma once
#include <Eigen/Core>
#include <span>

#include "rig/camera.h"

namespace ostraka::review {

/// The width of a pixel, mm, of pictures in which a person compares sherds: that of the photograph
/// where it shows these points (plate frame, at least one), so that nothing of it is blurred, but
/// no less than a picture of 600,000 pixels needs, and never more than 0.15 mm.
double picturePixel_mm(const rig::PosedImage& photograph, std::span<const Eigen::Vector3f> points);
inline constexpr double kWidestPicturePixel_mm = 0.15;

}  // namespace ostraka::review
