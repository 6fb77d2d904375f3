#pragma once
#include <Eigen/Geometry>
#include <optional>

#include "drawing/rim_arc.h"
#include "drawing/walls.h"

namespace ostraka::drawing {

/// Wider mouths are not looked for: pithoi and dolia, the largest vessels, open about a metre wide.
constexpr double kWidestMouth_mm = 1500;

/// Of RimEstimate::probability; below it the stretch is rather a break, and its arc says nothing.
constexpr double kLikelyLip = 0.5;

/// What a sherd tells about the mouth of its vessel. The rim is the circle on which the lip's
/// highest points lie when the vessel stands upright.
struct RimEstimate {
  /// That the sherd has a piece of the rim at all; to be shown, never to be decided by silently.
  double probability = 0;
  double diameter_mm = 0;
  double low_mm = 0, high_mm = 0;  ///< 95 %; 20 to infinite where a break is likelier than a lip
  double kept = 0;                 ///< share of the circumference
  double kept_low = 0, kept_high = 0;
  double arc_mm = 0;          ///< length of the piece of the rim
  double lip_scatter_mm = 0;  ///< of the lip's surface about one profile turned around the axis
  double smoother = 0;        ///< logarithm of how much smoother the lip is than the edge elsewhere
  double residual_mm = 0;     ///< median distance of walls and lip from surfaces of revolution
  /// z is the vessel's axis, up; z = 0 the rim's plane; the sherd's middle lies at +x.
  Eigen::Isometry3d vessel_from_model = Eigen::Isometry3d::Identity();

  /// Whether diameter and share may be stated: the interval is bounded on both sides, within what
  /// vessels are. Otherwise the lip's sagitta is not above its scatter, or the lip rather a break.
  bool saysDiameter() const;
};

/// Axis and mouth from a sherd with this stretch of lip: walls and lip are brought onto surfaces of
/// revolution about one axis (robust least squares over the axis' four parameters, profiles free),
/// the interval by clusters of residuals, plus 1 % for mouths that are not round. Nothing when
/// fewer than 100 wall points are known or nothing converges.
std::optional<RimEstimate> estimateRim(const Walls& walls, const RimArc& arc);
/// The likeliest of all stretches of the edge; nothing where none can be a lip.
std::optional<RimEstimate> findRim(const Walls& walls);

}  // namespace ostraka::drawing
