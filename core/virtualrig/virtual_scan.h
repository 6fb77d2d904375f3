#pragma once
#include <stop_token>

#include "virtualrig/layout.h"
#include "virtualrig/setup.h"

namespace ostraka::virtualrig {

/// Scans of both sides as stereo would give them, without photographs: points that at least two
/// views see at less than 75 degrees past all neighbours, with the noise that
/// ../shared/scans/README.md tells. Writes front/fNNN.ply, back/bNNN.ply under shuffled names,
/// truth.json and the true meshes in the front's frame. Errors: CannotWrite, Cancelled.
Result<void> writeScans(const std::vector<VirtualSherd>& sherds, const Layout& layout,
                        const VirtualRig& rig, const SimulateOptions& options, Progress& progress,
                        std::stop_token stop);

}  // namespace ostraka::virtualrig
