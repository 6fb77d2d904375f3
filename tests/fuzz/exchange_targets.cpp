
#include "base/text.h"
#include "metadata/sherd_json.h"
#include "must.h"
#include "sherds/filter.h"
#include "tables/csv.h"
#include "targets.h"

namespace ostraka::fuzz {
void table(std::string_view bytes) {
  const Result<tables::CsvTable> read = tables::parseCsv(bytes, "fuzz.csv");
  if (!read) {
    must(!read.error().what.empty(), "an error has a sentence");
    return;
  }
  std::string written = tables::csvLine(read->columns);
  for (const tables::CsvRow& row : read->rows) {
    for (const std::string& value : row.values) {
      must(isUtf8(value), "values are UTF-8");
      must(tables::unguarded(tables::guarded(value)) == value, "the guard can be taken off");
      if (const Result<sherds::Filter> filter = sherds::parseFilter(value))
        must(sherds::parseFilter(filter->text()).has_value(), "a filter's text is a filter");
    }
    written += tables::csvLine(row.values);
  }
  // A table of one empty column is written as an empty line, which no reader can tell from none.
  if (read->columns.size() < 2 || read->separator != ',') return;
  const Result<tables::CsvTable> again = tables::parseCsv(written, "again.csv");
  must(again.has_value() && again->columns == read->columns &&
           again->rows.size() == read->rows.size(),
       "what was read can be written and read");
  for (std::size_t i = 0; i < read->rows.size(); ++i)
    must(again->rows[i].values == read->rows[i].values, "values survive");
}

void sherdJson(std::string_view bytes) {
  const Result<metadata::ReadSherdJson> read = metadata::parseSherdJson(bytes, "fuzz.json");
  if (!read) {
    must(!read.error().what.empty(), "an error has a sentence");
    return;
  }
  for (const auto& [measurement, by] : read->row.measured)
    must(!measurement.kind.empty() || measurement.unit.empty(), "a measurement has a kind");
}

}  // namespace ostraka::fuzz
