#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>

#include "base/progress.h"
#include "base/result.h"
#include "review/live_pairs.h"

namespace ostraka::review {

/// The next back for a front beyond those that are known already, by how well the outlines fit,
/// with the fractures compared; nothing when there is none left. What was found is kept in
/// OUT/work/more_candidates.json until the pairs are computed again, so that it is found once.
/// Errors: Cancelled, a scan that cannot be read, a disk that cannot be written to.
Result<std::optional<decisions::RegisteredCandidate>> nextCandidate(const LivePairs& live,
                                                                    int front,
                                                                    std::span<const int> known,
                                                                    Progress& progress,
                                                                    std::stop_token stop);

/// For each front that wants a person so many candidates that `wanted` are there, before anybody
/// asks for them. Errors: as above, and those of LivePairs::open.
Result<void> prepareCandidates(const std::filesystem::path& output, int wanted, Progress& progress,
                               std::stop_token stop);

}  // namespace ostraka::review
