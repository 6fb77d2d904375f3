#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ostraka::tables {

/// A column of the exported tables.
struct ColumnMeaning {
  const char *column, *unit, *meaning;  ///< unit: "" for texts
};
/// Of sherds.csv and contexts.csv, in their order; a column of both is there once.
const std::vector<ColumnMeaning>& columnMeanings();

/// A measure as tables have it: three decimals at most. Records (JSON) have all.
std::string tableNumber(double value);
/// Whether a number, typed or from a table, is the value as far as a table shows it.
bool showsInTable(std::string_view typed, double value);

}  // namespace ostraka::tables
