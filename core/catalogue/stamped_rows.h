#pragma once
#include <cstdint>
#include <string>

#include "base/uuid.h"
#include "catalogue/catalogue.h"
#include "records/records.h"
#include "store/database.h"

namespace ostraka::catalogue {

/// The SQL of a new row's number, behind all that the table has or its history speaks of: what the
/// history says of a row that was lost must not become that of another.
std::string nextRow(const std::string& table);

/// The SQL that writes a row of a table that people see, with what all of those have: id, who made
/// and changed it and when, its revision. columns: the others, a blank between each.
std::string insertion(const std::string& table, const std::string& columns);
std::string change(const std::string& table, const std::string& columns);

/// Returns the new row. id: empty for a fresh one; values: in the order of the columns.
template <class... Values>
std::int64_t addRow(const Catalogue& catalogue, const records::Provenance& provenance,
                    const char* table, const std::string& id, const std::string& columns,
                    const Values&... values) {
  const std::int64_t now = catalogue.now();
  catalogue.database().run(insertion(table, columns), values..., id.empty() ? newId(now) : id, now,
                           provenance.person, now, provenance.person);
  return catalogue.database().lastRow();
}

template <class... Values>
void changeRow(const Catalogue& catalogue, const records::Provenance& provenance, const char* table,
               std::int64_t row, const std::string& columns, const Values&... values) {
  catalogue.database().run(change(table, columns), values..., catalogue.now(), provenance.person,
                           row);
}

}  // namespace ostraka::catalogue
