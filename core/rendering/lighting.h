#pragma once
#include <array>
#include <vector>

#include "rendering/scene.h"
#include "vessels/noise.h"

namespace ostraka::rendering {

inline constexpr int kLights = 3;

/// What sherds lie on, seen from above: its colour sends light back to them.
class Ground {
 public:
  virtual ~Ground() = default;
  /// Linear albedo around a point, without its fine pattern.
  virtual Eigen::Vector3f meanAlbedo(const Eigen::Vector2f& p) const = 0;
};

/// A rectangular light that looks at the plate's middle. Lighting frame: the plate's at stop 0.
struct Light {
  Eigen::Vector3d centre, half_u, half_v;
  /// Irradiance that it gives an element facing it at the plate's middle.
  Eigen::Vector3f strength = Eigen::Vector3f::Zero();
  float radius = 0.2f;  ///< sine of its angular radius: it sets over a horizon of twice that
  bool hard = false;    ///< small or far: its shadows have edges, cast anew for each look
};
struct Lighting {
  std::array<Light, kLights> lights;
  Eigen::Vector3f sky;     ///< irradiance from everywhere else on an open horizontal element
  int ground_mm = 165;     ///< half the side of the ground whose light is known in detail
  float shadow_reach = 3;  ///< length of the longest shadows, in heights of what casts them
};
/// A light of this width and height at a distance, mm, turned towards the plate's middle.
Light softbox(double azimuth_rad, double elevation_rad, double distance, double half_width,
              double half_height, const Eigen::Vector3f& strength);
Lighting makeLighting(vessels::Random& random);
/// The room turned against the plate, so that shadows stay with the lamps: plate_from_room.
Lighting turned(const Lighting& lighting, double plate_angle_rad);

/// Shares of each light that points see, at each vertex and on a grid of the plate.
struct LightField {
  using Shares = std::array<float, kLights>;
  std::vector<std::vector<Shares>> vertices;  ///< by sherd and vertex
  std::vector<Shares> plate;  ///< a square of 1 mm cells around the middle, row by row
};
/// Light that comes from the sky and by one reflection; it does not depend on the stop.
struct AmbientField {
  std::vector<std::vector<Eigen::Vector3f>> vertices;  ///< irradiance
  std::vector<Eigen::Vector3f> plate;
};

/// Hard lights count as seen: `seesLight` tells.
LightField castShadows(const Scene& scene, const Lighting& room_plate, std::uint64_t seed,
                       int threads);

struct AmbientOptions {
  bool turning = true;  ///< the plate turns in the room: lamps are averaged over its turns
  int side = 6;         ///< side x side directions at each vertex of a sherd
  int ground_side = 6;  ///< the same at each cell of the ground; white paper shows their noise
  int threads = 0;
};
AmbientField gatherAmbient(const Scene& scene, const Lighting& lighting, const Ground& ground,
                           std::uint64_t seed, const AmbientOptions& options);

/// Whether p sees a light at a place of it that the hash chooses. p lies off its own surface.
bool seesLight(const Scene& scene, const Light& light, const Eigen::Vector3f& p,
               std::uint64_t hash);

/// Irradiance on an element with this unit normal, from lights of which it sees these shares.
Eigen::Vector3f directLight(const Lighting& room_plate, const Eigen::Vector3f& p,
                            const Eigen::Vector3f& normal, const LightField::Shares& shares);
/// Both fields of the plate at a point, between the grid's points.
void plateLight(const LightField& field, const AmbientField& ambient, const Eigen::Vector2f& p,
                LightField::Shares& shares, Eigen::Vector3f& irradiance);

}  // namespace ostraka::rendering
