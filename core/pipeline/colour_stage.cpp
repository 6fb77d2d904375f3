// What a colour chart in the photographs says of the batch's colours.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "base/parallel.h"
#include "batch/photograph.h"
#include "colour/chart.h"
#include "pipeline/chain.h"

namespace ostraka::pipeline {
namespace {

using nlohmann::ordered_json;

constexpr const char* kMatrix = "matrix";

ordered_json rowsOf(const Eigen::Matrix3d& matrix) {
  ordered_json rows = ordered_json::array();
  for (Eigen::Index r = 0; r < 3; ++r) rows.push_back({matrix(r, 0), matrix(r, 1), matrix(r, 2)});
  return rows;
}

std::optional<colour::Correction> correctionOf(const ordered_json& figures) {
  if (!figures.contains(kMatrix)) return std::nullopt;
  colour::Correction correction;
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 3; ++c)
      correction.matrix(r, c) =
          figures[kMatrix][static_cast<std::size_t>(r)][static_cast<std::size_t>(c)].get<double>();
  correction.median = figures["ciede2000_median"].get<double>();
  correction.within_95 = figures["ciede2000_95"].get<double>();
  return correction;
}

// Of a photograph that shows a chart: its patches, or why they are not used.
using ChartFound = std::optional<Result<colour::Patches<Eigen::Vector3d>>>;

// By photograph; one that cannot be read is named by the stages that need it.
std::vector<ChartFound> chartsOf(const Run& run) {
  std::vector<ChartFound> found(run.batch.shots.size());
  parallelFor(found.size(), run.threadsForOriginals(), [&](std::size_t i) {
    if (run.stop.stop_requested()) return;
    const std::string file = run.batch.shots[i].file.string();
    const Result<cv::Mat> photograph = batch::readPhotograph(file);
    if (!photograph) return;
    const std::optional<colour::Chart> chart = colour::findChart(*photograph);
    if (!chart) return;
    if (const Result<colour::Correction> usable = colour::correctionBy(*chart); !usable)
      found[i] = Error{usable.error().code, usable.error().what, file};
    else
      found[i] = chart->light;
  });
  return found;
}

// The plate turns below lights at rest: over all photographs the chart's light evens out, as it
// does in the textures.
colour::Patches<Eigen::Vector3d> meanOf(const std::vector<ChartFound>& charts) {
  colour::Patches<Eigen::Vector3d> mean;
  mean.fill(Eigen::Vector3d::Zero());
  double count = 0;
  for (const ChartFound& chart : charts) {
    if (!chart || !*chart) continue;
    ++count;
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += ((**chart)[i] - mean[i]) / count;
  }
  return mean;
}

Result<stages::StageNotes> findCorrection(const Run& run) {
  const std::vector<ChartFound> charts = chartsOf(run);
  if (run.stop.stop_requested()) return Error::cancelled();
  stages::StageNotes notes;
  const auto used = std::count_if(charts.begin(), charts.end(),
                                  [](const ChartFound& chart) { return chart && *chart; });
  const auto refused = std::find_if(charts.begin(), charts.end(),
                                    [](const ChartFound& chart) { return chart && !*chart; });
  if (used > 0) {
    const colour::Correction correction = colour::fitted(meanOf(charts));
    notes.figures = {{"photographs_with_chart", used},
                     {kMatrix, rowsOf(correction.matrix)},
                     {"ciede2000_median", correction.median},
                     {"ciede2000_95", correction.within_95}};
    run.progress.note(
        NoteLevel::Info,
        message("colours: corrected by the colour chart in %1 photographs; its patches differ from "
                "their reference by %2 (median) and %3 (95 %), CIEDE2000",
                used, decimal(correction.median, 1), decimal(correction.within_95, 1)));
  } else if (refused != charts.end()) {
    notes.warnings.push_back((*refused)->error().sentence());
    run.progress.note(NoteLevel::Warning, notes.warnings.back());
  }
  return notes;
}

}  // namespace

Result<Staged<std::optional<colour::Correction>>> colourStage(const Run& run) {
  const Result<stages::StageRecord> record =
      runStage(run, "colours", {{"batch", run.batch_hash}},
               [&](const std::filesystem::path&) { return findCorrection(run); });
  if (!record) return record.error();
  return Staged<std::optional<colour::Correction>>{correctionOf(record->notes.figures), *record};
}

}  // namespace ostraka::pipeline
