#pragma once
#include <string>
#include <vector>

#include "base/result.h"

namespace ostraka::tables {

/// One sheet of a spreadsheet, written row by row. The first row is a header that is repeated on
/// each printed page.
class OdsSheet {
 public:
  struct Column {
    std::string name;
    bool number = false;  ///< values are decimal numbers with a point; an empty one is no value
  };
  OdsSheet(const std::string& name, std::vector<Column> columns);
  void row(const std::vector<std::string>& values);  ///< UTF-8, one for each column

 private:
  friend Result<std::string> formatOds(const std::vector<OdsSheet>& sheets);
  std::vector<Column> columns_;
  std::string xml_;
};

/// OpenDocument spreadsheet (ODF 1.2). A text is never taken for a formula or a number. Errors:
/// UnusableInput beyond 4 GiB.
Result<std::string> formatOds(const std::vector<OdsSheet>& sheets);

}  // namespace ostraka::tables
