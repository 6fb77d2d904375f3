#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace ostraka::merge {

/// Conflicts about a number that two sherds have: this and the uuid of B's sherd.
inline constexpr const char* kTwoSherds = "number/";

enum class Take { A, B, Number, One };
const char* nameOf(Take take);  ///< "a", "b", "number", "one"

/// What a person decided of one conflict.
struct Choice {
  Take take = Take::A;
  /// Number: what B's row is called from now on. A or B, of a number that two sherds have: what
  /// the sherd is called that loses it; empty: the next free number.
  std::string number;
};
using Settled = std::map<std::string, Choice>;  ///< by the conflict's id

/// The number that the choice states, as it is stored. Error: UnusableInput names the conflict.
Result<std::string> newName(const std::string& conflict_id, const Choice& choice);

/// A JSON list of {"id": "...", "take": "a" | "b" | "one"}, where a or b may come with a "number",
/// or {"id": "...", "number": "..."}. Errors: UnusableInput names the file and what is wrong in it.
Result<Settled> readSettled(const std::filesystem::path& file);

/// What one of the projects has, and who entered it last where that is known.
struct Version {
  std::vector<std::pair<std::string, std::string>> values;  ///< field, text; empty: says nothing
  std::string by = {};                                      ///< initials; empty: not known
  std::int64_t at_ms = 0;                                   ///< UTC; 0: not known
};

/// What both projects say differently, side by side.
struct Conflict {
  std::string id;           ///< the same as often as it is found: sherd/UUID/ware
  std::string table, name;  ///< what it is about: sherd, ARM1-T3-0012-0007
  std::string field;        ///< ware; empty: several fields, which the versions name
  Version a, b;
  std::vector<Take> takes;  ///< how it can be settled
  bool settled = false;
  /// Of a number that two sherds have, while it is open: what A's and B's sherd would be called if
  /// the other one kept the number. All of a merge are different; empty: none can be proposed.
  std::string new_a = {}, new_b = {};
  bool offers(Take take) const;
  bool isOfTwoSherds() const { return id.starts_with(kTwoSherds); }  ///< with one number
};

}  // namespace ostraka::merge
