#include "vessels/gloss.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ostraka::vessels {
namespace {

constexpr float kGlass = 0.04f;  // reflected at right angles, refractive index 1.5

}  // namespace

float fresnel(float cosine) {
  const float c = 1 - std::clamp(cosine, 0.f, 1.f);
  return kGlass + (1 - kGlass) * c * c * c * c * c;
}

Eigen::Vector3f strewnReflection(const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye,
                                 const Gloss& gloss, std::uint64_t hash) {
  const std::uint64_t other = mixed(hash, 77);
  const auto u = static_cast<float>(hash & 0xFFFF) / 65536.f;
  const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(other & 0xFFFF) / 65536.f;
  const float slope = gloss.roughness * std::sqrt(u / (1.01f - u));
  const Eigen::Vector3f side = normal.unitOrthogonal(), up = normal.cross(side);
  const Eigen::Vector3f facet =
      (normal + std::min(slope, 1.5f) * (std::cos(angle) * side + std::sin(angle) * up))
          .normalized();
  const Eigen::Vector3f ray = mirrored(facet, to_eye);
  return ray.dot(normal) > 0.02f ? ray : mirrored(normal, to_eye);
}

}  // namespace ostraka::vessels
