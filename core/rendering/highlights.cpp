#include "rendering/highlights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ostraka::rendering {
namespace {

// Of the light's rectangle, what lies nearest to the ray from p.
Eigen::Vector3f nearestPoint(const Light& light, const Eigen::Vector3f& p,
                             const Eigen::Vector3f& ray) {
  const Eigen::Vector3f centre = light.centre.cast<float>(), u = light.half_u.cast<float>(),
                        v = light.half_v.cast<float>();
  const Eigen::Vector3f facing = u.cross(v);
  const float towards = ray.dot(facing);
  Eigen::Vector3f q = centre;
  const float t = (centre - p).dot(facing) / (std::abs(towards) > 1e-9f ? towards : 1e-9f);
  if (t > 0)
    q = p + t * ray;
  else
    q = p + (centre - p).norm() * ray;  // the ray goes past it: the nearest edge
  const Eigen::Vector3f off = q - centre;
  return centre + std::clamp(off.dot(u) / u.squaredNorm(), -1.f, 1.f) * u +
         std::clamp(off.dot(v) / v.squaredNorm(), -1.f, 1.f) * v;
}

}  // namespace

Eigen::Vector3f highlights(const Lighting& lighting, const Eigen::Vector3f& p,
                           const Eigen::Vector3f& normal, const Eigen::Vector3f& to_eye,
                           const LightField::Shares& shares, const vessels::Gloss& gloss) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  const float nv = normal.dot(to_eye);
  if (gloss.weight <= 0 || nv <= 0.01f) return sum;
  const Eigen::Vector3f ray = vessels::mirrored(normal, to_eye);
  for (int l = 0; l < kLights; ++l) {
    const Light& light = lighting.lights[l];
    if (shares[l] == 0 || light.strength.isZero()) continue;
    const Eigen::Vector3f to = nearestPoint(light, p, ray) - p;
    const Eigen::Vector3f towards = to.normalized();
    const float nl = normal.dot(towards);
    if (nl <= 0.01f) continue;
    const Eigen::Vector3f half = (towards + to_eye).normalized();
    const float nh = normal.dot(half), vh = to_eye.dot(half);
    const Eigen::Vector3f centre = light.centre.cast<float>();
    const float distance2 = (centre - p).squaredNorm();
    const auto half_area = static_cast<float>(light.half_u.norm() * light.half_v.norm());
    const float a = gloss.roughness, wide = std::min(1.f, a + std::sqrt(half_area / distance2) / 3);
    const float slope = nh * nh * (wide * wide - 1) + 1;
    const float density = a * a / (std::numbers::pi_v<float> * slope * slope);
    const float k = a / 2;
    const float shading = 1 / (4 * (nl * (1 - k) + k) * (nv * (1 - k) + k));
    const float lobe = std::numbers::pi_v<float> * density * shading * nl;
    // No brighter than the light itself, of which a mirror shows pi / solid angle.
    const float mirror = std::numbers::pi_v<float> * distance2 / (4 * half_area);
    sum += light.strength * (gloss.weight * shares[l] * centre.squaredNorm() / distance2 *
                             vessels::fresnel(vh) * std::min(lobe, mirror));
  }
  return sum;
}

}  // namespace ostraka::rendering
