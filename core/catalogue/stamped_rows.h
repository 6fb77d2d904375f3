#pragma once
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "catalogue/catalogue.h"
#include "records/records.h"

namespace ostraka::catalogue {

/// The SQL of a new row's number, behind all that the table has or its history speaks of: what the
/// history says of a row that was lost must not become that of another.
std::string nextRow(const std::string& table);

/// What a column of a saved record holds; an empty optional and no row are NULL.
struct ColumnValue {
  ColumnValue(std::string text) : stored(std::move(text)) {}
  ColumnValue(const char* text) : stored(std::string(text)) {}
  ColumnValue(double number) : stored(number) {}
  ColumnValue(std::integral auto number) : stored(static_cast<std::int64_t>(number)) {}
  template <class Tag>
  ColumnValue(const store::RowOf<Tag>& row) {
    if (row) stored = row.value;
  }
  template <class T>
  ColumnValue(const std::optional<T>& value) {
    if (value) stored = ColumnValue(*value).stored;
  }
  std::string told() const;  ///< as the history has it; empty for NULL

  std::variant<std::nullptr_t, std::string, std::int64_t, double> stored = nullptr;
};

/// A column of a table that people see, beside what all of those have: id, who made and changed it
/// and when, its revision.
struct Column {
  const char* name;
  ColumnValue value;
  enum class Changes {
    Told,    ///< a row of the history says so
    Untold,  ///< with others, from which it follows
    Never    ///< it is written with a new row alone
  } changes = Changes::Told;
};

/// Compares with what the row holds and remembers each difference; returns whether there is one.
bool rememberDifferences(const Catalogue& catalogue, const records::Provenance& provenance,
                         const char* table, std::int64_t row, const std::vector<Column>& columns);
void changeRow(const Catalogue& catalogue, const records::Provenance& provenance, const char* table,
               std::int64_t row, const std::vector<Column>& columns);
/// Row 0: adds it, with this id (empty: a fresh one); else writes and remembers what is another
/// now. Returns the row.
std::int64_t saveRow(const Catalogue& catalogue, const records::Provenance& provenance,
                     const char* table, std::int64_t row, const std::string& id,
                     const std::vector<Column>& columns);

}  // namespace ostraka::catalogue
