#pragma once
#include <filesystem>
#include <stop_token>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"
#include "stereo/stereo.h"

namespace ostraka::review {

/// The photographs of one side with the cameras and the masks that a run left in `out`, without
/// those on which no sherd is marked. batch: the batch's folder, wherever it lies now. Errors:
/// UnusableInput (no whole results, a photograph that is gone), Cancelled. Memory: all photographs.
Result<std::vector<stereo::View>> savedViews(const std::filesystem::path& out,
                                             const std::filesystem::path& batch, batch::Side side,
                                             const std::stop_token& stop);

}  // namespace ostraka::review
