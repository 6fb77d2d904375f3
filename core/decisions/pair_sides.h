#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "decisions/candidate_table.h"
#include "pairing/assignment.h"
#include "pairing/candidates.h"
#include "registration/register_sides.h"
#include "scan/scan.h"

namespace ostraka::decisions {

/// Where a sherd lay says a little about its back: many people turn each over where it lies.
enum class PlaceEvidence { None, Weak };

struct PairOptions {
  pairing::CandidateOptions candidates;
  registration::RegistrationOptions registration;
  pairing::AssignOptions assign;
  PlaceEvidence place = PlaceEvidence::None;
  int threads = 0;
};

struct SherdPair {
  pairing::Decision decision;
  registration::Registration registration;
  double contour_rms_mm = 0;
  std::string decided;                 ///< id of a person's decision; empty: the program's own
  std::string decided_by, decided_at;  ///< who and when
};

struct PairTable {
  std::vector<SherdPair> pairs;  ///< by front
  std::vector<int> unpaired_front, unpaired_back;
  std::vector<int> aside_front, aside_back;      ///< taken out by a person
  std::vector<int> reshoot_front, reshoot_back;  ///< to be shot again, says a person
  int candidates = 0;                            ///< pairs whose fractures were compared
};

/// All pairs within reach by their outlines, each registered by its fracture. The table's files and
/// scale are left to the caller. constraints may be empty. Errors as the stages'.
Result<CandidateTable> compareSides(std::span<const scan::Scan> fronts,
                                    std::span<const scan::Scan> backs,
                                    const registration::Constraints& constraints,
                                    const PairOptions& options, Progress& progress,
                                    std::stop_token stop);

/// One assignment over the batch. Errors: those of assignPairs.
Result<PairTable> assigned(const CandidateTable& table, const pairing::AssignOptions& options);

/// Which back belongs to which front, and where: both of the above.
Result<PairTable> pairSides(std::span<const scan::Scan> fronts, std::span<const scan::Scan> backs,
                            const registration::Constraints& constraints,
                            const PairOptions& options, Progress& progress, std::stop_token stop);

/// Why a person must look, one English sentence; empty where the pair is not ambiguous.
std::string reasonOf(const SherdPair& pair);

/// pairs.json as metrics.md describes it, scans named by their ids.
nlohmann::ordered_json toJson(const PairTable& table, std::span<const scan::Scan> fronts,
                              std::span<const scan::Scan> backs);
nlohmann::ordered_json toJson(const PairTable& table, const std::vector<ScanRef>& fronts,
                              const std::vector<ScanRef>& backs);

}  // namespace ostraka::decisions
