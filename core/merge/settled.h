#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"

namespace ostraka::merge {

enum class Take { A, B, Number };

/// What a person decided of one conflict.
struct Choice {
  Take take = Take::A;
  std::string number;  ///< Number: what B's row is called from now on
};
using Settled = std::map<std::string, Choice>;  ///< by the conflict's id

/// A JSON list of {"id": "...", "take": "a" | "b"} or {"id": "...", "number": "..."}. Errors:
/// UnusableInput names the file and what is wrong in it.
Result<Settled> readSettled(const std::filesystem::path& file);

/// What both projects say differently, side by side.
struct Conflict {
  std::string id;       ///< the same as often as it is found: sherd/UUID/ware
  std::string subject;  ///< for a person: sherd ARM1-T3-0012-0007, ware
  std::string a, b;
  std::vector<std::string> takes;  ///< how it can be settled: a, b, number
  bool settled = false;
};

}  // namespace ostraka::merge
