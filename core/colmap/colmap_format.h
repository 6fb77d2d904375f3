#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "colmap/colmap_files.h"

namespace ostraka::colmap {

/// One of the three files of a model from or to its bytes. Errors name `where`.
Result<std::vector<ColmapCamera>> parseColmapCameras(std::string_view bytes, ColmapFormat format,
                                                     const std::string& where);
Result<std::vector<ColmapImage>> parseColmapImages(std::string_view bytes, ColmapFormat format,
                                                   const std::string& where);
Result<std::vector<ColmapPoint>> parseColmapPoints(std::string_view bytes, ColmapFormat format,
                                                   const std::string& where);
std::string colmapBytes(const std::vector<ColmapCamera>& cameras, ColmapFormat format);
std::string colmapBytes(const std::vector<ColmapImage>& images, ColmapFormat format);
std::string colmapBytes(const std::vector<ColmapPoint>& points, ColmapFormat format);

const char* colmapModelName(int model);          ///< empty for an unknown number
int colmapModelNumber(const std::string& name);  ///< -1 for an unknown name

}  // namespace ostraka::colmap
