#pragma once
#include <Eigen/Core>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::sherds {

/// A number that a person gave a sherd while it lay on the plate with its front up.
struct TypedNumber {
  Eigen::Vector2d at_mm{0, 0};  ///< of the sherd's middle, frame of the plate
  std::string number;
};

/// Those of a batch, as they were typed; empty when none were.
Result<std::vector<TypedNumber>> typedNumbers(const catalogue::Catalogue& catalogue,
                                              store::BatchRow batch);
/// All of a batch. Errors: UnusableInput, a number that stands here twice or belongs to another
/// sherd that waits for no photographs, here or on a plate that is not computed yet.
Result<void> setTypedNumbers(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                             std::span<const TypedNumber> numbers,
                             const records::Provenance& provenance = {});

/// The sherd of this number lies on another plate by now. Throws Refused.
void forgetTyped(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                 const std::string& number, const records::Provenance& provenance);

/// The whole number of what was typed or scanned: digits alone are the running number in the
/// batch's context after the project's scheme, a label's code (OST1:S:...) holds its own, and what
/// follows a '=' is meant as it stands. Errors: UnusableInput, digits without a bag that says the
/// context.
Result<std::string> wholeNumber(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                                const std::string& typed);
/// The same for one sherd, in its own context.
Result<std::string> wholeNumber(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                                const std::string& typed);

/// The number is one that the project's scheme gives to sherds of this batch, with the digits that
/// stand in it. Errors: without a bag nobody knows.
Result<bool> fitsTheBatch(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                          const std::string& number);
/// The same for the place and the batch that this record names.
Result<bool> fitsThePlace(const catalogue::Catalogue& catalogue, const records::SherdRecord& place,
                          const std::string& number);

/// For each number the place that it belongs to: nearest to each other, within 20 mm; else -1.
std::vector<int> placesOf(std::span<const TypedNumber> numbers,
                          std::span<const Eigen::Vector2d> places_mm);

/// Where the numbers of its sherds were typed, by their fronts; others have their numbers from
/// elsewhere.
std::map<store::ScanRow, Eigen::Vector2d> typedOn(const catalogue::Catalogue& catalogue,
                                                  store::BatchRow batch);

/// Gives the sherds of a batch the numbers that were typed on their fronts; a sherd that has a
/// number already keeps it, one that lost it again to a person stays without, and one that waits
/// for photographs under that number takes over what lies there. Returns the numbers that are left:
/// no sherd lies there, or it has no context yet. Doing it twice changes nothing.
Result<std::vector<std::string>> giveTypedNumbers(const catalogue::Catalogue& catalogue,
                                                  store::BatchRow batch,
                                                  const records::Provenance& provenance);

}  // namespace ostraka::sherds
