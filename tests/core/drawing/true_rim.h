#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "vessels/noise.h"
#include "vessels/sherd.h"
#include "vessels/vessel.h"

namespace ostraka::drawing {

/// A virtual sherd and what is true of its vessel's mouth.
struct TrueSherdOfVessel {
  vessels::VirtualSherd sherd;
  double diameter_mm = 0;  ///< of the circle of the lip's highest points
  double kept = 0;         ///< share of that circle on the sherd; 0 without a lip
};

/// A sherd of a vessel drawn by chance. noise_mm: standard deviation put on each vertex.
inline TrueSherdOfVessel trueSherd(vessels::SherdPart part, std::uint64_t seed, double noise_mm) {
  vessels::Random random(vessels::mixed(seed, 77));
  const auto form = static_cast<vessels::VesselForm>(random.below(3));
  vessels::Random vessel_random(vessels::mixed(seed, 78));
  const vessels::Vessel vessel =
      vessels::Vessel::make(form, random.uniform(3.6, 8.2), vessel_random);
  vessels::BreakPlan plan;
  plan.part = part;
  plan.radius_mm = random.uniform(16, 40);
  if (form == vessels::VesselForm::Jug) plan.radius_mm = std::min(plan.radius_mm, 30.0);
  const double reach = 1.35 * plan.radius_mm;
  plan.s_mm = part == vessels::SherdPart::Rim
                  ? vessel.length() - plan.radius_mm * random.uniform(0.35, 0.7)
                  : std::max(vessel.heel() + reach,
                             random.uniform(vessel.heel() + reach, vessel.length() - reach - 3));
  plan.relief_mm = random.uniform(0.15, 0.35);
  plan.tilt_rad = random.uniform(0.25, 0.5);
  plan.outline_seed = random.next();
  plan.relief_seed = random.next();
  TrueSherdOfVessel out{vessels::breakOut(vessel, plan), 0, 0};
  // The lip's vertices carry their place on the vessel: they are put there again.
  std::map<int, Eigen::Vector2d> highest;  // by half degree: radius, height
  double low = 1e9, high = -1e9;
  for (const vessels::ClayPlace& place : out.sherd.places) {
    if (part != vessels::SherdPart::Rim || place.broken > 0 || place.depth < 0.05f ||
        place.depth > 0.95f)
      continue;
    const double theta = place.around_mm / 60, s = place.up_mm;
    const Eigen::Vector3d outer = vessel.outer(s, theta);
    const Eigen::Vector3d p = outer + place.depth * (vessel.inner(s, theta) - outer);
    Eigen::Vector2d& top =
        highest.try_emplace(static_cast<int>(std::floor(theta * 360 / std::numbers::pi)), 0.0, -1e9)
            .first->second;
    if (p.z() > top.y()) top = Eigen::Vector2d(p.head<2>().norm(), p.z());
    low = std::min(low, theta);
    high = std::max(high, theta);
  }
  for (const auto& [bin, top] : highest)
    out.diameter_mm += 2 * top.x() / static_cast<double>(highest.size());
  if (high > low) out.kept = (high - low) / (2 * std::numbers::pi);
  vessels::Random noise(vessels::mixed(seed, 79));
  for (Eigen::Vector3f& v : out.sherd.mesh.vertices)
    for (int k = 0; k < 3; ++k) v[k] += static_cast<float>(noise_mm * noise.normal());
  return out;
}

}  // namespace ostraka::drawing
