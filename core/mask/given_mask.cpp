#include "mask/given_mask.h"

#include <system_error>

#include "base/message.h"
#include "batch/label_mask.h"

namespace ostraka::mask {

Result<cv::Mat1b> readGivenMask(const std::filesystem::path& path, int width, int height) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    return Error::unusable(
        message("The mask is missing; expected a mask of %1 x %2 pixels under this name.", width,
                height),
        path.string());
  Result<cv::Mat1b> inside = batch::readLabelMask(path);
  if (!inside)
    return Error::unusable(
        message("The mask cannot be read as a picture; expected a mask of %1 x %2 pixels.", width,
                height),
        path.string());
  if (inside->cols != width || inside->rows != height)
    return Error::unusable(
        message("The mask has %1 x %2 pixels; expected a mask of %3 x %4 pixels, the size of its "
                "photograph.",
                inside->cols, inside->rows, width, height),
        path.string());
  return inside;
}

}  // namespace ostraka::mask
