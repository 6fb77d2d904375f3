#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "colmap/colmap_files.h"

namespace ostraka::colmap::colmap_text {

Result<std::vector<ColmapCamera>> cameras(std::string_view text, const std::string& where);
Result<std::vector<ColmapImage>> images(std::string_view text, const std::string& where);
Result<std::vector<ColmapPoint>> points(std::string_view text, const std::string& where);
std::string written(const std::vector<ColmapCamera>& cameras);
std::string written(const std::vector<ColmapImage>& images);
std::string written(const std::vector<ColmapPoint>& points);

}  // namespace ostraka::colmap::colmap_text
