#include "batch/mask_source.h"

#include <algorithm>

#include "base/message.h"

namespace ostraka::batch {

Result<MaskSource> maskSource(const std::string& masks, const Batch& batch) {
  if (masks == "given") return MaskSource::Given;
  if (masks != "auto") return MaskSource::Network;
  if (batch.plate) return MaskSource::Plate;
  if (std::ranges::any_of(batch.shots, [](const Shot& shot) { return !shot.mask_file.empty(); }))
    return MaskSource::Given;
  if (batch.way == Way::FreeCamera) return MaskSource::Views;
  return Error::unusable(
      message("Masks cannot be made without plate.json; put masks next to the photographs, or "
              "choose a network (--masks MODEL.onnx)."),
      batch.folder.string());
}

}  // namespace ostraka::batch
