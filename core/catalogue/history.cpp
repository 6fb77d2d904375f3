#include "catalogue/history.h"

#include "records/sherd.h"
#include "records/words.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

constexpr const char* kHistory =
    "SELECT at, person, table_name, field, old, new, why, source, row FROM history ";

std::vector<records::HistoryEntry> readHistory(store::Statement rows) {
  std::vector<records::HistoryEntry> all;
  for (records::HistoryEntry h; rows.read(h.at_ms, h.by, h.table, h.field, h.old_value, h.new_value,
                                          h.why, h.source, h.row);)
    all.push_back(h);
  return all;
}

// The history keeps scans and batches of a sherd by their rows, which tell a person nothing: b004
// of B0001 is "B0001 b004".
std::string rowAsNamed(store::Database& database, const std::string& field, std::string value) {
  const bool batch = field == "batch";
  if (value.empty() || (!batch && field != "front" && field != "back")) return value;
  database
      .sql(batch ? "SELECT number FROM batch WHERE row = CAST(? AS INTEGER)"
                 : "SELECT b.number || ' ' || s.name FROM scan s JOIN batch b ON b.row = s.batch "
                   "WHERE s.row = CAST(? AS INTEGER)",
           value)
      .read(value);
  return value;
}

Message gone(std::string_view table) {
  if (table == "batch") return message("This batch is no longer in the catalogue.");
  if (table == "photograph") return message("This photograph is no longer in the catalogue.");
  if (table == "scan") return message("This scan is no longer in the catalogue.");
  if (table == "file") return message("This file is no longer in the catalogue.");
  if (table == "person") return message("This person is no longer in the catalogue.");
  if (table == "site") return message("This site is no longer in the catalogue.");
  if (table == "trench") return message("This trench is no longer in the catalogue.");
  if (table == "context") return message("This context is no longer in the catalogue.");
  if (table == "bag") return message("This bag is no longer in the catalogue.");
  return message("A sherd is no longer in the catalogue.");
}

}  // namespace

void remember(const Catalogue& catalogue, const records::Provenance& provenance, const char* table,
              std::int64_t row, const std::string& field, const std::string& old_value,
              const std::string& new_value) {
  if (old_value == new_value) return;
  catalogue.database().run(
      "INSERT INTO history (at, person, table_name, row, field, old, new, why, source) VALUES "
      "(?, ?, ?, ?, ?, ?, ?, ?, ?)",
      catalogue.now(), provenance.person, table, row, field, old_value, new_value, provenance.why,
      provenance.source);
}

bool rememberDifferences(const Catalogue& catalogue, const records::Provenance& provenance,
                         const char* table, std::int64_t row,
                         const std::vector<SavedField>& fields) {
  std::string columns;
  for (const SavedField& field : fields) {
    if (!columns.empty()) columns += ", ";
    columns += field.name;
  }
  // Numbers are read with all their digits, so that only a real difference counts.
  std::vector<std::string> old_values(fields.size());
  {
    store::Statement rows =
        catalogue.database().sql("SELECT " + columns + " FROM " + table + " WHERE row = ?", row);
    if (!rows.next()) store::refuse(gone(table));
    for (std::string& value : old_values) rows.readText(value);
  }
  bool any = false;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (old_values[i] == fields[i].value) continue;
    remember(catalogue, provenance, table, row, fields[i].name, old_values[i], fields[i].value);
    any = true;
  }
  return any;
}

std::int64_t History::length() const {
  const Result<std::int64_t> length = database_->asResult([&] {
    return database_->sql("SELECT ifnull(max(number), 0) FROM history").one<std::int64_t>();
  });
  return length ? *length : 0;
}

Result<std::vector<records::HistoryEntry>> History::of(store::SherdRow sherd) const {
  return database_->asResult([&] {
    std::vector<records::HistoryEntry> all = store::valueOrThrow(of("sherd", sherd.value));
    for (records::HistoryEntry& entry : all)
      for (std::string* value : {&entry.old_value, &entry.new_value})
        *value = rowAsNamed(*database_, entry.field, std::move(*value));
    return all;
  });
}

Result<std::vector<records::HistoryEntry>> History::of(const std::string& table,
                                                       std::int64_t row) const {
  return database_->asResult([&] {
    return readHistory(database_->sql(
        std::string(kHistory) + "WHERE table_name = ? AND row = ? ORDER BY number DESC", table,
        row));
  });
}

}  // namespace ostraka::catalogue
