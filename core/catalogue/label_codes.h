#pragma once
#include <compare>
#include <optional>
#include <string>
#include <string_view>

#include "catalogue/catalogue.h"
#include "records/records.h"

namespace ostraka::catalogue {

/// What the code on a printed label says: OST1:S:ARM1-T3-0012-0007:9F3A77C1. A code reader may type
/// it in small letters.
struct LabelCode {
  enum class Of { Sherd, Bag };
  Of of = Of::Sherd;
  std::string
      number;  ///< mostly in capitals; B0031-01 where the sherd had none when it was printed
  std::string id_end;  ///< the last digits of the uuid, small; empty: it was not in the catalogue
  /// The number is a place on a plate.
  bool isPlaceOnPlate() const;
};
/// Whether it begins as the code of a sherd's label does.
bool beginsAsSherdLabel(std::string_view text);
/// None when it is no code, or half of one.
std::optional<LabelCode> readLabelCode(std::string_view text);

/// The sherd that carries the label, whatever its number is by now; none: of another project.
Result<store::SherdRow> sherdOfLabel(const Catalogue& catalogue, const LabelCode& label);

/// A bag by the codes of where it is from; the trench may be empty.
struct BagPlace {
  std::string site, trench, context, bag;
  auto operator<=>(const BagPlace&) const = default;
};
/// The place of the bag that carries the label, as the catalogue writes it; none: of another
/// project.
Result<std::optional<BagPlace>> placeOfLabel(const Catalogue& catalogue, const LabelCode& label);
/// The place of a bag. None: no such bag.
Result<std::optional<BagPlace>> placeOf(const Catalogue& catalogue, store::BagRow bag);
/// Where the sherds of a batch are from: the context that all of them have by now, and their bag
/// where it is one for all; as long as one is still in the context of the batch's first bag, that
/// bag. None: it has no bag.
Result<std::optional<BagPlace>> placeOf(const Catalogue& catalogue,
                                        const records::BatchRecord& batch);
/// The bag's row, made with its context, trench and site where they are new. Capitals make no
/// difference.
Result<store::BagRow> bagAt(const Catalogue& catalogue, const BagPlace& place,
                            const records::Provenance& provenance);

}  // namespace ostraka::catalogue
