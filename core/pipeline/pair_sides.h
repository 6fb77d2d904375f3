#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pairing/assignment.h"
#include "pairing/candidates.h"
#include "registration/register_sides.h"
#include "scan/scan.h"

namespace ostraka::pipeline {

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
};

struct PairTable {
  std::vector<SherdPair> pairs;  ///< by front
  std::vector<int> unpaired_front, unpaired_back;
  int candidates = 0;  ///< pairs whose rims were compared
};

/// Which back belongs to which front, and where: candidates by their contours, each registered by
/// its rim, then one assignment over the batch. witnesses may be empty. Errors as the stages'.
Result<PairTable> pairSides(std::span<const scan::Scan> fronts, std::span<const scan::Scan> backs,
                            const registration::Witnesses& witnesses, const PairOptions& options,
                            Progress& progress, std::stop_token stop);

/// pairs.json as metrics.md describes it, scans named by their ids.
nlohmann::ordered_json toJson(const PairTable& table, std::span<const scan::Scan> fronts,
                              std::span<const scan::Scan> backs);

}  // namespace ostraka::pipeline
