#include "mask/given_mask.h"

#include <string>
#include <system_error>

#include "batch/label_mask.h"

namespace ostraka::mask {
namespace {

std::string sizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

Result<cv::Mat1b> readGivenMask(const std::filesystem::path& path, int width, int height) {
  const std::string expected = "a mask of " + sizeText(width, height) + " pixels";
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    return Error::unusable("The mask is missing; expected " + expected + " under this name.",
                           path.string());
  Result<cv::Mat1b> inside = batch::readLabelMask(path);
  if (!inside)
    return Error::unusable("The mask cannot be read as a picture; expected " + expected + ".",
                           path.string());
  if (inside->cols != width || inside->rows != height)
    return Error::unusable("The mask has " + sizeText(inside->cols, inside->rows) +
                               " pixels; expected " + expected + ", the size of its photograph.",
                           path.string());
  return inside;
}

}  // namespace ostraka::mask
