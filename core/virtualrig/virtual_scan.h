#pragma once
#include <stop_token>

#include "virtualrig/layout.h"
#include "virtualrig/setup.h"

namespace ostraka::virtualrig {

/// Scans of both sides as stereo would give them, without photographs: points that at least two
/// views see at less than 75 degrees past all neighbours, with the noise that
/// ../shared/scans/README.md tells or, with ScanNoise::Stereo, what the figures of stereo on the
/// demo show (docs/experiments.md): broken edges 0.03-0.10 mm fat and more where they overhang,
/// SD 0.11-0.16 mm, correlated over 1-4 mm, normals 20 degrees off, a fifth to two fifths not
/// there. Writes front/fNNN.ply, back/bNNN.ply under shuffled names, truth.json and the true meshes
/// in the front's frame. Errors: CannotWrite, Cancelled.
Result<void> writeScans(const std::vector<vessels::VirtualSherd>& sherds, const Layout& layout,
                        const VirtualRig& rig, const SimulateOptions& options, Progress& progress,
                        std::stop_token stop);

}  // namespace ostraka::virtualrig
