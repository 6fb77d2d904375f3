#pragma once
#include <span>
#include <vector>

#include "base/message.h"
#include "scan/scan.h"

namespace ostraka::checks {

/// Sherds that lie side against side on the plate, without a neck between them, become one scan
/// that no other side fits. What gives them away: it is as large, seen from above, as two scans of
/// the other side together that have no partner either. One sentence for each such scan of `lone`.
std::vector<Message> perhapsTouching(std::span<const scan::Scan* const> lone,
                                     std::span<const scan::Scan* const> others);

}  // namespace ostraka::checks
