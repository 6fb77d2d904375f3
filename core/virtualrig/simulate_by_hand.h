#pragma once
#include <stop_token>

#include "virtualrig/layout.h"

namespace ostraka::virtualrig {

/// The files of a batch that is photographed by hand, as simulateBatch with hand_held tells.
/// Errors: CannotWrite, Cancelled.
Result<void> photographByHand(const std::vector<vessels::VirtualSherd>& sherds,
                              const Layout& layout, const SimulateOptions& options,
                              Progress& progress, std::stop_token stop);

}  // namespace ostraka::virtualrig
