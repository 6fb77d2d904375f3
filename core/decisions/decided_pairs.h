#pragma once
#include <stop_token>
#include <vector>

#include "base/message.h"
#include "decisions/pair_sides.h"

namespace ostraka::decisions {

/// What standing decisions mean for the scans of one table.
struct Settled {
  struct Pair {
    int front = 0, back = 0;
    PairDecision decision;
  };
  std::vector<Pair> pairs;
  std::vector<int> aside_front, aside_back, reshoot_front, reshoot_back;
  /// Sentences about decisions whose scans are not there any more, or were photographed again
  /// since (they wait in the file), and about those that a later one contradicts.
  std::vector<Message> warnings;
};
Settled settledBy(const Decisions& standing, const CandidateTable& table);

/// One assignment over the scans that nobody decided about, and the decided pairs, which are not
/// ambiguous any more. A decided pair keeps the program's own score. Where the pose is not that of
/// a candidate, registration.start is -1 and no fractures are compared yet. Errors: as assigned().
Result<PairTable> assigned(const CandidateTable& table, const Settled& settled,
                           const pairing::AssignOptions& options);

/// RMS displacement of a back that lies there between two poses, to about a third.
double apart_mm(const ScanRef& back, const Eigen::Isometry3d& a, const Eigen::Isometry3d& b);

/// The registration of a decided pair: from its pose, or from the outlines where it has none. One
/// that the fractures do not hold (or that stands as given) keeps the person's pose, with the
/// distance to the fractures' own place in its uncertainty. Errors: NotEnough (no usable fracture
/// and no pose given), Cancelled.
Result<registration::Registration> registerDecided(const PairDecision& decision,
                                                   const scan::Scan& front, const scan::Scan& back,
                                                   const registration::Constraints& constraints,
                                                   const PairOptions& options, Progress& progress,
                                                   std::stop_token stop);

}  // namespace ostraka::decisions
