#pragma once
#include <optional>

#include "base/message.h"
#include "batch/batch.h"
#include "stereo/stereo.h"

namespace ostraka::checks {

/// What a person hears of a side whose photographs do not bear each other out
/// (stereo::Agreement::plausible): a cloud comes of them all the same.
std::optional<Message> disagreement(batch::Side side, const stereo::Agreement& agreement);

}  // namespace ostraka::checks
