#pragma once
#include <string>

#include "tables/column_mapping.h"
#include "tables/csv.h"

namespace ostraka::tables {

/// A number as a table has it, "12,5 ± 0,3 cm", without what stands behind it.
struct WrittenNumber {
  std::string text;  ///< 12,5
  std::string unit;  ///< as unitNamed() says; empty without one
};
WrittenNumber writtenNumber(const std::string& value);

/// The numbers of a table that are read in two ways (readsOneWay), with either mark, and why. None
/// of a column whose other numbers show which mark is the decimal one, as 12,5 and 0,125 do. A
/// table that Ostraka wrote has points.
NumberRemarks unclearNumbers(const CsvTable& table, const TableMapping& mapping);

/// The measurements that a person has to confirm, and what to check: those that hardly a sherd has,
/// and those far from the others of their column. own: a table of sherds as mapped() gives it.
NumberRemarks doubtfulNumbers(const CsvTable& own, const NumberRemarks& unclear);

}  // namespace ostraka::tables
