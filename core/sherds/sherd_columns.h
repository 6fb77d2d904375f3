#pragma once
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "records/numbering.h"
#include "records/sherd.h"
#include "store/database.h"

namespace ostraka::sherds {

/// For the files of this folder: where a field of a sherd lives.
struct SherdColumn {
  records::SherdField field;
  std::string records::SherdRecord::*text = nullptr;
  std::vector<std::string> records::SherdRecord::*terms = nullptr;
  const char* measure = nullptr;  ///< its kind, and its column in sherd_measure
  const char* sql = nullptr;      ///< what it is compared and ordered by
};
const std::vector<SherdColumn>& sherdColumns();
/// By its name, or its name without the unit (length, thickness); null when there is none.
const SherdColumn* sherdColumn(const std::string& name);

/// Rows as one JSON array, so that a page is one query.
std::string rowsJson(std::span<const store::SherdRow> rows);

/// Sorts drafts, which have no number, behind all numbers.
inline constexpr const char* kBehindAllNumbers = "\xF4\x8F\xBF\xBF";

/// Columns that only the filter knows: the last digits of the uuid, and the place on the plate
/// (B0031-01), as labels carry them.
inline constexpr const char *kLabelEnd = "label", *kLabelPlace = "label_place";
/// And the days on which it was entered, and its context was excavated.
inline constexpr const char *kEntered = "entered", *kExcavated = "excavated";

/// In the column scale, of sherds whose batch has doubts about it.
inline constexpr const char* kDoubtfulScale = "doubtful";

/// The sherd that this number was ever given to; none when it is free. `slug_only`: the number
/// differs, but its files would have the same name.
struct Taken {
  store::SherdRow sherd;
  std::string number;
  bool slug_only = false;
};
Taken takenBy(store::Database& database, const std::string& number);
/// Writes that the number is the sherd's for ever. Throws Refused where it is another's.
void giveNumber(const catalogue::Catalogue& catalogue, const records::SherdRecord& sherd,
                const std::string& number);
/// Gives it, and writes number, state and sort key of the sherd; empty: its number is taken away,
/// and given to no other. Throws Refused.
void setNumber(const catalogue::Catalogue& catalogue, const records::SherdRecord& sherd,
               const std::string& number);

/// All that it joins, and that they join it.
void setJoins(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
              const std::vector<store::SherdRow>& joins);
/// One custom field; an empty value deletes it.
void setExtra(const catalogue::Catalogue& catalogue, store::SherdRow sherd, const std::string& name,
              const std::string& value);

/// How the project numbers its sherds. Throws Refused.
records::Numbering schemeOf(const catalogue::Catalogue& catalogue);
/// Values of the numbering scheme's tokens for a sherd, by its codes of places and batch.
std::map<std::string, std::string> numberTokens(const catalogue::Catalogue& catalogue,
                                                const records::SherdRecord& sherd);

/// Settings with the numbers typed on plates: this and the batch's number.
inline constexpr const char* kTypedNumbers = "typed_numbers.";
/// Unique keys of all numbers that were typed on plates.
std::set<std::string> typedEverywhere(const catalogue::Catalogue& catalogue);
/// Those typed on plates that are not computed yet, with the batch's number; such a number is
/// written on a sherd. Not those of a batch that failed or was set aside: its sherds may lie on
/// another plate by now.
std::map<std::string, std::string> typedAndWaiting(const catalogue::Catalogue& catalogue);

enum class MeasureRank {
  PersonFirst,  ///< what a person measured stays above what the program computes
  Always        ///< this value counts from now on
};
/// The latest values that the program took from the sherd's model, by kind; `current`: those of
/// them that count now.
struct ComputedMeasures {
  std::map<std::string, double> values;
  std::set<std::string> current;
};
ComputedMeasures computedMeasures(const catalogue::Catalogue& catalogue, store::SherdRow sherd);
/// As the history shows it: 12.5 ± 0.4.
std::string measurementText(double value, const std::optional<double>& uncertainty);
void setMeasure(const catalogue::Catalogue& catalogue, const records::Measurement& measurement,
                const records::Provenance& provenance, MeasureRank rank);
/// A value typed by the person of `provenance`. Its uncertainty: 0 says that there is none; without
/// one the value has what it had when it was typed last.
void typeMeasure(const catalogue::Catalogue& catalogue, const records::Measurement& typed,
                 const records::Provenance& provenance);
/// Nothing counts any more; old rows stay.
void clearMeasure(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                  const std::string& kind, const records::Provenance& provenance);

/// Lets the draft sherds of a batch, and the scans' states, follow the decisions that count.
void settleSherds(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                  const records::Provenance& provenance);

}  // namespace ostraka::sherds
