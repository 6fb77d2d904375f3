#include "intake/batch_figures.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "files/json_text.h"
#include "sherds/sherds.h"

namespace ostraka::checks {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MovedCamera, camera, residual_px, moved_mm, turned_rad)
}  // namespace ostraka::checks
namespace ostraka::sherds {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(UnlikeBefore, number, before_mm, now_mm)
}  // namespace ostraka::sherds

namespace ostraka::intake {
// What is kept of a batch; what is absent was not known to the version that kept it.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(BatchFigures, sherds, sure, decided, ask, reshoot,
                                                uncertainty_mm, seconds, draft, counted, moved,
                                                unlike, numbers_left)

namespace {

using nlohmann::json;

std::string figuresKey(const std::string& batch_number) {
  return "queue.figures." + batch_number;
}

}  // namespace

void BatchFigures::take(const review::ReviewCounts& counts) {
  sherds = counts.sherds;
  sure = counts.sure;
  decided = counts.decided;
  ask = counts.ask;
  reshoot = counts.reshoot;
}

std::optional<BatchFigures> keptFigures(const catalogue::Catalogue& catalogue,
                                        const std::string& batch_number) {
  const Result<std::string> text = catalogue::Settings(catalogue).value(figuresKey(batch_number));
  if (!text || text->empty()) return std::nullopt;
  const json kept = jsonOrDiscarded(*text);
  if (!kept.is_object()) return std::nullopt;
  try {
    return kept.get<BatchFigures>();
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::optional<BatchFigures> shownFigures(const catalogue::Catalogue& catalogue,
                                         const std::string& batch_number) {
  std::optional<BatchFigures> figures = keptFigures(catalogue, batch_number);
  const auto batch = catalogue::Batches(catalogue).byNumber(batch_number);
  if (!figures || !batch) return figures;
  if (const auto again = sherds::photographedAgain(catalogue, batch->row))
    figures->again = static_cast<int>(again->size());
  figures->reshoot = std::max(0, figures->reshoot - figures->again);
  const auto isOfBatch = [&](const std::string& sherd_number) {
    const auto row = sherds::Sherds(catalogue).byNumber(sherd_number);
    if (!row || !*row) return false;
    const auto sherd = sherds::Sherds(catalogue).get(*row);
    return sherd && sherd->batch == batch->row;
  };
  std::erase_if(figures->numbers_left, isOfBatch);  // a person gave it since
  std::erase_if(figures->unlike, [&](const auto& sherd) { return !isOfBatch(sherd.number); });
  return figures;
}

Result<void> keepFigures(catalogue::Catalogue& catalogue, const std::string& batch_number,
                         const BatchFigures& figures) {
  return catalogue::Settings(catalogue).setValue(figuresKey(batch_number), json(figures).dump());
}

}  // namespace ostraka::intake
