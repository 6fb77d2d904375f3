#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ostraka::exchange {

/// A column of the exported tables.
struct ColumnMeaning {
  const char *column, *unit, *meaning;  ///< unit: "" for texts
};
/// Of sherds.csv and contexts.csv, in their order; a column of both is there once.
const std::vector<ColumnMeaning>& columnMeanings();

}  // namespace ostraka::exchange
