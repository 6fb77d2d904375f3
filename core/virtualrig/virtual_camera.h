#pragma once
#include <memory>
#include <stop_token>

#include "base/result.h"
#include "capture/sequence.h"
#include "virtualrig/simulate.h"

/// The virtual rig as devices: three cameras and a turntable that render what they would see.
namespace ostraka::virtualrig {

/// stops: at their angles the table misses its marks as simulateBatch's does. output: not used.
struct VirtualDevicesOptions : SimulateOptions {
  double turn_deg_s = 0;  ///< how fast the table seems to turn; 0: at once
  double settle_s = 0;
  std::shared_ptr<devices::Clock> clock = devices::steadyClock();
};

/// Makes the sherds and lays them down. side_placed(Back) turns them over, as a hand would.
/// Photographs have the same bytes as those of simulateBatch with the same options.
/// Errors: UnusableInput.
Result<capture::RigDevices> openVirtualRig(const VirtualDevicesOptions& options);

/// What `rig simulate` writes beside the photographs: plate.json, board.json, the board's pictures
/// and the empty plate in calib/, so that the batch can be processed. Nothing that is there already
/// is written again.
Result<void> writeVirtualCalibration(const VirtualDevicesOptions& options,
                                     const std::filesystem::path& batch, Progress& progress,
                                     std::stop_token stop);

}  // namespace ostraka::virtualrig
