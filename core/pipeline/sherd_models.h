#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/chain.h"
#include "texture/light.h"
#include "texture/sherd_views.h"

namespace ostraka::pipeline {

/// Leaves front.ply, back.ply and, where both sides close, model.ply in OUT/work/model_<number>;
/// the record's "model" says whether they do.
Result<stages::StageRecord> modelStage(const Run& run, const std::string& number,
                                       const DecidedPair& pair, const scan::Scan& front,
                                       const scan::Scan& back, const std::string& inputs_hash);

/// What the photographs show of the pairs' sherds, in their order.
texture::SherdViews viewsOf(const Run& run, const Poses& poses, const Masks& front_masks,
                            const Masks& back_masks, const std::vector<DecidedPair>& pairs,
                            const std::vector<scan::Scan>& fronts,
                            const std::vector<scan::Scan>& backs);

/// A sherd with a model, to be textured.
struct ModelledSherd {
  std::string number;
  std::string id;  ///< of both scans
  stages::StageRecord model;
  /// What the photographs show of it, asked for when a stage runs; none for scans.
  std::function<Result<texture::Shown>()> views;

  bool hasModel() const { return model.notes.figures.value("model", false); }
};

/// The light over all sherds of the batch, found from their models and photographs; nothing where
/// it cannot be known, which the record's warning says.
Result<Staged<std::optional<texture::Light>>> lightStage(const Run& run, const Poses& poses,
                                                         const std::vector<ModelledSherd>& sherds,
                                                         const std::string& inputs_hash);

/// Leaves model.glb and preview.png in OUT/work/texture_<number>. light: taken out of the texture.
Result<stages::StageRecord> textureStage(const Run& run, const ModelledSherd& sherd,
                                         const std::optional<texture::Light>& light,
                                         const std::string& inputs_hash);

}  // namespace ostraka::pipeline
