#pragma once
#include <string>

#include "catalogue/catalogue.h"
#include "store/database.h"

namespace ostraka::catalogue {

/// For the files of this folder: one row of the history. Nothing is written when old == new.
void remember(const Catalogue& catalogue, const records::Provenance& provenance, const char* table,
              std::int64_t row, const std::string& field, const std::string& old_value,
              const std::string& new_value);

/// A field of a saved record, for the history of a table whose rows are saved whole.
struct SavedField {
  const char* name;
  std::string value;
};
/// Compares with what the row holds and remembers each difference; returns whether there is one.
bool rememberDifferences(const Catalogue& catalogue, const records::Provenance& provenance,
                         const char* table, std::int64_t row,
                         const std::vector<SavedField>& fields);

/// A row as the history names it; nothing for no row.
inline std::string rowText(std::int64_t row) {
  return row > 0 ? std::to_string(row) : std::string();
}

}  // namespace ostraka::catalogue
