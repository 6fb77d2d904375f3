#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"
#include "tables/csv.h"

namespace ostraka::tables {

/// Who says which field a column belongs to.
enum class ChosenBy { Name, Earlier, Person, Nobody };

/// What becomes of one column of a table.
struct ColumnChoice {
  std::string column;  ///< as the table names it
  /// One of sherdFields() or of the columns of contexts; extra.NAME: a custom field;
  /// empty: the column is left out.
  std::string field;
  std::string unit = {};  ///< of its values, see unitsOf(); empty of texts
  ChosenBy by = ChosenBy::Person;
  bool unit_guessed = false;              ///< from its values: nothing else says it
  std::vector<std::string> samples = {};  ///< the first values that are not blank
  bool unit_idle = false;                 ///< nothing says it, and the values leave no other
  bool isOwn() const { return field.starts_with("extra."); }
  /// The program alone writes the field: exports show it, an import never reads it.
  bool isOnlyShown() const;
};

struct TableMapping {
  bool of_contexts = false;  ///< no column is a sherd's number or uuid
  std::vector<ColumnChoice> columns;
  Message kind = {};     ///< which kind of table it is taken for, and why
  Message missing = {};  ///< what a person has to choose before it is one of the two; else empty
};

/// What each column of a table is taken for: what `chosen` says of it, by whom it says, else what
/// was chosen for a table with these columns before, else its name, else a field of its own. A
/// table without numbers of sherds that has a column which only sherds have is none of contexts,
/// unless a person says what becomes of that column. Errors: a choice of a column, field or unit
/// that is not there; two columns of one field.
Result<TableMapping> mapColumns(const catalogue::Catalogue& catalogue, const CsvTable& table,
                                const std::vector<ColumnChoice>& chosen, const std::string& where);

/// Sentences about values of a table: line -> field -> sentence.
using NumberRemarks = std::map<int, std::map<std::string, Message>>;

/// The table with the fields' names as columns and all values in the fields' own units; what is
/// left out is gone. Texts that are no numbers, and the unclear ones, stay as they are. Each row
/// fits the header.
CsvTable mapped(const CsvTable& table, const TableMapping& mapping, const NumberRemarks& unclear);

/// For the next table with the same columns, in whatever order. Of units only those that a person
/// chose or that a heading says; others are guessed again.
Result<void> rememberColumns(catalogue::Catalogue& catalogue, const TableMapping& mapping,
                             const records::Provenance& provenance);

/// COLUMN=FIELD or COLUMN=FIELD:unit, as typed; FIELD may lack its unit (weight), be extra.NAME, or
/// '-' to leave the column out. Errors: neither.
Result<ColumnChoice> parseColumnChoice(std::string_view text);
/// All that a column may be chosen as, custom fields aside.
std::vector<std::string> fieldsOfTables(bool of_contexts);

/// A value in `unit` as one in the field's own, exactly: 1.5 kg is 1500, 1,2 cm is 12. A unit
/// behind the value comes before `unit`. What cannot be read stays as it is.
std::string inOwnUnit(const std::string& value, const std::string& unit, const std::string& field);

}  // namespace ostraka::tables
