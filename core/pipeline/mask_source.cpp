#include "pipeline/mask_source.h"

#include <algorithm>

namespace ostraka::pipeline {

Result<MaskSource> maskSource(const std::string& masks, const batch::Batch& batch) {
  if (masks == "given") return MaskSource::Given;
  if (masks != "auto") return MaskSource::Network;
  if (batch.plate) return MaskSource::Plate;
  if (std::any_of(batch.shots.begin(), batch.shots.end(),
                  [](const batch::Shot& shot) { return !shot.mask_file.empty(); }))
    return MaskSource::Given;
  if (batch.way == batch::Way::FreeCamera) return MaskSource::Views;
  return Error::unusable(
      "Masks cannot be made without plate.json; put masks next to the photographs, or "
      "choose a network (--masks MODEL.onnx).",
      batch.folder.string());
}

}  // namespace ostraka::pipeline
