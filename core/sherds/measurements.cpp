#include "sherds/measurements.h"

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/history.h"
#include "records/sherd.h"
#include "sherds/sherd_columns.h"
#include "store/values.h"

namespace ostraka::sherds {
namespace {

constexpr const char* kProgram = "program";

struct Current {
  std::int64_t row = 0;
  double value = 0;
  store::PersonRow by;
  std::string model_sha256, method;
  std::optional<double> uncertainty;
};

Current currentOf(store::Database& database, store::SherdRow sherd, const std::string& kind) {
  Current current;
  store::Statement rows = database.sql(
      "SELECT row, value, person, model_sha256, method, uncertainty FROM measurement WHERE sherd = "
      "? AND kind = ? AND current = 1",
      sherd, kind);
  rows.read(current.row, current.value, current.by, current.model_sha256, current.method,
            current.uncertainty);
  return current;
}

constexpr const char* kCurrent =
    "SELECT sherd, kind, unit, value, uncertainty, method, person, model_sha256 FROM measurement "
    "WHERE current = 1 ";

std::vector<records::Measurement> readAll(store::Statement rows) {
  using M = records::Measurement;
  return rows.all(&M::sherd, &M::kind, &M::unit, &M::value, &M::uncertainty, &M::method, &M::by,
                  &M::model_sha256);
}

void show(store::Database& database, store::SherdRow sherd, const std::string& kind,
          const std::optional<double>& value) {
  database.run("UPDATE sherd_measure SET " + kind + " = ? WHERE sherd = ?", value, sherd);
}

}  // namespace

std::string measurementText(double value, const std::optional<double>& uncertainty) {
  return store::numberText(value) +
         (uncertainty ? " ± " + store::numberText(*uncertainty) : std::string());
}

ComputedMeasures computedMeasures(const catalogue::Catalogue& catalogue, store::SherdRow sherd) {
  ComputedMeasures computed;
  store::Statement rows = catalogue.database().sql(
      "SELECT kind, value, current FROM measurement WHERE sherd = ? AND person IS NULL AND method "
      "= 'program' ORDER BY row",
      sherd);
  std::string kind;
  double value = 0;
  bool current = false;
  while (rows.read(kind, value, current)) {
    computed.values[kind] = value;
    if (current) computed.current.insert(kind);
  }
  return computed;
}

void setMeasure(const catalogue::Catalogue& catalogue, const records::Measurement& m,
                const records::Provenance& provenance, MeasureRank rank) {
  const std::string unit = records::unitOf(m.kind);
  if (unit.empty()) store::refuse(message("There is no measurement of this kind."), m.kind);
  if (!(m.value >= 0)) store::refuse(message("A measurement cannot be less than 0."), m.kind);
  store::Database& database = catalogue.database();
  const Current old = currentOf(database, m.sherd, m.kind);
  if (old.row && old.value == m.value && old.by == m.by && old.method == m.method &&
      old.model_sha256 == m.model_sha256 && old.uncertainty == m.uncertainty)
    return;
  // What a person measured, named or not, stays above what the program computes.
  const bool by_hand = old.row && (old.by || old.method != kProgram);
  const bool counts = rank == MeasureRank::Always || !(by_hand && !m.by && m.method == kProgram);
  if (counts && old.row) database.run("UPDATE measurement SET current = 0 WHERE row = ?", old.row);
  if (!counts) {
    store::Statement same = database.sql(
        "SELECT 1 FROM measurement WHERE sherd = ? AND kind = ? AND person IS NULL AND value = ? "
        "AND model_sha256 = ?",
        m.sherd, m.kind, m.value, m.model_sha256);
    if (same.next()) return;
  }
  database.run(
      "INSERT INTO measurement (id, at, person, sherd, kind, value, unit, uncertainty, "
      "method, model_sha256, replaces, current) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      newId(catalogue.now()), catalogue.now(), m.by, m.sherd, m.kind, m.value, unit, m.uncertainty,
      m.method, m.model_sha256, old.row ? std::optional(old.row) : std::optional<std::int64_t>(),
      counts);
  if (!counts) return;
  show(database, m.sherd, m.kind, m.value);
  catalogue::remember(catalogue, provenance, "sherd", m.sherd.value, m.kind,
                      old.row ? measurementText(old.value, old.uncertainty) : std::string(),
                      measurementText(m.value, m.uncertainty));
}

void clearMeasure(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                  const std::string& kind, const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  const Current old = currentOf(database, sherd, kind);
  if (!old.row) return;
  database.run("UPDATE measurement SET current = 0 WHERE row = ?", old.row);
  show(database, sherd, kind, std::nullopt);
  catalogue::remember(catalogue, provenance, "sherd", sherd.value, kind,
                      measurementText(old.value, old.uncertainty), "");
}

void typeMeasure(const catalogue::Catalogue& catalogue, const records::Measurement& typed,
                 const records::Provenance& provenance) {
  records::Measurement m = typed;
  m.by = provenance.person;
  if (m.uncertainty == 0.0) m.uncertainty.reset();
  // Who types what was there before (undo does) restores it with its method.
  store::Statement rows = catalogue.database().sql(
      "SELECT person, method, model_sha256, uncertainty FROM measurement WHERE sherd = ?1 AND kind "
      "= ?2 AND value = ?3 AND (?4 IS NULL OR ifnull(uncertainty, 0) = ?4) ORDER BY row DESC "
      "LIMIT 1",
      m.sherd, m.kind, m.value, typed.uncertainty);
  records::Measurement was = m;
  rows.read(was.by, was.method, was.model_sha256, was.uncertainty);
  const bool of_program = !was.by && was.method == kProgram;
  const Current now = currentOf(catalogue.database(), m.sherd, m.kind);
  // Over what the program says nobody restores it: a person measured what an earlier model had.
  if (!of_program || !(now.row && !now.by && now.method == kProgram)) m = was;
  if (!m.by && m.method == kProgram) {  // what it says of the model that is there now
    store::Statement latest = catalogue.database().sql(
        "SELECT value, model_sha256, uncertainty FROM measurement WHERE sherd = ? AND kind = ? AND "
        "person IS NULL AND method = 'program' ORDER BY row DESC LIMIT 1",
        m.sherd, m.kind);
    latest.read(m.value, m.model_sha256, m.uncertainty);
  }
  setMeasure(catalogue, m, provenance, MeasureRank::Always);
}

Result<void> Measurements::add(const records::Measurement& m,
                               const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    records::Measurement measured = m;
    measured.by = provenance.person;
    setMeasure(catalogue_, measured, provenance, MeasureRank::PersonFirst);
  });
}

Result<std::vector<records::Measurement>> Measurements::of(store::SherdRow sherd) const {
  return database_->asResult([&] {
    return readAll(database_->sql(std::string(kCurrent) + "AND sherd = ? ORDER BY row", sherd));
  });
}

Result<std::vector<records::Measurement>> Measurements::byHand(
    std::span<const store::SherdRow> sherds) const {
  return database_->asResult([&] {
    return readAll(database_->sql(std::string(kCurrent) +
                                      "AND method <> 'program' AND sherd IN (SELECT value FROM "
                                      "json_each(?)) ORDER BY sherd, row",
                                  rowsJson(sherds)));
  });
}

Result<std::vector<double>> Measurements::everComputed(store::SherdRow sherd,
                                                       const std::string& kind) const {
  return allOf<double>(
      "SELECT value FROM measurement WHERE sherd = ? AND kind = ? AND person IS NULL AND method = "
      "'program'",
      sherd, kind);
}

}  // namespace ostraka::sherds
