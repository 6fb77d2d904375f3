#include "intake/batch_figures.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "files/json_text.h"
#include "sherds/sherds.h"

namespace ostraka::intake {
namespace {

using nlohmann::json;

std::string figuresKey(const std::string& batch_number) {
  return "queue.figures." + batch_number;
}

BatchFigures figuresFrom(const json& kept) {
  BatchFigures figures;
  figures.sherds = kept.value("sherds", 0);
  figures.sure = kept.value("sure", 0);
  figures.decided = kept.value("decided", 0);
  figures.ask = kept.value("ask", 0);
  figures.reshoot = kept.value("reshoot", 0);
  figures.uncertainty_mm = kept.value("uncertainty_mm", 0.0);
  figures.seconds = kept.value("seconds", 0.0);
  figures.draft = kept.value("draft", false);
  figures.counted = kept.value("counted", 0);
  for (const json& camera : kept.value("moved", json::array()))
    figures.moved.push_back({camera.at("camera"), camera.at("residual_px"), camera.at("moved_mm"),
                             camera.at("turned_rad")});
  for (const json& sherd : kept.value("unlike", json::array()))
    figures.unlike.push_back({sherd.at("number"), sherd.at("before_mm"), sherd.at("now_mm")});
  figures.numbers_left = kept.value("numbers_left", std::vector<std::string>());
  return figures;
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
    return figuresFrom(kept);
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
  json kept = {{"sherds", figures.sherds},   {"sure", figures.sure},
               {"decided", figures.decided}, {"ask", figures.ask},
               {"reshoot", figures.reshoot}, {"uncertainty_mm", figures.uncertainty_mm},
               {"seconds", figures.seconds}, {"draft", figures.draft},
               {"counted", figures.counted}, {"moved", json::array()},
               {"unlike", json::array()},    {"numbers_left", figures.numbers_left}};
  for (const checks::MovedCamera& camera : figures.moved)
    kept["moved"].push_back({{"camera", camera.camera},
                             {"residual_px", camera.residual_px},
                             {"moved_mm", camera.moved_mm},
                             {"turned_rad", camera.turned_rad}});
  for (const sherds::UnlikeBefore& sherd : figures.unlike)
    kept["unlike"].push_back(
        {{"number", sherd.number}, {"before_mm", sherd.before_mm}, {"now_mm", sherd.now_mm}});
  return catalogue::Settings(catalogue).setValue(figuresKey(batch_number), kept.dump());
}

}  // namespace ostraka::intake
