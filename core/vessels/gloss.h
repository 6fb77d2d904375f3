#pragma once
#include <Eigen/Core>

#include "vessels/noise.h"

namespace ostraka::vessels {

/// A shiny layer: how much of the Fresnel reflection of glass it has, and how rough it is.
struct Gloss {
  float weight = 0;        ///< 0 matte, 1 as glass
  float roughness = 0.3f;  ///< GGX's alpha
};

/// Share of light that the layer reflects where it meets this cosine.
float fresnel(float cosine);

/// The direction that a mirror sends the eye's (unit) to.
inline Eigen::Vector3f mirrored(const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye) {
  return 2 * normal.dot(to_eye) * normal - to_eye;
}
/// The mirrored ray's direction, strewn as the roughness does; never into the surface.
Eigen::Vector3f strewnReflection(const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye,
                                 const Gloss& gloss, std::uint64_t hash);

}  // namespace ostraka::vessels
