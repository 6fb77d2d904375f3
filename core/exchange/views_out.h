#pragma once
#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>

#include "archive/bagit.h"
#include "base/result.h"

namespace ostraka::exchange {

/// A batch for COLMAP and OpenMVS, in views/NUMBER/front and back: images/ without the lens's
/// distortion, sparse/ (COLMAP's text model, mm, frame of the plate), masks/ as each of the two
/// names them, photographs.csv with the photograph of each image. `scratch`: a folder of its own,
/// which is gone afterwards. Errors: UnusableInput (no whole results, a photograph that is gone),
/// those of stereo::writeOutsideFolder, Cancelled. Memory: all photographs of a side.
Result<void> addViews(archive::BagWriter& bag, const std::filesystem::path& project,
                      const std::string& number, const std::filesystem::path& scratch,
                      const std::stop_token& stop);

struct ViewsSize {
  int files = 0;
  std::int64_t bytes = 0;
};
/// What addViews will add, measured on one photograph of each side: seconds, not minutes. Errors:
/// UnusableInput (no whole results, the photograph or its mask is gone).
Result<ViewsSize> sizeOfViews(const std::filesystem::path& project, const std::string& number);

}  // namespace ostraka::exchange
