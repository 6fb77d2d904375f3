#pragma once
#include <array>
#include <stop_token>
#include <vector>

#include "virtualrig/plate_surface.h"
#include "virtualrig/scene.h"

namespace ostraka::virtualrig {

inline constexpr int kLights = 3;

/// A rectangular softbox that looks at the plate's middle. Room frame: the plate's at stop 0.
struct Light {
  Eigen::Vector3d centre, half_u, half_v;
  Eigen::Vector3f
      strength;  ///< irradiance that it gives an element facing it at the plate's middle
};
struct Room {
  std::array<Light, kLights> lights;
  Eigen::Vector3f sky;  ///< irradiance from everywhere else on an open horizontal element
};
Room makeRoom(Random& random);
/// The room turned against the plate, so that shadows stay with the room: plate_from_room.
Room turned(const Room& room, double plate_angle_rad);

/// Shares of each light that points see, at each vertex and on a grid of the plate.
struct LightField {
  using Shares = std::array<float, kLights>;
  std::vector<std::vector<Shares>> vertices;  ///< by sherd and vertex
  std::vector<Shares> plate;                  ///< kGrid x kGrid, row by row
  static constexpr int kGrid = 331;           ///< 1 mm, -165..165
};
/// Light that comes from the sky and by one reflection; it does not depend on the stop.
struct AmbientField {
  std::vector<std::vector<Eigen::Vector3f>> vertices;  ///< irradiance
  std::vector<Eigen::Vector3f> plate;
};

LightField castShadows(const Scene& scene, const Room& room_plate, std::uint64_t seed, int threads);
AmbientField gatherAmbient(const Scene& scene, const Room& room, const PlateSurface& plate,
                           std::uint64_t seed, int threads);

/// Irradiance on an element with this unit normal, from lights of which it sees these shares.
Eigen::Vector3f directLight(const Room& room_plate, const Eigen::Vector3f& p,
                            const Eigen::Vector3f& normal, const LightField::Shares& shares);
/// Both fields of the plate at a point, between the grid's points.
void plateLight(const LightField& field, const AmbientField& ambient, const Eigen::Vector2f& p,
                LightField::Shares& shares, Eigen::Vector3f& irradiance);

}  // namespace ostraka::virtualrig
