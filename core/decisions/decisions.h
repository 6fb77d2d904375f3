#pragma once
#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::decisions {

enum class DecisionKind {
  Pair,      ///< these two sides are one sherd
  Aside,     ///< these scans take no part: no sherd, or not worth the time
  Reshoot,   ///< these scans must be photographed again
  Join,      ///< these scans of one side are one piece
  Split,     ///< this scan is two pieces, cut along a line
  Withdraw,  ///< what it replaces holds no longer (undo); what that replaced holds again
};

/// A scan as a person pointed at it. Ids may change when a side is computed anew, its place on the
/// plate does not.
struct ScanRef {
  batch::Side side = batch::Side::Front;
  std::string id;
  Eigen::Vector2d place_mm = Eigen::Vector2d::Zero();  ///< mean of the points, side's plate frame
  /// A hash that names the side's photographs, since other sherds may lie at its place when it is
  /// photographed again; empty for results without photographs.
  std::string photographs = {};
};

/// What becomes of the pose that a person gives.
enum class Settle {
  ByFractures,  ///< it is a start; the registration goes on from it
  AsGiven       ///< it stands as it is: made by hand where the fractures tell too little
};

/// What a person decided: a value that the window writes and the chain reads.
struct PairDecision {
  std::string id = {};  ///< a UUID, by which the catalogue knows it, too; given when it is appended
  std::vector<std::string> replaces = {};  ///< ids; empty: the program's own proposal
  DecisionKind kind = DecisionKind::Pair;
  std::string at;              ///< UTC, 2026-07-14T09:30:12Z; given when it is appended
  std::string by;              ///< initials or name of the person
  std::string note;            ///< free text
  std::vector<ScanRef> scans;  ///< Pair: front, back. Join: two or more. Split: one
  std::optional<Eigen::Isometry3d> front_from_back;  ///< Pair; absent: the program finds it
  Settle settle = Settle::ByFractures;
  std::array<Eigen::Vector2d, 2> cut_mm{};  ///< Split: a line on the side's plate, a to b
};

/// When it was taken, for a person: 2026-07-14 09:30 UTC.
std::string momentOf(const PairDecision& decision);

/// All decisions ever taken, in order; nothing is ever removed.
using Decisions = std::vector<PairDecision>;

/// Those that hold now, in order: neither replaced nor withdrawn. No Withdraw among them.
Decisions standing(const Decisions& all);

/// OUT/decisions.json; none when there is no such file. Errors: UnusableInput names the file, and
/// the decision that could not be taken so.
Result<Decisions> readDecisions(const std::filesystem::path& output);
/// The same from the file's text; `where` names the file in errors.
Result<Decisions> parseDecisions(std::string_view text, const std::string& where);

/// Writes the decision behind the others, atomically, with its id and time, and with what it
/// replaces: the standing ones about the same scans (Pair, Aside, Reshoot), or those named already
/// (Withdraw). What takes one side of a sherd out that was taken out with its other side is about
/// both. Returns it as written. Errors: those of readDecisions, CannotWrite; UnusableInput
/// without a person's name, with text that checkText refuses, with the wrong number of scans, or
/// for a withdrawal of what does not stand, or of what replaced a decision about a scan that
/// another was made about since.
Result<PairDecision> appendDecision(const std::filesystem::path& output, PairDecision decision);
/// What it replaces when it is appended now. Errors: those of readDecisions.
Result<Decisions> replacedBy(const PairDecision& decision, const std::filesystem::path& output);

nlohmann::ordered_json toJson(const Decisions& decisions);
/// All of decisions.json, as parseDecisions reads it.
std::string textOf(const Decisions& decisions);

/// Those whose ids OUT/report.json names: what holds may have changed since. None where there are
/// no results.
Decisions followed(const Decisions& all, const std::filesystem::path& output);
/// They differ in nothing but their ids, moments, persons and notes, as a decision and the same
/// one done again after an undo: results of the one are results of the other.
bool equivalent(const PairDecision& a, const PairDecision& b);
bool equivalent(const Decisions& a, const Decisions& b);  ///< in any order
bool containedIn(const Decisions& list, const PairDecision& decision);
/// What holds and was not followed, and what was followed and holds no more.
Decisions changedSince(const Decisions& all, const Decisions& followed);

/// A sherd's mean moves less when it is computed anew, and no two sherds' means lie nearer.
inline constexpr double kSamePiece_mm = 10;

/// The index of the scan that is meant, -1 when none lies within kSamePiece_mm of the place. Scans
/// of other photographs are not meant.
int resolved(const ScanRef& ref, const std::vector<ScanRef>& scans);

}  // namespace ostraka::decisions
