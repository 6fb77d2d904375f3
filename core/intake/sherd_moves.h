#pragma once
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "catalogue/label_codes.h"
#include "records/sherd.h"

namespace ostraka::intake {

/// Changes of sherds' places, and what the sherds leave behind by them.
struct Move {
  /// Those that were wanted, and what comes along of site, trench, context and bag; by sherds.
  std::vector<records::FieldChange> changes;
  int without_bag = 0;  ///< sherds that leave their bag
  /// Those bags, as they would be in the new contexts, which have none of these numbers.
  std::set<catalogue::BagPlace> lacking;
  std::vector<std::string> numbers;  ///< that name the old place by the project's scheme
};

/// A context or bag is looked up below the codes that the sherd has; its whole name, as labels
/// print it (ARM1-T3-0012, ARM1 T3 0012 4), leads to it from everywhere, and so does the number of
/// a context alone where only one context has it, for a sherd of its site or without a place. A
/// sherd that gets another context comes to its bag of the same number, or the one that `wanted`
/// names; where the context has none of that number it leaves its bag. wanted: all changes of a
/// sherd beside each other. What change() would refuse stays as it is and leaves nothing behind.
Result<Move> moveOf(const catalogue::Catalogue& catalogue,
                    std::span<const records::FieldChange> wanted);

}  // namespace ostraka::intake
