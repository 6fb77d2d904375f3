// The sizes of the sides, and the models: both sides together.
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "base/text.h"
#include "cloud/ply.h"
#include "files/json.h"
#include "pairing/common_scale.h"
#include "pipeline/sherd_models.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

ordered_json toJson(const model::Measures& m) {
  return {{"length_mm", m.length_mm},
          {"width_mm", m.width_mm},
          {"thickness_min_mm", m.thickness_min_mm},
          {"thickness_mean_mm", m.thickness_mean_mm},
          {"thickness_max_mm", m.thickness_max_mm},
          {"area_mm2", m.area_mm2},
          {"holes_mm2", m.holes_mm2},
          {"volume_mm3", m.volume_mm3}};
}

// Sherds that were seen all around have gaps of less than a hundredth; with parts of the break
// missing it is a tenth.
std::vector<Message> warningsAbout(const model::SherdModel& model, const model::Measures& measures,
                                   const std::string& number) {
  constexpr double kMostFilled = 0.03;
  std::vector<Message> warnings;
  if (measures.holes_mm2 > 0)
    warnings.push_back(
        message("Sherd %1: its model has a hole right through it (%2 mm²). If the sherd has none, "
                "the photographs do not show that area; reshoot the sherd.",
                number, decimal(measures.holes_mm2, 0)));
  if (model.filled_share > kMostFilled)
    warnings.push_back(
        message("Sherd %1: %2 % of its surface is unseen by any camera and filled in, orange in "
                "its picture; reshoot it if that matters.",
                number, decimal(100 * model.filled_share, 0)));
  return warnings;
}

Result<stages::StageNotes> makeModel(const Run& run, const fs::path& folder,
                                     const std::string& number, const DecidedPair& pair,
                                     const scan::Scan& front, const scan::Scan& back) {
  if (const Result<void> r = writePly(folder / "front.ply", front.cloud, "plate_front"); !r)
    return r.error();
  if (const Result<void> r = writePly(folder / "back.ply", back.cloud, "plate_back"); !r)
    return r.error();
  model::ModelOptions options;
  options.threads = run.options.threads;
  const Result<model::SherdModel> model = model::closeModel(
      front.cloud, back.cloud, pair.front_from_back, options, run.progress, run.stop);
  if (!model && model.error().code == ErrorCode::Cancelled) return model.error();
  if (!model)
    return stages::StageNotes{
        {{"model", false}},
        {message("Sherd %1 has no model: %2", number, model.error().sentence())}};
  if (const Result<void> r = writePly(folder / "model.ply", model->mesh, "plate_front"); !r)
    return r.error();
  const model::Measures measures = model::measure(model->mesh);
  return stages::StageNotes{{{"model", true},
                             {"faces", model->mesh.triangles.size()},
                             {"points_front", front.cloud.size()},
                             {"points_back", back.cloud.size()},
                             {"points_used", model->points_used},
                             {"points_dropped", model->points_dropped},
                             {"noise_mm", model->noise_mm},
                             {"side_gap_mm", model->side_gap_mm},
                             {"filled_share", model->filled_share},
                             {"measures", toJson(measures)}},
                            warningsAbout(*model, measures, number)};
}

}  // namespace

Result<Staged<double>> scaleStage(const Run& run, const Staged<Poses>& poses,
                                  const Staged<std::vector<scan::Scan>>& fronts,
                                  const Staged<std::vector<scan::Scan>>& backs) {
  if (poses.value.has_scale) return Staged<double>{1.0, {}};
  const auto work = [&](const fs::path&) -> Result<stages::StageNotes> {
    pairing::CandidateOptions options;
    options.threads = run.options.threads;
    const Result<double> scale =
        pairing::commonScale(fronts.value, backs.value, options, run.progress, run.stop);
    if (!scale && scale.error().code != ErrorCode::NotEnough) return scale.error();
    if (scale) return stages::StageNotes{{{"front_over_back", *scale}}, {}};
    return stages::StageNotes{{{"front_over_back", 1.0}}, {scale.error().sentence()}};
  };
  const Result<stages::StageRecord> record = runStage(
      run, "scale", {{"fronts", fronts.record.outputs_hash}, {"backs", backs.record.outputs_hash}},
      work);
  if (!record) return record.error();
  return Staged<double>{record->notes.figures.value("front_over_back", 1.0), *record};
}

Result<stages::StageRecord> modelStage(const Run& run, const std::string& number,
                                       const DecidedPair& pair, const scan::Scan& front,
                                       const scan::Scan& back, const std::string& inputs_hash) {
  return runStage(
      run, "model_" + number,
      {{"inputs", inputs_hash},
       {"front", front.id},
       {"back", back.id},
       {"pose", ostraka::toJson(pair.front_from_back)}},
      [&](const fs::path& folder) { return makeModel(run, folder, number, pair, front, back); });
}

}  // namespace ostraka::pipeline
