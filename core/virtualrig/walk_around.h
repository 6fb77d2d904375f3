#pragma once
#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "batch/batch.h"
#include "rendering/hand_held.h"
#include "rendering/lighting.h"
#include "rendering/sensor.h"
#include "rig/camera.h"

/// What a person, a camera and a room do differently from photograph to photograph.
namespace ostraka::virtualrig {

/// What one kind of camera does to all its photographs.
struct CameraModel {
  double focal_per_width = 0;        ///< focal length in pixels over the picture's width
  rig::Distortion distortion{};      ///< one for all photographs
  double focal_mm = 0, fnumber = 0;  ///< true ones, for EXIF
  double breathing = 0.004;          ///< SD of the focal length from photograph to photograph
  double drift_px = 3;               ///< SD of the principal point, of 1600 pixels
  rendering::Sensor sensor;
  int jpeg_quality = 90;
  bool halved_colors = true;  ///< 4:2:0
  std::string model;          ///< EXIF's name of it
};
CameraModel cameraModel(rendering::CameraKind kind, vessels::Random& random);

/// One photograph before it is taken.
struct FreeShot {
  std::string name;  ///< "IMG_2411"
  batch::Side side = batch::Side::Front;
  rig::Intrinsics intrinsics;
  Eigen::Isometry3d camera_from_plate;
  rendering::Sensor sensor;
  double focus_mm = 300;  ///< depth that the autofocus found
  double time_s = 0;      ///< since the first photograph
};
/// Fronts, then backs: a walk around the sheet, 22 to 72 degrees above it, the whole of it just in
/// sight (26-33 cm away with a telephone over A4), rolled by up to 7 degrees.
std::vector<FreeShot> walkAround(const rendering::HandHeldOptions& options,
                                 const CameraModel& model, int width, vessels::Random& random);

/// The light of the room. It stands still with the sheet, except for a flash: withFlash.
rendering::Lighting makeLighting(rendering::LightKind kind, vessels::Random& random);
/// The lighting with its first lamp carried to the camera.
rendering::Lighting withFlash(const rendering::Lighting& lighting,
                              const Eigen::Isometry3d& camera_from_plate);

}  // namespace ostraka::virtualrig
