// The sizes of the sides, and the models: both sides together.
#include <nlohmann/json.hpp>
#include <optional>

#include "base/message.h"
#include "base/part_progress.h"
#include "base/text.h"
#include "cloud/glb.h"
#include "cloud/ply.h"
#include "colour/munsell_proposals.h"
#include "files/files.h"
#include "files/json.h"
#include "model/preview.h"
#include "pairing/common_scale.h"
#include "pipeline/chain.h"
#include "texture/sherd_colours.h"
#include "texture/texture.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using batch::Side;
using nlohmann::ordered_json;

// The GLB is for showing: a tenth of a pixel's size off the model at most.
constexpr double kGlbDeviation_mm = 0.03;
constexpr std::size_t kPointsOfASherd = 2000;  // of a side: they bound what photographs show of it

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

// Each pixel by the photographs' texel, where there are any.
Result<void> writePreview(const fs::path& file, const TriangleMesh& mesh,
                          const std::optional<texture::TexturedMesh>& textured) {
  model::PreviewOptions options;
  if (textured)
    options.color_at = [&](const auto& triangle, const auto& weights) {
      return texture::colourAt(*textured, triangle, weights);
    };
  return writeFileAtomically(
      file, texture::asPng(model::renderPreview(textured ? textured->mesh : mesh, options)));
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

// With what the photographs show; nothing where they show nothing, and the notes say why.
Result<std::optional<texture::TexturedMesh>> texturedOf(const Run& run, const TriangleMesh& mesh,
                                                        const std::string& number,
                                                        const ViewsOfSherd& views,
                                                        Progress& progress,
                                                        stages::StageNotes& notes) {
  using Textured = std::optional<texture::TexturedMesh>;
  const auto plainly = [&](const Error& why) -> Result<Textured> {
    if (why.code == ErrorCode::Cancelled) return why;
    notes.warnings.push_back(
        message("Sherd %1 has no photographic texture: %2", number, why.sentence()));
    return Textured();
  };
  if (!views) return Textured();
  const Result<texture::Shown> shown = views();
  if (!shown) return plainly(shown.error());
  Result<texture::TexturedMesh> textured =
      texture::textured(mesh, shown->views, run.options.threads, progress, run.stop);
  if (!textured) return plainly(textured.error());
  if (run.colours.value)
    textured->texture.picture = run.colours.value->of(textured->texture.picture);
  for (const Error& error : shown->unread)
    notes.warnings.push_back(
        message("The texture of sherd %1 lacks a photograph: %2", number, error.sentence()));
  notes.figures["texel_mm"] = textured->texel_mm;
  notes.figures["texture_seen_share"] = textured->texture.seen_share;
  return Textured(std::move(*textured));
}

// Measured where a chart corrected the photographs, else rough.
colour::MunsellProposals munsellOf(const texture::TexturedMesh& textured,
                                   const std::optional<colour::Correction>& correction) {
  const texture::SherdColours colours = texture::coloursOf(textured);
  colour::MunsellProposals proposals;
  if (colours.outer) proposals.out = colour::proposedFor(*colours.outer);
  if (colours.inner) proposals.in = colour::proposedFor(*colours.inner);
  if (colours.fracture) proposals.core = colour::proposedFor(*colours.fracture);
  proposals.front_is_out = colours.front_is_outer;
  if (correction) proposals.chart = {correction->median, correction->within_95};
  return proposals;
}

// The colours of the scan's points where there are no photographs.
Result<std::string> glbOf(const TriangleMesh& mesh,
                          const std::optional<texture::TexturedMesh>& textured,
                          const GlbExtras& extras) {
  if (!textured) return formatGlb(mesh, extras);
  return formatGlb(textured->mesh,
                   {textured->uv, texture::asJpeg(textured->texture.picture),
                    texture::asPng(textured->texture.seen)},
                   extras);
}

Result<stages::StageNotes> makeModel(const Run& run, const fs::path& folder,
                                     const std::string& number, const DecidedPair& pair,
                                     const scan::Scan& front, const scan::Scan& back,
                                     const ViewsOfSherd& views) {
  if (const Result<void> r = writePly(folder / "front.ply", front.cloud, "plate_front"); !r)
    return r.error();
  if (const Result<void> r = writePly(folder / "back.ply", back.cloud, "plate_back"); !r)
    return r.error();
  model::ModelOptions options;
  options.threads = run.options.threads;
  PartProgress first(run.progress, 0, 2), second(run.progress, 1, 2);
  const Result<model::SherdModel> model =
      model::closeModel(front.cloud, back.cloud, pair.front_from_back, options, first, run.stop);
  if (!model && model.error().code == ErrorCode::Cancelled) return model.error();
  if (!model)
    return stages::StageNotes{
        {{"model", false}},
        {message("Sherd %1 has no model: %2", number, model.error().sentence())}};
  if (const Result<void> r = writePly(folder / "model.ply", model->mesh, "plate_front"); !r)
    return r.error();
  const Result<TriangleMesh> light = model::decimated(model->mesh, kGlbDeviation_mm);
  if (!light) return light.error();
  GlbExtras extras{front.id + "+" + back.id, number, {}, 100 * model->filled_share, {}};
  stages::StageNotes notes;
  const auto textured = texturedOf(run, *light, number, views, second, notes);
  if (!textured) return textured.error();
  if (*textured) {
    notes.figures["munsell"] = colour::toJson(munsellOf(**textured, run.colours.value));
    extras.munsell = notes.figures["munsell"].dump();
  }
  if (const Result<void> r = writeGlb(folder / "model.glb", glbOf(*light, *textured, extras)); !r)
    return r.error();
  if (const Result<void> r = writePreview(folder / "preview.png", model->mesh, *textured); !r)
    return r.error();
  const model::Measures measures = model::measure(model->mesh);
  ordered_json figures = {{"model", true},
                          {"faces", model->mesh.triangles.size()},
                          {"points_front", front.cloud.size()},
                          {"points_back", back.cloud.size()},
                          {"points_used", model->points_used},
                          {"points_dropped", model->points_dropped},
                          {"noise_mm", model->noise_mm},
                          {"side_gap_mm", model->side_gap_mm},
                          {"filled_share", model->filled_share},
                          {"measures", toJson(measures)}};
  figures.update(notes.figures);
  std::vector<Message> warnings = warningsAbout(*model, measures, number);
  warnings.insert(warnings.end(), notes.warnings.begin(), notes.warnings.end());
  return stages::StageNotes{std::move(figures), std::move(warnings)};
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

texture::SherdViews viewsOf(const Run& run, const Poses& poses, const Masks& front_masks,
                            const Masks& back_masks, const std::vector<DecidedPair>& pairs,
                            const std::vector<scan::Scan>& fronts,
                            const std::vector<scan::Scan>& backs) {
  std::vector<texture::Photograph> photographs;
  for (const Side side : {Side::Front, Side::Back}) {
    const Masks& masks = side == Side::Front ? front_masks : back_masks;
    const std::vector<rig::PosedImage> images = poses.of(side);
    for (std::size_t i = 0; i < std::min(images.size(), masks.size()); ++i)
      photographs.push_back({images[i], masks[i]});
  }
  std::vector<texture::Subject> sherds;
  for (const DecidedPair& pair : pairs) {
    texture::Subject sherd{{}, pair.front_from_back};
    const auto take = [&](const PointCloud& cloud) {
      const std::size_t step = cloud.size() / kPointsOfASherd + 1;
      for (std::size_t i = 0; i < cloud.size(); i += step) sherd.points.push_back(cloud.points[i]);
    };
    take(fronts[static_cast<std::size_t>(pair.front)].cloud);
    take(transformed(backs[static_cast<std::size_t>(pair.back)].cloud, pair.front_from_back));
    sherds.push_back(std::move(sherd));
  }
  return {std::move(photographs), std::move(sherds), run.threadsForOriginals()};
}

Result<stages::StageRecord> modelStage(const Run& run, const std::string& number,
                                       const DecidedPair& pair, const scan::Scan& front,
                                       const scan::Scan& back, const ViewsOfSherd& views,
                                       const std::string& inputs_hash) {
  return runStage(run, "model_" + number,
                  {{"inputs", inputs_hash},
                   {"front", front.id},
                   {"back", back.id},
                   {"pose", ostraka::toJson(pair.front_from_back)}},
                  [&](const fs::path& folder) {
                    return makeModel(run, folder, number, pair, front, back, views);
                  });
}

}  // namespace ostraka::pipeline
