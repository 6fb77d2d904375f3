#include "catalogue/stamped_rows.h"

#include <algorithm>

namespace ostraka::catalogue {
namespace {

// Each of the names with this behind it.
std::string each(const std::string& names, const std::string& behind) {
  std::string list;
  for (const char c : names + " ") list += c == ' ' ? behind : std::string(1, c);
  return list;
}

}  // namespace

std::string nextRow(const std::string& table) {
  return "1 + max(ifnull((SELECT max(row) FROM " + table +
         "), 0), ifnull((SELECT max(row) FROM history WHERE table_name = '" + table + "'), 0))";
}

std::string insertion(const std::string& table, const std::string& columns) {
  std::string marks;
  for (auto more = 1 + std::ranges::count(columns, ' '); more > 0; --more) marks += "?, ";
  return "INSERT INTO " + table + " (" + each(columns, ", ") +
         "id, created_at, created_by, updated_at, updated_by, row) VALUES (" + marks +
         "?, ?, ?, ?, ?, " + nextRow(table) + ")";
}

std::string change(const std::string& table, const std::string& columns) {
  return "UPDATE " + table + " SET " + each(columns, " = ?, ") +
         "updated_at = ?, updated_by = ?, revision = revision + 1 WHERE row = ?";
}

}  // namespace ostraka::catalogue
