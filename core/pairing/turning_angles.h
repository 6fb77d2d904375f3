#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/result.h"

namespace ostraka::pairing {

/// Turning angles at n equal steps of arc length, radians, counter-clockwise positive, summing to
/// 2 pi. contour: closed, simple, counter-clockwise, mm. Errors: NotEnough for fewer than 3 points.
Result<std::vector<double>> turningAngles(std::span<const Eigen::Vector2d> contour, int n);

/// Sums of the angles from start point `shift`: out[i] = angles[shift] + ... + angles[shift + i].
std::vector<double> accumulated(std::span<const double> angles, int shift);

/// Root mean square difference of accumulated turning angles, radians, for each start point of b,
/// minimised over a constant turn when `free_offset`. Both of length n; O(n^2).
enum class Offset { None, Free };
std::vector<double> shiftCosts(std::span<const double> a, std::span<const double> b, Offset offset);

}  // namespace ostraka::pairing
