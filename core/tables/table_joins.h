#pragma once
#include <optional>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "records/sherd.h"
#include "tables/import_table.h"

namespace ostraka::tables {

/// The joins that a whole table names. One row is enough for both sherds, whichever comes first,
/// and a sherd that a later row makes is joined when it is there.
class TableJoins {
 public:
  explicit TableJoins(const std::vector<ImportRow>& rows);

  /// What the sherd of row `i` joins, now that the rows before it are entered; nothing when the
  /// table says nothing of it. Errors: UnusableInput: a partner that neither the catalogue nor the
  /// table knows, or the sherd itself.
  Result<std::optional<std::vector<store::SherdRow>>> of(
      std::size_t i, const records::SherdRecord& now, const catalogue::Catalogue& catalogue) const;
  void enteredAs(std::size_t i, store::SherdRow sherd) { rows_[i].sherd = sherd; }
  /// "A-1 – A-2", whose second row did not enter.
  Result<std::vector<std::string>> lost(const catalogue::Catalogue& catalogue) const;

 private:
  struct Row {
    std::string number, uuid;
    std::optional<std::vector<std::string>> named;  ///< none: the cell is blank
    std::vector<std::size_t> named_by;
    store::SherdRow sherd;  ///< once it is entered
  };
  std::optional<std::size_t> rowOf(const std::string& name) const;
  Result<store::SherdRow> sherdOf(std::size_t i, const catalogue::Catalogue& catalogue) const;

  std::vector<Row> rows_;
  std::map<std::string, std::size_t> by_name_;  ///< numbers and uuids
};

}  // namespace ostraka::tables
