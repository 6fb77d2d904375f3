#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "catalogue/label_codes.h"

namespace ostraka::catalogue {

/// What a typed name is to lead to.
enum class Named { Context, Bag };

/// The place that `text` names as people and labels write it: ARM1-T3-0012-4, ARM1 T3 0012 4, ARM1
/// / T3 / 0012 bag 4, and without the bag; without trench or site where one context alone fits.
/// Blanks and capitals make no difference (K 12 is K12); other marks of a code (AR-TS) belong to
/// it. Its context is one that the catalogue knows, in the catalogue's spelling; the bag may be new
/// where the site is named or a mark stands before it. below: site and trench, where they are known
/// otherwise: only contexts there count. None: no such context. Error:
/// UnusableInput, the text names several.
Result<std::optional<BagPlace>> typedPlace(const Catalogue& catalogue, const std::string& text,
                                           Named what, const BagPlace& below = {});

/// The number of a context in the same site and trench that people read as this one, though it is
/// another: 12 for 0012 (store::sortKey). Empty: there is none.
Result<std::string> contextReadAlike(const Catalogue& catalogue, const BagPlace& place);

/// Setting: the place that a person typed last for a batch; Settings::rename keeps it in step.
inline constexpr const char* kCapturePlace = "capture.place";

/// `text` with the code `to` in place of the site's code `from`, where it begins with that code and
/// names no place of another site.
std::string placeOfRenamedSite(const Catalogue& catalogue, const std::string& text,
                               const std::string& from, const std::string& to);

/// A place as tables and people write it: each code by itself, all of them in the context or the
/// bag, and those that are the only ones left out. In the catalogue's spelling where the context is
/// known; else it is a new one in the written or only site and trench. Without a context: as it was
/// written. Errors: UnusableInput, what has to be written, too.
Result<BagPlace> readPlace(const Catalogue& catalogue, const BagPlace& written);

}  // namespace ostraka::catalogue
