#include "pipeline/report.h"

#include "files/json.h"
#include "files/json_message.h"

namespace ostraka::pipeline {

using nlohmann::ordered_json;

ordered_json reportJson(const ReportInput& input) {
  ordered_json stages = ordered_json::array();
  for (const ReportStage& stage : input.stages)
    stages.push_back({{"stage", stage.name},
                      {"seconds", stage.record.seconds},
                      {"peak_memory_mb", stage.record.peak_memory_mb},
                      {"figures", stage.record.notes.figures}});
  ordered_json sherds = ordered_json::array();
  for (const ReportSherd& sherd : input.sherds) {
    const DecidedPair& pair = *sherd.pair;
    const auto ofFractures = [&](double figure) {
      return pair.fracturesCompared() ? ordered_json(figure) : ordered_json();
    };
    sherds.push_back({{"number", sherd.number},
                      {"front", sherd.front->id},
                      {"back", sherd.back->id},
                      {"score", orNull(pair.score)},
                      {"margin", orNull(pair.margin)},
                      {"ambiguous", pair.ambiguous},
                      {"reason", pair.reason},
                      {"decided_by", pair.decided_by},
                      {"decided_at", pair.decided_at},
                      {"fracture_rms_mm", ofFractures(pair.fracture_rms_mm)},
                      {"fracture_overlap", ofFractures(pair.fracture_overlap)},
                      {"uncertainty_mm", pair.uncertainty_mm},
                      {"figures", sherd.figures}});
  }
  return {{"format", "ostraka-report/1"},
          {"unit", "mm"},
          {"has_scale", input.poses == nullptr || input.poses->has_scale},
          {"scale", toJson(input.scale)},
          {"scale_doubts", toJson(input.scale_doubts)},
          {"draft", input.draft},
          {"decisions", input.decisions},
          {"batch", input.batch_name},
          {"stages", stages},
          {"sherds", sherds},
          {"unpaired_front", input.unpaired_front},
          {"unpaired_back", input.unpaired_back},
          {"set_aside", input.set_aside},
          {"reshoot", input.reshoot},
          {"warnings", input.warnings}};
}

}  // namespace ostraka::pipeline
