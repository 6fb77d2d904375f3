#pragma once
#include <span>
#include <vector>

#include "base/message.h"
#include "batch/batch.h"
#include "batch/exif.h"

namespace ostraka::checks {

/// What differs between the photographs of one camera, front and back together, by what the cameras
/// wrote: the body (one lens is computed for all), focal length, aperture, exposure time, ISO,
/// white balance. Whole sentences; photographs that say nothing of a setting differ from none.
/// exif: one a shot.
std::vector<Message> settingsWarnings(std::span<const batch::Shot> shots,
                                      std::span<const batch::Exif> exif);

/// The same, read from the batch's photographs. None of photographs by hand: each has a tone of its
/// own, and those of one body, zoom and size share a lens by themselves.
std::vector<Message> settingsWarnings(const batch::Batch& batch, int threads);

}  // namespace ostraka::checks
