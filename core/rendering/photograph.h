#pragma once
#include <opencv2/core.hpp>
#include <stop_token>

#include "rendering/backdrop.h"
#include "rig/camera.h"

namespace ostraka::rendering {

/// What lens and sensor do to the light.
struct Sensor {
  double blur_px = 0.57;       ///< standard deviation of the lens's blur
  double shot_noise = 8.5e-5;  ///< variance per brightness: full scale is 12,000 electrons, each
                               ///< pixel for itself, after the blur; 2.1 % at a brightness of 0.2
  double read_noise = 0.0003;  ///< standard deviation, of full scale: 3.5 electrons
  double vignette = 0.2;       ///< light lost in the corners
  /// Automatic exposure: the brightness that 95 % of the picture stay below; 0: as the light falls.
  double exposure_aim = 0;
  double exposure = 1;              ///< by how much it misses that
  Eigen::Array3f balance{1, 1, 1};  ///< of white: red, green, blue
  Eigen::Vector2d motion_px{0, 0};  ///< what the picture moved while the shutter was open
  double sharpening = 0;            ///< share of the brightness's fine detail that is added again
};

/// A camera with the direction of each pixel, computed once.
class LensRays {
 public:
  explicit LensRays(const rig::Intrinsics& intrinsics);
  const rig::Intrinsics& intrinsics() const { return intrinsics_; }
  /// (x/z, y/z) of a pixel, and of a place beside it by less than a pixel.
  Eigen::Vector2f at(int x, int y) const {
    return rays_[static_cast<std::size_t>(y) * intrinsics_.width + x];
  }
  Eigen::Vector2f at(int x, int y, float dx, float dy) const {
    return at(x, y) + Eigen::Vector2f(dx / static_cast<float>(intrinsics_.fx),
                                      dy / static_cast<float>(intrinsics_.fy));
  }

 private:
  rig::Intrinsics intrinsics_;
  std::vector<Eigen::Vector2f> rays_;
};

/// A lens that is no pinhole: sharp on one plane before the camera.
struct Focus {
  double aperture_mm = 0;  ///< diameter; 0: sharp everywhere
  double distance_mm = 300;
};

struct View {
  const Scene& scene;
  const Lighting& room_plate;
  const LightField& light;
  const AmbientField& ambient;
  const Backdrop& backdrop;
  Eigen::Isometry3d camera_from_plate;
  Hand hand = {};
  Focus focus = {};
};

struct Photograph {
  cv::Mat image;    ///< 8-bit blue, green, red, sRGB
  cv::Mat labels;   ///< 8-bit: 0 none, i + 1 where sherd i covers more than half of the pixel
  double gain = 1;  ///< by which the exposure multiplied the light
};

/// Ray casting with 4 samples a pixel, 16 where they disagree, and up to 32 out of focus. Stopped
/// early: incomplete.
Photograph photograph(const View& view, const LensRays& lens, const Sensor& sensor,
                      std::uint64_t seed, std::stop_token stop);
/// The calibration board in even light before a grey wall.
cv::Mat photographBoard(const BoardSurface& board, const LensRays& lens,
                        const Eigen::Isometry3d& camera_from_board, const Sensor& sensor,
                        std::uint64_t seed);

}  // namespace ostraka::rendering
