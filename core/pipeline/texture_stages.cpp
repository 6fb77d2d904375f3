// What the photographs show of the models: both sides together, all sherds below one light.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "cloud/glb.h"
#include "cloud/ply.h"
#include "files/files.h"
#include "images/png_image.h"
#include "model/preview.h"
#include "pipeline/sherd_models.h"
#include "texture/light_frames.h"
#include "texture/relief.h"
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
constexpr std::size_t kLitPoints = 4000;       // of the batch; the light has nine terms
constexpr const char* kCoefficients = "light_coefficients";

// With what the photographs show; nothing where they show nothing, and the notes say why.
Result<std::optional<texture::TexturedMesh>> texturedOf(const Run& run, const TriangleMesh& mesh,
                                                        const ModelledSherd& sherd,
                                                        const std::optional<texture::Light>& light,
                                                        stages::StageNotes& notes) {
  using Textured = std::optional<texture::TexturedMesh>;
  const auto plainly = [&](const Error& why) -> Result<Textured> {
    if (why.code == ErrorCode::Cancelled) return why;
    notes.warnings.push_back(
        message("Sherd %1 has no photographic texture: %2", sherd.number, why.sentence()));
    return Textured();
  };
  if (!sherd.views) return Textured();
  const Result<texture::Shown> shown = sherd.views();
  if (!shown) return plainly(shown.error());
  Result<texture::TexturedMesh> textured =
      texture::textured(mesh, shown->views, light, run.options.threads, run.progress, run.stop);
  if (!textured) return plainly(textured.error());
  if (run.colours.value)
    textured->texture.picture = run.colours.value->of(textured->texture.picture);
  for (const Error& error : shown->unread)
    notes.warnings.push_back(
        message("The texture of sherd %1 lacks a photograph: %2", sherd.number, error.sentence()));
  notes.figures["texel_mm"] = textured->texel_mm;
  notes.figures["texture_seen_share"] = textured->texture.seen_share;
  return Textured(std::move(*textured));
}

Result<PlyContents> modelOf(const Run& run, const ModelledSherd& sherd) {
  return readPly(run.work / ("model_" + sherd.number) / "model.ply");
}

Result<stages::StageNotes> makeTexture(const Run& run, const fs::path& folder,
                                       const ModelledSherd& sherd,
                                       const std::optional<texture::Light>& light) {
  const Result<PlyContents> model = modelOf(run, sherd);
  if (!model) return model.error();
  const Result<TriangleMesh> simplified = model::decimated(model->mesh, kGlbDeviation_mm);
  if (!simplified) return simplified.error();
  stages::StageNotes notes;
  auto textured = texturedOf(run, *simplified, sherd, light, notes);
  if (!textured) return textured.error();
  GlbExtras extras{
      sherd.id, sherd.number, {}, 100 * sherd.model.notes.figures.value("filled_share", 0.0)};
  if (*textured) {
    notes.figures["munsell"] = colour::toJson(texture::munsellOf(**textured, run.colours.value));
    extras.munsell = notes.figures["munsell"].dump();
    notes.figures["texture"] = texture::nameOf((*textured)->texture);
    (*textured)->relief = texture::reliefOf(**textured, model->mesh, run.options.threads);
  }
  // Without photographs with the colours of the scan's points.
  const Result<std::string> glb =
      *textured ? texture::formatGlb(**textured, extras) : ostraka::formatGlb(*simplified, extras);
  if (const Result<void> r = writeGlb(folder / "model.glb", glb); !r) return r.error();
  const std::string preview = *textured ? texture::previewOf(**textured)
                                        : images::encodedPng(model::renderPreview(model->mesh, {}));
  if (const Result<void> r = writeFileAtomically(folder / "preview.png", preview); !r)
    return r.error();
  return notes;
}

std::vector<double> numbersOf(const texture::Light& light) {
  return {light.coefficients.data(), light.coefficients.data() + light.coefficients.size()};
}

std::optional<texture::Light> lightIn(const ordered_json& figures) {
  texture::Light light;
  const auto numbers = figures.value(kCoefficients, std::vector<double>());
  if (numbers.size() != static_cast<std::size_t>(light.coefficients.size())) return std::nullopt;
  std::copy(numbers.begin(), numbers.end(), light.coefficients.data());
  return light;
}

// Of cameras that COLMAP found each side has a frame of its own: nothing is known of its light.
auto framesOf(const Run& run, const Poses& poses) {
  return run.batch.plate ? texture::lightFrames(poses.images, poses.rig) : std::nullopt;
}

Result<stages::StageNotes> findLight(const Run& run, const Poses& poses,
                                     const std::vector<ModelledSherd>& sherds) {
  std::vector<texture::LitPoint> points;
  if (framesOf(run, poses))
    for (std::size_t i = 0; i < sherds.size(); ++i) {
      if (run.stop.stop_requested()) return Error::cancelled();
      const Result<PlyContents> model = modelOf(run, sherds[i]);
      if (!model) return model.error();
      const Result<texture::Shown> shown = sherds[i].views();
      if (!shown && shown.error().code == ErrorCode::Cancelled) return shown.error();
      if (!shown) break;  // the textures say that no photograph can be read
      const std::vector<texture::LitPoint> some =
          texture::litPoints(model->mesh, shown->views, static_cast<int>(i),
                             kLitPoints / sherds.size() + 1, run.options.threads);
      points.insert(points.end(), some.begin(), some.end());
    }
  const Result<texture::LightFit> found = texture::lightOf(points);
  stages::StageNotes notes;
  if (found) {
    notes.figures = {{kCoefficients, numbersOf(found->light)},
                     {"light_uncertainty", found->uncertainty},
                     {"light_residual", found->residual}};
  } else {
    notes.warnings.push_back(found.error().sentence());
    run.progress.note(NoteLevel::Warning, notes.warnings.back());
  }
  return notes;
}

}  // namespace

texture::SherdViews viewsOf(const Run& run, const Poses& poses, const Masks& front_masks,
                            const Masks& back_masks, const std::vector<DecidedPair>& pairs,
                            const std::vector<scan::Scan>& fronts,
                            const std::vector<scan::Scan>& backs) {
  const auto frames = framesOf(run, poses);
  std::vector<texture::Photograph> photographs;
  for (const Side side : {Side::Front, Side::Back}) {
    const Masks& masks = side == Side::Front ? front_masks : back_masks;
    std::size_t at = 0;
    for (std::size_t i = 0; i < poses.images.size(); ++i) {
      if (poses.images[i].side != side || at >= masks.size()) continue;
      photographs.push_back({poses.images[i], masks[at++]});
      if (frames) photographs.back().light_from_plate = (*frames)[i];
    }
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

Result<Staged<std::optional<texture::Light>>> lightStage(const Run& run, const Poses& poses,
                                                         const std::vector<ModelledSherd>& sherds,
                                                         const std::string& inputs_hash) {
  ordered_json key = {{"inputs", inputs_hash}};
  for (const ModelledSherd& sherd : sherds) key[sherd.number] = sherd.model.outputs_hash;
  const Result<stages::StageRecord> record =
      runStage(run, "light", key, [&](const fs::path&) { return findLight(run, poses, sherds); });
  if (!record) return record.error();
  return Staged<std::optional<texture::Light>>{lightIn(record->notes.figures), *record};
}

Result<stages::StageRecord> textureStage(const Run& run, const ModelledSherd& sherd,
                                         const std::optional<texture::Light>& light,
                                         const std::string& inputs_hash) {
  ordered_json key = {{"inputs", inputs_hash}, {"model", sherd.model.outputs_hash}};
  if (light) key["light"] = numbersOf(*light);
  return runStage(run, "texture_" + sherd.number, key,
                  [&](const fs::path& folder) { return makeTexture(run, folder, sherd, light); });
}

}  // namespace ostraka::pipeline
