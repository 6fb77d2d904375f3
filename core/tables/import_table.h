#pragma once
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"
#include "records/sherd.h"
#include "tables/column_mapping.h"

namespace ostraka::tables {

/// A preview does everything and takes it back: what it counts is what entering will do.
enum class ImportMode { Preview, Enter };
enum class UnknownPlaces { Refuse, Make };
/// Rows with a measured value that the catalogue asks about (ChangePreview::question).
enum class AskedRows { Hold, Enter };
/// A table with columns whose unit nothing says: ColumnChoice::unit_guessed.
enum class GuessedUnits { Hold, Enter };

struct ImportOptions {
  ImportMode mode = ImportMode::Preview;
  UnknownPlaces unknown_places = UnknownPlaces::Refuse;
  std::string source = {};  ///< name of the table, for unfinishedImports()
  AskedRows asked_rows = AskedRows::Hold;
  std::set<int> confirmed_lines = {};               ///< of them, those that enter all the same
  std::vector<ColumnChoice> columns = {};           ///< of importTable; the others are proposed
  GuessedUnits guessed_units = GuessedUnits::Hold;  ///< Enter: a person has seen them
};

constexpr const char* kClear = "<clear>";

/// One sherd to be entered: values by the names of sherdFields(); others become custom
/// fields. A blank value keeps what is there, kClear deletes it.
struct ImportRow {
  int line = 0;
  std::map<std::string, std::string> values;
  std::vector<std::pair<records::Measurement, std::string>> measured;  ///< and by whose initials
  /// Of a new sherd. Not by its number in values: each project has a B0001.
  store::BatchRow batch = {};
  /// Columns of numbers that persons took, the others are a program's; none: nothing is said.
  std::optional<std::set<std::string>> by_hand = {};
  /// Field -> why its value is not read, or why a person is asked about it, if it changes anything.
  std::map<std::string, Message> unclear = {}, doubtful = {};
};

struct Refusal {
  int line = 0;
  std::string column, value;
  Message reason;
};
/// A value that was there, and what takes its place; as texts of sherdFields().
struct ChangedValue {
  std::string name;  ///< the sherd's number, or its uuid; of a context: its place
  std::string field, old_value, new_value;
  int line = 0;  ///< of the table
};
enum class RowFate { Fresh, Same, Changed, Refused, Asked };
struct ImportReport {
  int fresh = 0, same = 0, changed = 0, refused = 0;
  int asked = 0;        ///< rows that did not enter: a person has to confirm a value
  int not_reached = 0;  ///< rows of which nothing is entered, since the import was stopped
  std::vector<Refusal> refusals, questions;
  std::vector<Message> warnings;
  TableMapping mapping = {};  ///< of a table
  CsvTable left_out = {};     ///< its refused and asked rows, as it has them
  bool held = false;          ///< nothing is entered before a person states the guessed units
  std::vector<std::pair<int, RowFate>> rows;  ///< line of a table, and what becomes of it
  void add(int line, RowFate fate) {
    rows.emplace_back(line, fate);
    int* const counts[] = {&fresh, &same, &changed, &refused, &asked};
    ++*counts[static_cast<std::size_t>(fate)];
  }
  /// Of sherds that were there before: what is changed, and what takes it back, in order.
  std::vector<records::FieldChange> changes, undo;
  std::vector<ChangedValue> changed_values;
};

/// Refused rows stay out, the others enter, each of them whole, some at a time so that others can
/// write between; within Catalogue::together all at once. When it is stopped or fails, the rows
/// entered so far stay and unfinishedImports() tells of it: the same import goes on, for doing it
/// twice changes nothing. Errors: Cancelled of a preview, what keeps the catalogue from writing.
Result<ImportReport> importSherds(catalogue::Catalogue& catalogue,
                                  const std::vector<ImportRow>& rows, const ImportOptions& options,
                                  const records::Provenance& provenance, Progress& progress,
                                  std::stop_token stop);

/// A table of sherds (a column has their numbers or uuids) or of contexts (site, trench, context,
/// bag ...), as CSV; its columns go where mapColumns says, which is remembered once they entered.
/// The history names the file (Provenance::why). No row is looked at while TableMapping::missing
/// asks for a column, and entering is only a preview (ImportReport::held) while a unit is guessed
/// and nobody has seen it. Errors: what parseCsv and mapColumns refuse, a column that is there
/// twice.
Result<ImportReport> importTable(catalogue::Catalogue& catalogue, std::string_view bytes,
                                 const std::string& where, const ImportOptions& options,
                                 const records::Provenance& provenance, Progress& progress,
                                 std::stop_token stop);

/// An import that was stopped, or whose program or computer was.
struct UnfinishedImport {
  std::string source;  ///< as ImportOptions said
  int entered = 0, of = 0;
};
/// One for each source, the latest last, until it is imported to its end or forgotten.
std::vector<UnfinishedImport> unfinishedImports(const catalogue::Catalogue& catalogue);
Result<void> forgetUnfinishedImports(catalogue::Catalogue& catalogue);

/// Runs `work` as one transaction that a preview takes back.
Result<void> previewOrEnter(catalogue::Catalogue& catalogue, ImportMode mode,
                            const std::function<Result<void>()>& work);

/// The second kind of importTable, mapped; stopped and gone on with as importSherds.
Result<ImportReport> importContexts(catalogue::Catalogue& catalogue, const CsvTable& table,
                                    const NumberRemarks& unclear, const ImportOptions& options,
                                    const records::Provenance& provenance, Progress& progress,
                                    std::stop_token stop);

}  // namespace ostraka::tables
