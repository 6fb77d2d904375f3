#pragma once
#include <span>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pairing/candidates.h"
#include "scan/scan.h"

namespace ostraka::pairing {

/// Front size / back size of a batch whose two sides have no common unit (poses from photographs
/// alone): one number for all its pairs. Shapes are compared with scale free; the median of the
/// best assignment's scales, to about 0.3 %. Units may be anything. 1 where only one side has
/// scans. Errors: NotEnough when no pair is likely, Cancelled, those of findCandidates.
Result<double> commonScale(std::span<const scan::Scan> fronts, std::span<const scan::Scan> backs,
                           const CandidateOptions& options, Progress& progress,
                           std::stop_token stop);

/// The scan with all lengths multiplied.
scan::Scan scaled(const scan::Scan& scan, double factor);
std::vector<scan::Scan> scaled(std::span<const scan::Scan> scans, double factor);

}  // namespace ostraka::pairing
