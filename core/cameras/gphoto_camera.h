#pragma once
#include <memory>
#include <string>
#include <vector>

#include "devices/camera.h"
#include "devices/clock.h"

namespace ostraka::cameras {

/// A system camera that libgphoto2 sees.
struct FoundCamera {
  devices::CameraId id;  ///< the serial number is empty when it could not be asked
  Message trouble;       ///< why not, and what to do; empty: all is well
};
std::vector<FoundCamera> listGphotoCameras();

/// serial: as the camera tells it, or "ptpip:host:port:port" for one in the network. What is
/// changed is restored by close(). Files on the camera's card stay there. Errors: Missing (not
/// plugged in, held by another program, no permission).
Result<std::unique_ptr<devices::Camera>> openGphotoCamera(const std::string& serial,
                                                          std::shared_ptr<devices::Clock> clock);

}  // namespace ostraka::cameras
