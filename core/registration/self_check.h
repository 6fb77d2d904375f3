#pragma once
#include <Eigen/Geometry>

#include "registration/register_sides.h"
#include "registration/strip.h"

namespace ostraka::registration {

/// Above it a pose is loose: two of them are the 0.40 mm that must not pass.
inline constexpr double kLargestUncertaintyMm = 0.20;
/// So much farther away another pose is a rival, unless it is 7 times less likely (logarithm).
inline constexpr double kRivalMm = 0.40, kRivalGap = 2.0;

/// How the two faces lie to each other, measured along the mean of the two viewing directions.
struct Thickness {
  double median_mm = 0;
  double crossing_share = 0;  ///< of the front's face points with the back's face above them
  int compared = 0;
};
Thickness thicknessOf(const Strip& front, const Strip& back,
                      const Eigen::Isometry3d& front_from_back);

/// Log-likelihood ratio of the fractures' RMS: one break, against two breaks with outlines as alike
/// as near-duplicates' (their relief differs by 0.15 mm RMS a side and their RMS is 0.24 mm and
/// more, while true pairs on clean scans stay below 0.17). noise_mm: SD of the strips' own points,
/// both sides together.
double fractureLogLikelihood(double fracture_rms_mm, double noise_mm, int pairs);

/// Sets check_failed and reason from the figures already in `found`. A sentence for a person.
void checkRegistration(const Strip& front, const Strip& back, Registration& found);

}  // namespace ostraka::registration
