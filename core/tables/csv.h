#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace ostraka::tables {

struct CsvRow {
  int line = 0;  ///< where the row begins in the file, from 1
  std::vector<std::string> values;
};
struct CsvTable {
  std::vector<std::string> columns;  ///< the header, trimmed
  std::vector<CsvRow> rows;
  char separator = ',';
};

/// Without blanks at its ends and without the guard against formulas; empty where the row is short.
std::string cellOf(const CsvRow& row, std::size_t column);

/// Begins the name of a column of remarks in any language.
constexpr const char* kRemarkColumn = "Ostraka: ";
constexpr const char* kUtf8Mark = "\xEF\xBB\xBF";

/// RFC 4180. UTF-8 with or without BOM, UTF-16 with BOM; the separator (, ; or tabulator) is taken
/// from the header, or from a line before it, sep=; as Excel reads and writes it; line ends CRLF,
/// LF or CR; empty lines are left out. At most 1,000,000 rows, 1,000 columns and 1 MB a field. A
/// vertical tab in a value is a line end. Columns are named without the guard against formulas;
/// those with remarks of the program (kRemarkColumn) are left out. Errors name the line.
Result<CsvTable> parseCsv(std::string_view bytes, const std::string& where);

/// CRLF; values with any separator, a quotation mark or a line end are quoted.
std::string csvLine(const std::vector<std::string>& values, char separator = ',');

/// A spreadsheet takes a text that begins with = + - @, also as wide letters (＝ ＋ － ＠), or with
/// tab, CR or LF for a formula: such texts, also behind quotes, get one ' more, which the import
/// takes off again. Any text survives both.
std::string guarded(std::string_view text);
std::string unguarded(std::string_view text);

}  // namespace ostraka::tables
