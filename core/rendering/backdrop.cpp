#include "rendering/backdrop.h"

#include <Eigen/Geometry>
#include <cmath>

namespace ostraka::rendering {
namespace {

constexpr float kTable = -70, kPlateThickness = 14;  // mm: the table's height, the plate's side

}  // namespace

float handShare(const Hand& hand, const Eigen::Vector3f& p) {
  if (!hand) return 1;
  const float d = (p.head<2>() - *hand).norm();
  return 1 - 0.8f / (1 + std::exp((d - 45) / 8));  // a soft edge of some 30 mm
}

PlateBackdrop::PlateBackdrop(const Lighting& room_plate, const LightField& light,
                             const AmbientField& ambient, const PlateSurface& plate,
                             double plate_angle_rad, const Hand& hand)
    : lighting_(room_plate),
      light_(light),
      ambient_(ambient),
      plate_(plate),
      room_turn_(Eigen::Rotation2Df(static_cast<float>(plate_angle_rad)).toRotationMatrix()),
      hand_(hand) {}

bool PlateBackdrop::even(const Ray& r) const {
  const Eigen::Vector3f p = r.origin - r.origin.z() / r.direction.z() * r.direction;
  const float radius = p.head<2>().norm();
  return r.direction.z() > 0 || radius < PlateSurface::kRingInner ||
         radius > PlateSurface::kRadius + 18;
}

Eigen::Vector3f PlateBackdrop::light(const Ray& r, std::uint64_t) const {
  if (r.direction.z() < 0) {
    const Eigen::Vector3f p = r.origin - r.origin.z() / r.direction.z() * r.direction;
    if (p.head<2>().squaredNorm() < PlateSurface::kRadius * PlateSurface::kRadius) return top(p);
  }
  const float a = r.direction.head<2>().squaredNorm(),
              b = r.origin.head<2>().dot(r.direction.head<2>());
  const float c = r.origin.head<2>().squaredNorm() - PlateSurface::kRadius * PlateSurface::kRadius;
  const float root = b * b - a * c;
  if (root > 0) {
    const Eigen::Vector3f p = r.origin + (-b - std::sqrt(root)) / a * r.direction;
    if (p.z() <= 0 && p.z() > -kPlateThickness) {
      const Eigen::Vector3f out(p.x() / PlateSurface::kRadius, p.y() / PlateSurface::kRadius, 0);
      return plate_.felt().cwiseProduct(0.4f * lighting_.sky +
                                        directLight(lighting_, p, out, {1, 1, 1})) *
             0.6f;
    }
  }
  if (r.direction.z() >= 0) return Eigen::Vector3f::Constant(0.008f);
  return table(r.origin + (kTable - r.origin.z()) / r.direction.z() * r.direction);
}

Eigen::Vector3f PlateBackdrop::top(const Eigen::Vector3f& p) const {
  LightField::Shares shares;
  Eigen::Vector3f irradiance;
  plateLight(light_, ambient_, p.head<2>(), shares, irradiance);
  irradiance += directLight(lighting_, p, Eigen::Vector3f::UnitZ(), shares);
  return plate_.albedo(p.head<2>()).cwiseProduct(irradiance) * handShare(hand_, p);
}

// A dark cloth in the plate's wide shadow; it stays with the room.
Eigen::Vector3f PlateBackdrop::table(const Eigen::Vector3f& p) const {
  const float radius = p.head<2>().norm();
  const float open = 1 / (1 + std::exp((PlateSurface::kRadius + 15 - radius) / 35));
  const Eigen::Vector2f q = room_turn_ * p.head<2>();
  const float folds = 1 + 0.3f * vessels::fractalNoise({q.x() / 40, q.y() / 40, 7}, 77, 3);
  return Eigen::Vector3f(0.0145f, 0.0142f, 0.0148f) * ((0.15f + 0.85f * open) * folds);
}

}  // namespace ostraka::rendering
