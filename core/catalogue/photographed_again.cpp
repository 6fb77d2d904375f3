#include "catalogue/photographed_again.h"

#include <algorithm>

#include "catalogue/database.h"
#include "catalogue/history.h"
#include "catalogue/kept_models.h"
#include "catalogue/names.h"
#include "catalogue/sherd_columns.h"
#include "catalogue/values.h"

namespace ostraka::catalogue {

bool waitsForPhotographs(const Catalogue& catalogue, const SherdRecord& sherd) {
  if (sherd.number.empty() || sherd.state == SherdState::Void || sherd.back ||
      !sherd.model_path.empty())
    return false;
  if (!sherd.front) return true;
  // The last word counts, not that it was once asked for.
  const auto now = orRefuse(catalogue.currentDecisions(sherd.batch));
  return std::any_of(now.begin(), now.end(), [&](const PairDecision& d) {
    return d.verdict == Verdict::Reshoot && d.front == sherd.front;
  });
}

Result<std::vector<SherdRecord>> toPhotographAgain(const Catalogue& catalogue) {
  return catalogue.database().door([&] {
    std::vector<SherdRow> rows;
    {
      Statement asked = catalogue.database().sql(
          "SELECT DISTINCT s.row FROM pair_decision d JOIN sherd s ON s.front = d.front WHERE "
          "d.verdict = 'reshoot' AND s.number <> '' AND s.back IS NULL AND s.model_path = '' "
          "ORDER BY s.number_sort");
      while (asked.next()) {
        rows.emplace_back();
        asked >> rows.back();
      }
    }
    std::vector<SherdRecord> waiting = orRefuse(catalogue.sherds(rows));
    std::erase_if(waiting, [&](const SherdRecord& sherd) {
      return !waitsForPhotographs(catalogue, sherd) ||
             typedEverywhere(catalogue, kTypedNumbers + sherd.batch_number)
                 .contains(uniqueKey(sherd.number));
    });
    return waiting;
  });
}

void takeOver(Catalogue& catalogue, const SherdRecord& known, const SherdRecord& made,
              const Act& act) {
  Database& database = catalogue.database();
  for (const SherdRecord* sherd : {&known, &made}) forgetModel(catalogue, sherd->row, act);
  database.sql("UPDATE sherd SET front = NULL, back = NULL WHERE row = ?").with(made.row).run();
  orRefuse(catalogue.voidSherd(made.row, "photographed again: " + known.number, act));
  database.sql("UPDATE sherd SET batch = ?, front = ?, back = ? WHERE row = ?")
      .with(made.batch, made.front, made.back, known.row)
      .run();
  const auto keep = [&](const char* field, auto before, auto now) {
    remember(catalogue, act, "sherd", known.row.value, field,
             before ? std::to_string(before.value) : "", now ? std::to_string(now.value) : "");
  };
  keep("batch", known.batch, made.batch);
  keep("front", known.front, made.front);
  keep("back", known.back, made.back);
}

}  // namespace ostraka::catalogue
