#include "rendering/sheet_backdrop.h"

#include "rendering/highlights.h"

#include <algorithm>
#include <cmath>

namespace ostraka::rendering {
namespace {

constexpr float kFloor = -740;      // mm: a table's height
constexpr float kPaper_mm = 0.12f;  // thickness

const vessels::Gloss kToner{0.6f, 0.34f};  // laser print shines a little

Eigen::Vector3f at(const Ray& r, float z) {
  return r.origin + (z - r.origin.z()) / r.direction.z() * r.direction;
}

}  // namespace

SheetBackdrop::SheetBackdrop(const Scene& scene, const Lighting& lighting, const LightField& light,
                             const AmbientField& ambient, const SheetSurface& sheet,
                             const TableSurface& table)
    : scene_(scene),
      lighting_(lighting),
      light_(light),
      ambient_(ambient),
      sheet_(sheet),
      table_(table) {
  for (const Light& l : lighting.lights) hard_ = hard_ || (l.hard && !l.strength.isZero());
}

bool SheetBackdrop::even(const Ray& r) const {
  if (r.direction.z() >= 0) return true;
  const Eigen::Vector2f p = at(r, 0).head<2>();
  return !hard_ && sheet_.blank(p);
}

bool SheetBackdrop::onSheet(const Ray& r, Eigen::Vector3f& p) const {
  float z = 0;
  for (int round = 0; round < 4; ++round) {  // slopes are small: each round gains two digits
    p = at(r, z);
    z = sheet_.height(p.head<2>());
  }
  return sheet_.holds(p.head<2>());
}

Eigen::Vector3f SheetBackdrop::lit(const Eigen::Vector3f& p, const Eigen::Vector3f& normal,
                                   const Ray& r, const Eigen::Vector3f& albedo,
                                   const vessels::Gloss& gloss, std::uint64_t hash) const {
  LightField::Shares shares;
  Eigen::Vector3f irradiance;
  plateLight(light_, ambient_, p.head<2>(), shares, irradiance);
  if (hard_)
    for (int l = 0; l < kLights; ++l)
      if (lighting_.lights[l].hard && !lighting_.lights[l].strength.isZero())
        shares[l] = seesLight(scene_, lighting_.lights[l], p + kLift * normal,
                              vessels::mixed(hash, static_cast<std::uint64_t>(l)));
  Eigen::Vector3f light =
      albedo.cwiseProduct(irradiance + directLight(lighting_, p, normal, shares));
  if (gloss.weight <= 0) return light;
  const Eigen::Vector3f to_eye = -r.direction.normalized();
  return light + highlights(lighting_, p, normal, to_eye, shares, gloss) +
         gloss.weight * vessels::fresnel(normal.dot(to_eye)) * 0.6f * lighting_.sky;
}

Eigen::Vector3f SheetBackdrop::light(const Ray& r, std::uint64_t hash) const {
  if (r.direction.z() >= 0) return beyond(r);
  Eigen::Vector3f p;
  if (onSheet(r, p)) {
    const Eigen::Vector2f slope = sheet_.slope(p.head<2>());
    const Eigen::Vector3f normal = Eigen::Vector3f(-slope.x(), -slope.y(), 1).normalized();
    const Eigen::Vector3f albedo = sheet_.albedo(p.head<2>());
    return lit(p, normal, r, albedo, albedo.y() < 0.2f ? kToner : vessels::Gloss{}, hash);
  }
  p = at(r, 0);
  if (!table_.holds(p.head<2>())) return beyond(r);
  // Little light comes in beside the paper's edge and under it, less the higher it stands.
  const Eigen::Vector2f edge =
      p.head<2>().cwiseAbs().cwiseMin(sheet_.plate().sheet->max().cast<float>());
  const float rise = kPaper_mm + sheet_.height(edge.cwiseProduct(p.head<2>().cwiseSign()));
  const float beside = std::max(0.f, sheet_.distance(p.head<2>()));
  const float open = 1 - 0.6f * std::exp(-beside / (1.5f * rise));
  return open *
         lit(p, Eigen::Vector3f::UnitZ(), r, table_.albedo(p.head<2>()), table_.gloss(), hash);
}

// The floor under a table is darker, and the wall is lit by the room.
Eigen::Vector3f SheetBackdrop::beyond(const Ray& r) const {
  const Eigen::Vector3f open =
      lighting_.sky +
      0.5f * directLight(lighting_, Eigen::Vector3f(0, 0, 0), Eigen::Vector3f::UnitZ(), {1, 1, 1});
  const float steep = -r.direction.z() / r.direction.norm();
  if (steep <= 0.12f) return table_.wall().cwiseProduct(open) * 0.8f;
  const Eigen::Vector3f p = at(r, kFloor);
  const float far = p.head<2>().norm();
  const float lit = 0.35f + 0.65f / (1 + std::exp((700 - far) / 150));
  if (far > 2500) return table_.wall().cwiseProduct(open) * 0.8f;
  return table_.floor(p.head<2>()).cwiseProduct(open) * (0.8f * lit);
}

}  // namespace ostraka::rendering
