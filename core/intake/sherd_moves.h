#pragma once
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/sherd.h"

namespace ostraka::intake {

/// Changes of sherds' places, and what the sherds leave behind by them.
struct Move {
  std::vector<records::FieldChange>
      changes;                       ///< those that were wanted, and bags emptied; by sherds
  int without_bag = 0;               ///< sherds whose bag is emptied
  std::set<std::string> bags;        ///< these; they stay in the old contexts
  std::vector<std::string> numbers;  ///< that name the old place by the project's scheme
};

/// A sherd that gets another context leaves its bag, unless `wanted` names one: a bag belongs to
/// one context. wanted: all changes of a sherd beside each other. What change() would refuse stays
/// as it is and leaves nothing behind.
Result<Move> moveOf(const catalogue::Catalogue& catalogue,
                    std::span<const records::FieldChange> wanted);

}  // namespace ostraka::intake
