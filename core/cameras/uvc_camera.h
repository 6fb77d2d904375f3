#pragma once
#include <memory>
#include <string>

#include "devices/camera.h"
#include "devices/clock.h"

namespace ostraka::cameras {

struct UvcOptions {
  std::string source;         ///< best /dev/v4l/by-id/...; any source that OpenCV opens
  int width = 0, height = 0;  ///< wanted pixels; 0: as the camera stands
  int most_stale = 5;         ///< frames that may lie in the driver's buffers
};

/// A video camera through OpenCV, in a part of the program that is loaded here (video_camera.h). A
/// photograph is the first frame after the buffers are empty, as JPEG. Focus, exposure and white
/// balance are held by set("focus" ...): its automatic is then off. Errors: Missing (not there, or
/// held by another program; the part is not installed).
Result<std::unique_ptr<devices::Camera>> openUvcCamera(const UvcOptions& options,
                                                       std::shared_ptr<devices::Clock> clock);

}  // namespace ostraka::cameras
