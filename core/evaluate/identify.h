#pragma once
#include <string>
#include <vector>

#include "evaluate/pairs.h"
#include "evaluate/truth.h"

namespace ostraka::evaluate {

struct NamedScan {
  std::string name;  ///< stem of its file
  PointCloud cloud;  ///< plate frame of its side
};

/// Which scans belong together, told from where they lie: a scan is that sherd's in whose surface's
/// reach (1.5 mm) most of its points lie, at least half; of several scans of one sherd and side the
/// largest. All others are unpaired; a sherd that lacks a scan counts in unseen_pairs.
PairsTruth truthOfScans(const std::vector<NamedScan>& fronts, const std::vector<NamedScan>& backs,
                        const std::vector<TrueSherd>& sherds, int threads);

}  // namespace ostraka::evaluate
