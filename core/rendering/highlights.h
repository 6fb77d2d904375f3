#pragma once
#include "rendering/lighting.h"
#include "vessels/gloss.h"

namespace ostraka::rendering {

/// Reflections of the lights, of which p sees these shares, in the direction of the eye (unit).
/// In the same unit as albedo times irradiance. GGX (Walter et al. 2007) with the light's nearest
/// point to the mirrored ray in place of the whole light (Karis 2013).
Eigen::Vector3f highlights(const Lighting& room_plate, const Eigen::Vector3f& p,
                           const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye,
                           const LightField::Shares& shares, const vessels::Gloss& gloss);

}  // namespace ostraka::rendering
