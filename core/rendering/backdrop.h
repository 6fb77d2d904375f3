#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "rendering/lighting.h"
#include "rendering/plate_surface.h"

namespace ostraka::rendering {

/// Of a look into the scene: plate frame, mm; the direction is not a unit vector.
struct Ray {
  Eigen::Vector3f origin, direction;
};

/// A hand above the plate that keeps the light off around here (plate frame, mm).
using Hand = std::optional<Eigen::Vector2f>;
/// Share of the light that a hand lets through.
float handShare(const Hand& hand, const Eigen::Vector3f& p);

/// What is seen where no sherd is.
class Backdrop {
 public:
  virtual ~Backdrop() = default;
  /// hash: of this look, for what is left to chance.
  virtual Eigen::Vector3f light(const Ray& ray, std::uint64_t hash) const = 0;
  /// No edge, print or fine pattern lies near: one look a pixel is enough.
  virtual bool even(const Ray& ray) const = 0;
};

/// The marker plate, turned by an angle, above a table with a dark cloth.
class PlateBackdrop final : public Backdrop {
 public:
  PlateBackdrop(const Lighting& room_plate, const LightField& light, const AmbientField& ambient,
                const PlateSurface& plate, double plate_angle_rad, const Hand& hand = {});
  Eigen::Vector3f light(const Ray& ray, std::uint64_t hash) const override;
  bool even(const Ray& ray) const override;

 private:
  Eigen::Vector3f top(const Eigen::Vector3f& p) const;
  Eigen::Vector3f table(const Eigen::Vector3f& p) const;

  const Lighting& lighting_;
  const LightField& light_;
  const AmbientField& ambient_;
  const PlateSurface& plate_;
  Eigen::Matrix2f room_turn_;
  Hand hand_;
};

}  // namespace ostraka::rendering
