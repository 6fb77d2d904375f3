#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "colmap/colmap_files.h"

namespace ostraka::colmap {

/// One of the three files of a model from its bytes. Errors name `where`.
Result<std::vector<ColmapCamera>> parseColmapCameras(std::string_view bytes,
                                                     const std::string& where);
Result<std::vector<ColmapImage>> parseColmapImages(std::string_view bytes,
                                                   const std::string& where);
Result<std::vector<ColmapPoint>> parseColmapPoints(std::string_view bytes,
                                                   const std::string& where);

const char* colmapModelName(int model);  ///< empty for an unknown number

}  // namespace ostraka::colmap
