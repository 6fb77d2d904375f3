#pragma once
#include <filesystem>
#include <map>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "calibration/intrinsics.h"

namespace ostraka::calibration {

/// Pictures of one camera of a board, in the order of their names.
struct BoardPictures {
  int width = 0, height = 0;
  std::vector<TargetView> views;   ///< one per picture; without points where no board is seen
  std::vector<Message> set_aside;  ///< pictures that cannot be read, or of another size
};

/// All pictures of a folder (or of its sub-folder calib; batch::photographsIn) with their board:
/// board.json, a ChArUco board or, with "type": "aruco_grid", a plain grid of markers. By camera:
/// names cam<C>_cal<NN>; other names count as camera 0. Errors: UnusableInput (no board.json, no
/// picture), Cancelled.
Result<std::map<int, BoardPictures>> readBoardFolder(const std::filesystem::path& folder,
                                                     int threads, Progress& progress,
                                                     std::stop_token stop);

}  // namespace ostraka::calibration
