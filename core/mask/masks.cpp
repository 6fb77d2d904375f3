#include "mask/masks.h"

#include "base/message.h"

namespace ostraka::mask {

Result<void> checkViews(std::span<const rig::PosedImage> images,
                        std::span<const cv::Mat> photographs, const Message& too_few) {
  if (images.size() != photographs.size())
    return Error::unusable(message("%1 poses are given for %2 photographs; give one pose for each.",
                                   images.size(), photographs.size()));
  if (images.size() < 3) return Error{ErrorCode::NotEnough, too_few, {}};
  for (std::size_t i = 0; i < images.size(); ++i)
    if (photographs[i].type() != CV_8UC3 || photographs[i].cols != images[i].intrinsics.width ||
        photographs[i].rows != images[i].intrinsics.height)
      return Error::unusable(
          message(
              "The photograph differs in size from its camera's images; use the original file."),
          images[i].file);
  return {};
}

Error noSherdFound() {
  return {ErrorCode::NotEnough,
          message("No sherd was found on the plate; check that the photographs show sherds that "
                  "stand out from the plate, or provide masks."),
          {}};
}

}  // namespace ostraka::mask
