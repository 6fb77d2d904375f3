#pragma once
#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "decisions/decisions.h"
#include "pairing/assignment.h"
#include "pairing/candidates.h"
#include "registration/register_sides.h"
#include "rig/sheet_bend.h"
#include "scan/scan.h"

namespace ostraka::decisions {

/// A pair of sides whose fractures were compared.
struct RegisteredCandidate {
  pairing::Evidence evidence;  ///< front and back: indices of the table's scans
  registration::Registration registration;
  std::vector<pairing::StartPose> starts;  ///< of the outlines, best first; at least one

  /// Of the start that the registration came from.
  const pairing::StartPose& start() const;
};

/// How the chain registered a pair that a person decided.
struct RegisteredDecision {
  int front = -1, back = -1;
  std::string id;  ///< of the decision
  registration::Registration registration;
};

/// What the pairs are decided from: all that is left of a batch when its fractures were compared.
struct CandidateTable {
  std::vector<ScanRef> fronts, backs;
  std::vector<std::string> front_files, back_files;   ///< PLY, relative to OUT/work
  std::vector<RegisteredCandidate> candidates;        ///< by front, then back
  pairing::Method method = pairing::Method::Default;  ///< how they were found and are assigned
  double back_scale = 1;  ///< backs and their cameras are brought to the fronts' size by it
  bool has_scale = true;  ///< false: no length is known
  std::array<rig::Support, 2> supports;  ///< by side, as registration::Constraints has them
  /// Of results that were read; they go before the pose that the person gave.
  std::vector<RegisteredDecision> decided;

  const RegisteredCandidate* find(int front, int back) const;  ///< nullptr: not compared
};

/// Of the scan of this id; -1: none has it.
int indexOf(const std::vector<ScanRef>& scans, const std::string& id);

/// Where a scan lies: its id and mean.
ScanRef refOf(const scan::Scan& scan, batch::Side side);

/// A sherd has its front's number ("f007": "07"), so that it keeps it whatever is decided about
/// the others.
std::string sherdNumber(const std::string& front_id);

nlohmann::ordered_json toJson(const CandidateTable& table);
/// Errors: UnusableInput.
Result<CandidateTable> readCandidates(const std::filesystem::path& file);
/// The table of a processed batch. Errors: Missing when its pairs are not processed yet,
/// UnusableInput.
Result<CandidateTable> readCandidatesOf(const std::filesystem::path& output);

const char* name(pairing::Doubt doubt);  ///< "", "self_check", "other_partner", ...
const char* name(registration::FailedCheck failed_check);  ///< "", "upside_down", ...

}  // namespace ostraka::decisions
