#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"

namespace ostraka::catalogue {

enum class PlaceKind { Trench, Context, Bag };
/// trench, context or bag: the name of its table.
const char* nameOf(PlaceKind kind);

struct PlaceId {
  PlaceKind kind = PlaceKind::Context;
  std::int64_t row = 0;
  bool operator==(const PlaceId&) const = default;
};

/// What another name for a place would do.
struct Renaming {
  std::string before, after;  ///< as stored
  /// Another place beside it has that name, and both become that one; 0: none has.
  std::int64_t into = 0;
  /// In the place: contexts of a trench, bags of a trench or context, batches of its bags, sherds
  /// that are not void, and those of them that have a number, which they keep.
  int contexts = 0, bags = 0, batches = 0, sherds = 0, numbered = 0;
};

/// Errors: a name that cannot be one, a place that is gone.
Result<Renaming> renamingOf(const Catalogue& catalogue, PlaceId place, const std::string& name);

enum class IfNameIsTaken { Refuse, Join };

/// A reference from one row to another, before and after; 0: none.
struct Moved {
  const char *table, *column;
  std::int64_t row, before, after;
};

/// A place that became one with another: the row stays, so that labels and other copies of the
/// project lead on, but nothing lies in it and nothing lists it (one_with).
struct JoinedPlace {
  PlaceKind kind = PlaceKind::Context;
  std::int64_t from = 0, into = 0;
  std::vector<Moved> moved;
  std::vector<std::pair<std::int64_t, std::int64_t>> of_batches;  ///< batch, position: in both bags
  std::map<std::string, std::string> described;  ///< what `into` did not say before
};

/// What rename() did, for renameBack().
struct Renamed {
  PlaceId place;
  std::string before, after;
  std::vector<JoinedPlace> joined;  ///< empty where no other place had the name
};

/// Numbers that sherds have stay as they are, and the running numbers go on behind them
/// (GivenNumbers). Where another place beside it has the name, both become that one: sherds, bags,
/// batches and contexts come to it, places of one name within them become one, too, and what it
/// does not say of itself it takes over. The place that is typed in the capture follows.
/// Errors: as renamingOf; the name is taken and may not be.
Result<Renamed> rename(const Catalogue& catalogue, PlaceId place, const std::string& name,
                       IfNameIsTaken if_taken, const records::Provenance& provenance);
/// Errors: UnusableInput, something was changed meanwhile.
Result<void> renameBack(const Catalogue& catalogue, const Renamed& renamed,
                        const records::Provenance& provenance);

/// The place is one with the other by now, as one_with says: what lies in it comes to the other,
/// and places of one name become one. Without a word in the history, for rows that tell it already.
/// Returns what came, the place itself first. Throws as Statement does.
std::vector<JoinedPlace> bringTogether(const Catalogue& catalogue, PlaceKind kind,
                                       std::int64_t from, std::int64_t into);

/// Itself, or the one that it became one with. Throws as Statement does.
std::int64_t placeNow(const Catalogue& catalogue, PlaceId place);
/// Of those that became one with another: uuid, and the row that each is now.
Result<std::vector<std::pair<std::string, std::int64_t>>> joinedPlaces(const Catalogue& catalogue);
/// What the place is and was called, its name first, then those that it and the places that became
/// one with it had, each once. Empty for row 0. Throws as Statement does.
std::vector<std::string> namesOf(const Catalogue& catalogue, PlaceId place);

}  // namespace ostraka::catalogue
