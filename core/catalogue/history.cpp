#include "catalogue/history.h"

#include "records/sherd.h"
#include "records/words.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

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

std::int64_t History::length() const {
  const auto length = firstOf<std::int64_t>("SELECT ifnull(max(number), 0) FROM history");
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
    using H = records::HistoryEntry;
    return database_
        ->sql(
            "SELECT at, person, table_name, field, old, new, why, source, row FROM history WHERE "
            "table_name = ? AND row = ? ORDER BY number DESC",
            table, row)
        .all(&H::at_ms, &H::by, &H::table, &H::field, &H::old_value, &H::new_value, &H::why,
             &H::source, &H::row);
  });
}

}  // namespace ostraka::catalogue
