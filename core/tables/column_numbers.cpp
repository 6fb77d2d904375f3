#include "tables/column_numbers.h"

#include <algorithm>
#include <string_view>

#include "base/message.h"
#include "store/values.h"
#include "tables/column_names.h"

namespace ostraka::tables {
namespace {

constexpr std::string_view kMarks = ",.";

// What the numbers of a column say about the two marks.
struct MarksSeen {
  bool decimal[2] = {false, false}, thousands[2] = {false, false};
};

void lookAtMarks(std::string_view number, MarksSeen& seen) {
  const std::ptrdiff_t counts[2] = {std::count(number.begin(), number.end(), ','),
                                    std::count(number.begin(), number.end(), '.')};
  if (number.find_first_not_of("0123456789,.+-") != std::string_view::npos &&
      !store::parsedNumber(number))
    return;
  for (const std::size_t mark : {0u, 1u}) {
    if (counts[mark] == 0) continue;
    const bool last = number.find_last_of(kMarks) == number.rfind(kMarks[mark]);
    if (counts[mark] > 1 || !last)
      seen.thousands[mark] = true;
    else if (counts[1 - mark] > 0 || store::readsOneWay(number, kMarks[mark]))
      seen.decimal[mark] = true;
  }
}

bool isOneOf(const CsvTable& table, const char* column) {
  return std::find(table.columns.begin(), table.columns.end(), column) != table.columns.end();
}

// Only the program writes such columns.
bool isOfOstraka(const CsvTable& table, const TableMapping& mapping) {
  if (!mapping.of_contexts) return isOneOf(table, "measured_by_hand");
  for (const char* column : {"excavated_on", "date_edtf", "collected_on", "count_written"})
    if (!isOneOf(table, column)) return false;
  return true;
}

bool hasNumbers(const std::string& field) {
  return !unitsOf(field).empty() || field == "count_written";
}

// What sherds measure; beyond it, and `factor` times off its column, a slip is likelier.
struct Usual {
  const char* field;  ///< its beginning
  double least, most, factor;
};
constexpr Usual kUsual[] = {{"length_mm", 3, 600, 8},    {"width_mm", 2, 600, 8},
                            {"thickness_", 0.5, 100, 8}, {"rim_diameter_mm", 10, 1000, 8},
                            {"rim_pct", 1, 100, 500},    {"weight_g", 0.1, 5000, 500}};

const Usual* usualOf(const std::string& field) {
  const auto* const found =
      std::ranges::find_if(kUsual, [&](const Usual& one) { return field.starts_with(one.field); });
  return found == std::end(kUsual) ? nullptr : found;
}

struct MeasuredRow {
  int line = 0;
  double value = 0;
};

// Whether one of a column's values, which are sorted, is so far from the middle of all others.
bool isFarFromOthers(const std::vector<double>& sorted, double value, double factor) {
  const std::size_t others = sorted.size() - 1;
  if (sorted.size() < 2) return false;
  const auto own = static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) -
                                            sorted.begin());
  const auto isFar = [&](std::size_t of_others) {
    const double other = sorted[of_others < own ? of_others : of_others + 1];
    return std::max(value / other, other / value) >= factor;
  };
  return isFar((others - 1) / 2) && isFar(others / 2);
}

void doubtColumn(const std::vector<MeasuredRow>& rows, const std::string& field,
                 NumberRemarks& doubts) {
  const Usual& usual = *usualOf(field);
  std::vector<double> sorted;
  for (const MeasuredRow& row : rows) sorted.push_back(row.value);
  std::sort(sorted.begin(), sorted.end());
  for (const MeasuredRow& row : rows) {
    const Message value("%1 " + unitsOf(field).front(), {shortDecimal(row.value, 6)});
    if (row.value < usual.least || row.value > usual.most)
      doubts[row.line][field] = message("Check the unit: %1 is unusual for a sherd.", value);
    else if (isFarFromOthers(sorted, row.value, usual.factor))
      doubts[row.line][field] =
          message("Check the unit: %1 is far from the other values of this column.", value);
  }
}

}  // namespace

WrittenNumber writtenNumber(const std::string& value) {
  const NameAndUnit written = valueAndUnit(value);
  return {store::splitPlusMinus(written.name).first, written.unit};
}

NumberRemarks unclearNumbers(const CsvTable& table, const TableMapping& mapping) {
  NumberRemarks unclear;
  const bool points = isOfOstraka(table, mapping);
  for (std::size_t i = 0; i < mapping.columns.size(); ++i) {
    const std::string& field = mapping.columns[i].field;
    if (!hasNumbers(field)) continue;
    MarksSeen seen;
    for (const CsvRow& row : table.rows) lookAtMarks(writtenNumber(cellOf(row, i)).text, seen);
    seen.decimal[1] = seen.decimal[1] || (points && !seen.decimal[0]);
    for (const CsvRow& row : table.rows)
      for (const std::size_t mark : {0u, 1u}) {
        const bool settled = seen.decimal[mark] && !seen.decimal[1 - mark] && !seen.thousands[mark];
        const std::string value = valueAndUnit(cellOf(row, i)).name;
        const Result<void> clear =
            settled ? Result<void>() : store::readsOneWay(value, kMarks[mark]);
        if (!clear) unclear[row.line].emplace(field, clear.error().sentence());
      }
  }
  return unclear;
}

NumberRemarks doubtfulNumbers(const CsvTable& own, const NumberRemarks& unclear) {
  NumberRemarks doubts;
  for (std::size_t i = 0; i < own.columns.size(); ++i) {
    const std::string& field = own.columns[i];
    if (!usualOf(field)) continue;
    std::vector<MeasuredRow> rows;
    for (const CsvRow& row : own.rows) {
      const auto remarks = unclear.find(row.line);
      if (remarks != unclear.end() && remarks->second.contains(field)) continue;
      const Result<double> number = store::parsedNumber(writtenNumber(cellOf(row, i)).text);
      if (number && *number > 0) rows.push_back({row.line, *number});
    }
    doubtColumn(rows, field, doubts);
  }
  return doubts;
}

}  // namespace ostraka::tables
