#include "tables/refused_rows.h"

#include <map>
#include <vector>

#include "base/message.h"
#include "tables/csv.h"

namespace ostraka::tables {

std::string refusedRowsCsv(const ImportReport& report,
                           const std::function<std::string(const Message&)>& words) {
  std::vector<Refusal> refusals = report.refusals;
  refusals.insert(refusals.end(), report.questions.begin(), report.questions.end());
  // Behind the values the reason would move those of a row that is too short. Spreadsheets take a
  // file without a mark for one of an older encoding.
  const auto line = [&](std::string first, const std::vector<std::string>& values) {
    std::vector<std::string> all = {std::move(first)};
    // A table from elsewhere may hold formulas, in its header, too.
    for (const std::string& value : values) all.push_back(guarded(unguarded(value)));
    return csvLine(all, report.left_out.separator);
  };
  const std::string head = kRemarkColumn + words(message("why this row was not imported"));
  if (report.left_out.columns.empty()) {
    std::string text = kUtf8Mark + line(head, {words(message("line")), words(message("field")),
                                               words(message("value"))});
    for (const Refusal& refusal : refusals)
      text += line(guarded(words(refusal.reason)),
                   {std::to_string(refusal.line), refusal.column, refusal.value});
    return text;
  }
  std::map<int, std::string> reasons;
  for (const Refusal& refusal : refusals) {
    std::string& reason = reasons[refusal.line];
    if (!reason.empty()) reason += ' ';
    reason +=
        words(refusal.column.empty() ? refusal.reason : about(refusal.column, refusal.reason));
  }
  std::string text = kUtf8Mark + line(head, report.left_out.columns);
  for (const CsvRow& row : report.left_out.rows)
    text += line(guarded(reasons[row.line]), row.values);
  return text;
}

}  // namespace ostraka::tables
