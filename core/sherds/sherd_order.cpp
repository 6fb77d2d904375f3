#include "sherds/sherd_order.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

#include "base/message.h"
#include "sherds/sherd_columns.h"

namespace ostraka::sherds {
namespace {

constexpr int kNotRecorded = -1;

// Which of the values a sherd has, by its row; and how many values there are, in ascending order.
struct Values {
  std::vector<int> of_row;
  int count = 0;
  void set(store::SherdRow row, int value) {
    const auto at = static_cast<std::size_t>(row.value);
    if (at >= of_row.size()) of_row.resize(std::max(at + 1, 2 * of_row.size()), kNotRecorded);
    of_row[at] = value;
  }
  int of(store::SherdRow row) const {
    const auto at = static_cast<std::size_t>(row.value);
    return at < of_row.size() ? of_row[at] : kNotRecorded;
  }
};

// value, row in the order of the value: equal ones follow each other.
template <class Value>
Values sweep(store::Database& database, const std::string& query) {
  Values values;
  store::Statement rows = database.sql(query);
  Value value{}, before{};
  for (store::SherdRow row; rows.read(value, row);) {
    if (values.count == 0 || value != before) {
      before = value;
      ++values.count;
    }
    values.set(row, values.count - 1);
  }
  return values;
}

// A sherd's context, bag or batch has the value, which several of them may share.
Values sweepThrough(store::Database& database, const std::string& reference,
                    const std::string& keys) {
  std::map<std::string, std::vector<std::int64_t>> rows_by_key;
  {
    store::Statement rows = database.sql(keys);
    std::int64_t row = 0;
    std::string key;
    while (rows.read(row, key)) rows_by_key[key].push_back(row);
  }
  std::map<std::int64_t, int> value_of;
  int count = 0;
  for (const auto& [key, rows] : rows_by_key) {
    for (const std::int64_t row : rows) value_of[row] = count;
    ++count;
  }
  Values values;
  values.count = count;
  store::Statement rows = database.sql("SELECT " + reference + ", row FROM sherd WHERE " +
                                       reference + " IS NOT NULL ORDER BY " + reference);
  std::int64_t before = 0;
  int value = kNotRecorded;
  std::int64_t refers = 0;
  store::SherdRow row;
  while (rows.read(refers, row)) {
    if (refers != before) {
      const auto found = value_of.find(refers);
      value = found == value_of.end() ? kNotRecorded : found->second;
      before = refers;
    }
    values.set(row, value);
  }
  return values;
}

Values valuesOf(store::Database& database, const std::string& field) {
  if (field == "updated")
    return sweep<std::int64_t>(database, "SELECT updated_at, row FROM sherd ORDER BY updated_at");
  const SherdColumn* column = sherdColumn(field);
  if (!column || !column->sql) store::refuse(message("The table cannot be sorted by '%1'.", field));
  const std::string name = column->field.name;
  if (column->measure) {
    const std::string measure = column->measure;
    return sweep<double>(database, "SELECT " + measure + ", sherd FROM sherd_measure WHERE " +
                                       measure + " IS NOT NULL ORDER BY " + measure);
  }
  if (name == "site" || name == "trench" || name == "context")
    return sweepThrough(database, "context",
                        "SELECT context.row, " + std::string(column->sql) +
                            " FROM context JOIN site ON site.row = context.site LEFT JOIN trench "
                            "ON trench.row = context.trench WHERE " +
                            column->sql + " IS NOT NULL");
  if (name == "bag") return sweepThrough(database, "bag", "SELECT row, number_key FROM bag");
  if (name == "batch") return sweepThrough(database, "batch", "SELECT row, number FROM batch");
  if (name == "scale")
    return sweepThrough(database, "batch",
                        "SELECT row, 'doubtful' FROM batch WHERE scale_doubts <> ''");
  // A text, or terms as JSON; the table's columns are called as the fields are.
  const std::string text = name == "uuid" ? "id" : name;
  const std::string nothing = column->terms ? "'[]'" : "''";
  return sweep<std::string>(database, "SELECT " + text + ", row FROM sherd WHERE " + text + " <> " +
                                          nothing + " ORDER BY " + text);
}

}  // namespace

std::vector<store::SherdRow> inOrder(store::Database& database,
                                     const std::vector<store::SherdRow>& by_number,
                                     const records::SherdOrder& order) {
  const Values values = valuesOf(database, order.field);
  const int count = values.count;
  const auto slotOf = [&](store::SherdRow row) {
    const int value = values.of(row);
    if (value == kNotRecorded) return count;
    return order.descending ? count - 1 - value : value;
  };
  // Each value's rows keep the order by number in which they come.
  std::vector<std::size_t> begins(static_cast<std::size_t>(count) + 2, 0);
  for (const store::SherdRow& row : by_number) ++begins[static_cast<std::size_t>(slotOf(row)) + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<store::SherdRow> ordered(by_number.size());
  for (const store::SherdRow& row : by_number)
    ordered[begins[static_cast<std::size_t>(slotOf(row))]++] = row;
  return ordered;
}

}  // namespace ostraka::sherds
