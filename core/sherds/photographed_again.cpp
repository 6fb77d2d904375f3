#include "sherds/photographed_again.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "catalogue/history.h"
#include "sherds/kept_models.h"
#include "sherds/measurements.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "sherds/typed_numbers.h"
#include "store/database.h"
#include "store/names.h"

namespace ostraka::sherds {
namespace {

constexpr double kOtherSize =
    0.1;  // two models of one sherd differ by less, also where one is poor

// What the program measured last before `at`, or at all.
std::optional<double> programs(store::Database& database, store::SherdRow sherd, const char* kind,
                               std::int64_t before) {
  return database
      .sql(
          "SELECT value FROM measurement WHERE sherd = ? AND kind = ? AND person IS NULL AND "
          "method = "
          "'program' AND at < ? ORDER BY row DESC LIMIT 1",
          sherd, kind, before)
      .one<std::optional<double>>();
}

// What was described or measured on the draft before its number was known. What both say is
// kept as the known one has it, and stays to be read on the void draft.
void carryOver(const catalogue::Catalogue& catalogue, const records::SherdRecord& known,
               const records::SherdRecord& made, const records::Provenance& provenance) {
  for (const SherdColumn& column : sherdColumns()) {
    const std::string field = column.field.name;
    if (!column.field.editable || column.field.kind == records::FieldKind::Place || column.measure)
      continue;
    if (field == "number" || field == "void_reason") continue;
    const std::string has = textOf(known, field), comes = textOf(made, field);
    if (comes.empty() || comes == has) continue;
    const bool both = field == "note" || field == "joins";
    if (!has.empty() && !both) continue;
    const records::FieldChange said{known.row, field, has.empty() ? comes : has + "; " + comes};
    // What is refused, say a join to itself, stays there too.
    (void)SherdChanges(catalogue).apply(std::span(&said, 1), provenance);
  }

  const store::SherdRow rows[] = {known.row, made.row};
  std::set<std::string> has;
  std::vector<records::Measurement> comes;
  for (const records::Measurement& m : store::valueOrThrow(Measurements(catalogue).byHand(rows))) {
    if (m.sherd == known.row)
      has.insert(m.kind);
    else
      comes.push_back(m);
  }
  for (records::Measurement& m : comes) {
    m.sherd = known.row;
    if (!has.contains(m.kind)) setMeasure(catalogue, m, provenance, MeasureRank::Always);
  }
}

}  // namespace

bool waitsForPhotographs(const catalogue::Catalogue& catalogue, const records::SherdRecord& sherd) {
  if (sherd.number.empty() || sherd.state == records::SherdState::Void || sherd.back ||
      !sherd.model_path.empty())
    return false;
  if (!sherd.front) return true;
  // The last word counts, not that it was once asked for.
  const auto now = store::valueOrThrow(PairDecisions(catalogue).current(sherd.batch));
  return std::any_of(now.begin(), now.end(), [&](const records::PairDecision& d) {
    return d.verdict == records::Verdict::Reshoot && d.front == sherd.front;
  });
}

Result<std::vector<records::SherdRecord>> toPhotographAgain(const catalogue::Catalogue& catalogue) {
  return catalogue.database().asResult([&] {
    const auto rows =
        catalogue.database()
            .sql(
                "SELECT DISTINCT s.row FROM pair_decision d JOIN sherd s ON s.front = d.front "
                "WHERE "
                "d.verdict = 'reshoot' AND s.number <> '' AND s.back IS NULL AND s.model_path = '' "
                "ORDER BY s.number_sort")
            .all<store::SherdRow>();
    std::vector<records::SherdRecord> wanted = store::valueOrThrow(Sherds(catalogue).of(rows));
    const std::map<std::string, std::string> lies_again = typedAndWaiting(catalogue);
    std::erase_if(wanted, [&](const records::SherdRecord& sherd) {
      return !waitsForPhotographs(catalogue, sherd) ||
             lies_again.contains(store::uniqueKey(sherd.number));
    });
    return wanted;
  });
}

Result<std::vector<PhotographedAgain>> photographedAgain(const catalogue::Catalogue& catalogue,
                                                         store::BatchRow batch) {
  return catalogue.database().asResult([&] {
    using P = PhotographedAgain;
    return catalogue.database()
        .sql(
            "SELECT DISTINCT scan.row, s.number, b.number FROM scan "
            "JOIN history h ON h.table_name = 'sherd' AND h.field = 'front' AND h.old = "
            "CAST(scan.row AS TEXT) "
            "JOIN sherd s ON s.row = h.row JOIN batch b ON b.row = s.batch "
            "WHERE scan.batch = ?1 AND s.batch <> ?1 AND s.state <> 'void' AND s.number <> '' "
            "ORDER BY h.number",
            batch)
        .all(&P::front, &P::number, &P::batch_number);
  });
}

Result<std::vector<UnlikeBefore>> unlikeBefore(const catalogue::Catalogue& catalogue,
                                               store::BatchRow batch) {
  return catalogue.database().asResult([&] {
    store::Database& database = catalogue.database();
    std::vector<std::pair<store::SherdRow, std::int64_t>> came;
    {
      store::Statement moved = database.sql(
          "SELECT s.row, max(h.at) FROM sherd s JOIN history h ON h.table_name = 'sherd' AND h.row "
          "= s.row AND h.field = 'batch' WHERE s.batch = ? AND s.number <> '' AND s.state <> "
          "'void' GROUP BY s.row ORDER BY s.number_sort",
          batch);
      store::SherdRow sherd;
      for (std::int64_t at = 0; moved.read(sherd, at);) came.emplace_back(sherd, at);
    }
    std::vector<UnlikeBefore> all;
    for (const auto& [sherd, at] : came) {
      UnlikeBefore worst;
      double most = kOtherSize;
      for (const char* kind : {"length", "width"}) {
        const auto before = programs(database, sherd, kind, at);
        const auto now = programs(database, sherd, kind, std::numeric_limits<std::int64_t>::max());
        if (!before || !now || *before <= 0) continue;
        const double off = std::abs(*now - *before) / *before;
        if (off <= most) continue;
        most = off;
        worst = {store::valueOrThrow(Sherds(catalogue).get(sherd)).number, *before, *now};
      }
      if (!worst.number.empty()) all.push_back(worst);
    }
    return all;
  });
}

void takeOver(const catalogue::Catalogue& catalogue, const records::SherdRecord& known,
              const records::SherdRecord& made, const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  carryOver(catalogue, known, made, provenance);
  for (const records::SherdRecord* sherd : {&known, &made})
    forgetModel(catalogue, sherd->row, provenance);
  database.run("UPDATE sherd SET front = NULL, back = NULL WHERE row = ?", made.row);
  store::valueOrThrow(Sherds(catalogue).voidSherd(made.row, "reshot: " + known.number, provenance));
  // Else it lay on two plates, and could not be typed on a third.
  if (known.batch && known.batch != made.batch)
    forgetTyped(catalogue, known.batch, known.number, provenance);
  database.run("UPDATE sherd SET batch = ?, front = ?, back = ? WHERE row = ?", made.batch,
               made.front, made.back, known.row);
  const auto keep = [&](const char* field, auto before, auto now) {
    catalogue::remember(catalogue, provenance, "sherd", known.row.value, field,
                        before ? std::to_string(before.value) : "",
                        now ? std::to_string(now.value) : "");
  };
  keep("batch", known.batch, made.batch);
  keep("front", known.front, made.front);
  keep("back", known.back, made.back);
}

}  // namespace ostraka::sherds
