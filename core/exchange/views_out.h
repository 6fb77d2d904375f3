#pragma once
#include <filesystem>
#include <stop_token>
#include <string>

#include "base/result.h"
#include "exchange/bagit.h"

namespace ostraka::exchange {

/// A batch for COLMAP and OpenMVS, in views/NUMBER/front and back: images/ without the lens's
/// distortion, sparse/ (COLMAP's text model, mm, frame of the plate), masks/ as each of the two
/// names them, photographs.csv with the photograph of each image. `scratch`: a folder of its own,
/// which is gone afterwards. Errors: those of pipeline::savedViews and stereo::writeOutsideFolder.
Result<void> addViews(BagWriter& bag, const std::filesystem::path& project,
                      const std::string& number, const std::filesystem::path& scratch,
                      const std::stop_token& stop);

}  // namespace ostraka::exchange
