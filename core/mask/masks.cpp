#include "mask/masks.h"

#include <string>

namespace ostraka::mask {

Result<void> checkViews(std::span<const rig::PosedImage> images,
                        std::span<const cv::Mat> photographs, const char* too_few) {
  if (images.size() != photographs.size())
    return Error::unusable(std::to_string(images.size()) + " poses are given for " +
                           std::to_string(photographs.size()) +
                           " photographs; give one pose for each.");
  if (images.size() < 3) return Error{ErrorCode::NotEnough, too_few, {}};
  for (std::size_t i = 0; i < images.size(); ++i)
    if (photographs[i].type() != CV_8UC3 || photographs[i].cols != images[i].intrinsics.width ||
        photographs[i].rows != images[i].intrinsics.height)
      return Error::unusable(
          "The photograph differs in size from its camera's images; use the original file.",
          images[i].file);
  return {};
}

}  // namespace ostraka::mask
