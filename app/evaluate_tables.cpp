#include "evaluate_tables.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "files/json.h"

namespace ostraka::app {
namespace {

using namespace ostraka::evaluate;
using nlohmann::ordered_json;

std::string figure(const std::optional<double>& value, int digits = 3) {
  return value ? formatted("%.*f", digits, *value) : "-";
}

std::string verdictWords(const PairVerdict& v) {
  std::string text = v.right ? "right" : v.silent_error ? "SILENT ERROR" : "wrong";
  if (v.pair.ambiguous) text += ", flagged";
  if (v.error.slipped) text += ", slipped";
  if (v.right && v.transform == TransformState::None) text += ", T missing";
  if (v.right && v.transform == TransformState::NotRigid) text += ", T not rigid";
  return text;
}

std::string partLine(const char* name, const PartFigures& part) {
  return formatted(
      "  %-5s %8zu points, bias %s mm, robust SD %s mm, 90 %% within %s mm, normals off by "
      "%s degrees (median), %s %% of the truth covered\n",
      name, part.points, figure(part.bias_mm).c_str(), figure(part.sd_mm).c_str(),
      figure(part.within_90_mm).c_str(), figure(part.normal_deg, 0).c_str(),
      figure(part.covered_percent, 1).c_str());
}

ordered_json partJson(const PartFigures& part) {
  return {{"points", part.points},
          {"bias_mm", orNull(part.bias_mm)},
          {"sd_mm", orNull(part.sd_mm)},
          {"acc90_mm", orNull(part.within_90_mm)},
          {"normal_deg", orNull(part.normal_deg)},
          {"complete_pct", orNull(part.covered_percent)}};
}

}  // namespace

std::string table(const BatchEvaluation& batch) {
  std::string text = formatted("  %-6s %-6s %7s %10s %10s %8s %8s\n", "sherd", "model", "overlap",
                               "accuracy", "complete %", "MAE", "SD");
  for (const SherdFigures& s : batch.sherds) {
    if (!s.model)
      text += formatted("  %-6s NONE\n", s.sherd.c_str());
    else
      text += formatted("  %-6s %-6s %7.2f %10.3f %10.2f %8.3f %8.3f\n", s.sherd.c_str(),
                        s.model->c_str(), s.overlap, s.figures.accuracy_mm,
                        s.figures.completeness_percent, s.figures.mean_mm, s.figures.sd_mm);
  }
  return text + formatted(
                    "models: mean of %zu: accuracy %.3f mm, completeness %.2f %%, MAE %.3f mm, SD "
                    "%.3f mm; completeness with missing sherds as 0: %.2f %%; missing %d, "
                    "superfluous models %zu\n",
                    batch.sherds.size() - static_cast<std::size_t>(batch.missing),
                    batch.accuracy_mm, batch.completeness_percent, batch.mean_mm, batch.sd_mm,
                    batch.completeness_missing_as_zero_percent, batch.missing,
                    batch.superfluous.size());
}

std::string table(const ModelFigures& f) {
  return formatted(
      "model: accuracy (90 %%) %.3f mm, completeness (0.25 mm) %.2f %%, MAE %.3f mm, SD "
      "%.3f mm, max %.2f mm; %zu model samples, %zu truth samples\n",
      f.accuracy_mm, f.completeness_percent, f.mean_mm, f.sd_mm, f.max_mm, f.model_samples,
      f.truth_samples);
}

std::string table(const CloudFigures& figures, const std::string& side) {
  return "cloud of the " + side + ":\n" + partLine("flat", figures.flat) +
         partLine("strip", figures.strip) +
         formatted("  outliers (over 2 mm from any sherd): %.2f %% of %zu points\n",
                   figures.outlier_percent, figures.points);
}

std::string table(const PairsEvaluation& set) {
  std::string text = formatted("%s: %d true pairs\n  %-8s %-8s %-22s %9s %9s %9s %12s\n",
                               set.set.c_str(), set.true_pairs, "front", "back", "verdict",
                               "rms mm", "rot deg", "shift mm", "fracture rms");
  std::vector<PairVerdict> sorted = set.verdicts;
  std::sort(sorted.begin(), sorted.end(),
            [](const PairVerdict& a, const PairVerdict& b) { return a.pair.front < b.pair.front; });
  for (const PairVerdict& v : sorted) {
    const bool measured = v.transform == TransformState::Measured;
    const auto shown = [&](double value) {
      return figure(measured ? std::optional<double>(value) : std::nullopt);
    };
    text += formatted("  %-8s %-8s %-22s %9s %9s %9s %12s\n", v.pair.front.c_str(),
                      v.pair.back.c_str(), verdictWords(v).c_str(), shown(v.error.rms_mm).c_str(),
                      shown(v.error.rotation_deg).c_str(), shown(v.error.shift_mm).c_str(),
                      figure(v.pair.fracture_rms_mm).c_str());
  }
  const auto list = [&](const char* title, const std::vector<std::string>& names) {
    if (!names.empty()) text += title + (" " + joined(names, " ")) + "\n";
  };
  list("  missed pairs (fronts):", set.missed);
  list("  scans named nowhere:", set.forgotten);
  if (set.unseen > 0) text += formatted("  sherds of which a side has no scan: %d\n", set.unseen);
  return text;
}

std::string table(const PairsSummary& s) {
  return formatted(
             "pairs: right %d of %d (%.1f %%), wrong %d, silent errors %d, flagged %d (of these "
             "wrong %d), missed %d, lone scans left alone %d of %d\n",
             s.right, s.true_pairs, s.right_percent, s.wrong, s.silent_errors, s.flagged,
             s.flagged_wrong, s.missed, s.lone_right, s.lone) +
         formatted(
             "registration of right pairs: RMS median %.3f, 95 %% %.3f, max %.3f mm; <= 0.10 mm: "
             "%.1f %%, <= 0.05 mm: %.1f %%; of all true pairs <= 0.10 mm: %.1f %%; slipped %d, "
             "none %d\n",
             s.rms_median_mm, s.rms_p95_mm, s.rms_max_mm, s.share_within_0_10_percent,
             s.share_within_0_05_percent, s.share_of_true_within_0_10_percent, s.slipped,
             s.not_registered);
}

std::string table(const MaskFigures& figures, int count, double worst,
                  const std::string& worst_name) {
  return formatted(
      "masks: IoU %.4f over %d photographs (least %.4f, %s); edge %+.2f px (median, + = too "
      "large), %.2f px (mean), 95 %% within %.2f px\n",
      figures.intersectionOverUnion(), count, worst, worst_name.c_str(), figures.edgeBias_px(),
      figures.edgeMean_px(), figures.edgeWithin95_px());
}

ordered_json toJson(const ModelFigures& f) {
  return {{"accuracy_mm", f.accuracy_mm},
          {"completeness_pct", f.completeness_percent},
          {"mae_mm", f.mean_mm},
          {"sd_mm", f.sd_mm},
          {"rms_mm", f.rms_mm},
          {"max_mm", f.max_mm},
          {"truth_to_model_p90_mm", f.truth_to_model_p90_mm},
          {"model_samples", f.model_samples},
          {"truth_samples", f.truth_samples},
          {"faces", f.faces},
          {"aligned_by_mm", f.aligned_by_mm},
          {"aligned_by_deg", f.aligned_by_deg}};
}

ordered_json toJson(const BatchEvaluation& batch) {
  ordered_json sherds = ordered_json::array();
  for (const SherdFigures& s : batch.sherds) {
    ordered_json row = {{"id", s.sherd}, {"model", nullptr}};
    if (s.model) {
      row["model"] = *s.model;
      row["overlap"] = s.overlap;
      row.update(toJson(s.figures));
    }
    sherds.push_back(std::move(row));
  }
  return {{"mean",
           {{"accuracy_mm", batch.accuracy_mm},
            {"completeness_pct", batch.completeness_percent},
            {"mae_mm", batch.mean_mm},
            {"sd_mm", batch.sd_mm}}},
          {"completeness_missing_as_zero_pct", batch.completeness_missing_as_zero_percent},
          {"missing", batch.missing},
          {"superfluous", batch.superfluous},
          {"sherds", sherds}};
}

ordered_json toJson(const CloudFigures& figures) {
  return {{"points", figures.points},
          {"stray_pct", figures.outlier_percent},
          {"flat", partJson(figures.flat)},
          {"strip", partJson(figures.strip)}};
}

ordered_json toJson(const PairsEvaluation& set, const PairsSummary& s) {
  ordered_json rows = ordered_json::array();
  for (const PairVerdict& v : set.verdicts) {
    ordered_json row = {{"front", v.pair.front},
                        {"back", v.pair.back},
                        {"right", v.right},
                        {"ambiguous", v.pair.ambiguous},
                        {"silent", v.silent_error},
                        {"score", orNull(v.pair.score)},
                        {"margin", orNull(v.pair.margin)},
                        {"fracture_rms_mm", orNull(v.pair.fracture_rms_mm)}};
    if (v.transform == TransformState::Measured)
      row.update(ordered_json{{"rms_mm", v.error.rms_mm},
                              {"rot_deg", v.error.rotation_deg},
                              {"shift_mm", v.error.shift_mm},
                              {"across_share", orNull(v.error.across_share)},
                              {"slipped", v.error.slipped}});
    else if (v.right)
      row["registration"] = v.transform == TransformState::NotRigid ? "not rigid" : "missing";
    else
      row["truth_among_alternatives"] = v.truth_among_alternatives;
    rows.push_back(std::move(row));
  }
  return {{"summary",
           {{"true_pairs", s.true_pairs},
            {"right", s.right},
            {"right_pct", s.right_percent},
            {"wrong", s.wrong},
            {"silent_errors", s.silent_errors},
            {"flagged", s.flagged},
            {"flagged_wrong", s.flagged_wrong},
            {"missed", s.missed},
            {"forgotten_scans", s.forgotten},
            {"lone", s.lone},
            {"lone_right", s.lone_right},
            {"rms_median_mm", orNull(s.rms_median_mm)},
            {"rms_p95_mm", orNull(s.rms_p95_mm)},
            {"rms_max_mm", orNull(s.rms_max_mm)},
            {"share_rms_le_0_10_pct", s.share_within_0_10_percent},
            {"share_rms_le_0_05_pct", s.share_within_0_05_percent},
            {"share_of_all_true_pairs_le_0_10_pct", s.share_of_true_within_0_10_percent},
            {"slipped", s.slipped},
            {"not_registered", s.not_registered}}},
          {"missed", set.missed},
          {"forgotten", set.forgotten},
          {"rows", rows}};
}

ordered_json toJson(const MaskFigures& figures, int count, double worst,
                    const std::string& worst_name) {
  return {{"photographs", count},
          {"iou", figures.intersectionOverUnion()},
          {"least_iou", worst},
          {"least", worst_name},
          {"edge_bias_px", figures.edgeBias_px()},
          {"edge_mean_px", figures.edgeMean_px()},
          {"edge_95_px", figures.edgeWithin95_px()}};
}

}  // namespace ostraka::app
