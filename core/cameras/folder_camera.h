#pragma once
#include <filesystem>
#include <memory>

#include "devices/camera.h"
#include "devices/clock.h"

namespace ostraka::cameras {

struct FolderCameraOptions {
  std::filesystem::path folder;  ///< where the camera's own software puts its photographs
  double steady_s = 1.0;         ///< a file is whole when it has not changed for so long
  double poll_s = 0.1;           ///< also finds files on network shares, which tell no news
};

/// Any camera whose own software writes files: new ones in a folder are its photographs. The files
/// stay where they are. Files that were there before getReady(), hidden ones and partial ones
/// (.part, .tmp) do not count; two photographs for one shot are refused.
Result<std::unique_ptr<devices::Camera>> openFolderCamera(const FolderCameraOptions& options,
                                                          std::shared_ptr<devices::Clock> clock);

}  // namespace ostraka::cameras
