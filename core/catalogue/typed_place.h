#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "catalogue/label_codes.h"

namespace ostraka::catalogue {

/// What a typed name is to lead to.
enum class Named { Context, Bag };

/// The place that `text` names by all its codes, as labels print them: ARM1-T3-0012-4, ARM1 T3 0012
/// 4, ARM1 / T3 / 0012 bag 4, and without the bag. Its context is one that the catalogue knows, in
/// the catalogue's spelling; codes that have marks themselves (AR-TS) are recognised, in any
/// capitals. The bag may be new. None: no such context.
Result<std::optional<BagPlace>> typedPlace(const Catalogue& catalogue, const std::string& text,
                                           Named what);

/// The only context of this number, wherever it is; none: there are several, or none.
Result<store::ContextRow> onlyContext(const Catalogue& catalogue, const std::string& number);

}  // namespace ostraka::catalogue
