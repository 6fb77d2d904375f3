#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/limits.h"
#include "base/result.h"

namespace ostraka {

/// JSON text as a value. Depth is limited to 64 and size to 64 MiB; `where` names the file in
/// errors.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& where);
Result<nlohmann::json> readJson(const std::filesystem::path& path);
/// Indented by one space, UTF-8, LF at the end.
std::string jsonText(const nlohmann::ordered_json& value);
/// The same, written atomically.
Result<void> writeJson(const std::filesystem::path& path, const nlohmann::ordered_json& value);

/// 4x4, row by row. Reading refuses what is not finite, not 4x4 (nested or flat), not rigid (1e-3)
/// or moves farther than `reach` (mm).
nlohmann::ordered_json toJson(const Eigen::Isometry3d& transform);
nlohmann::ordered_json orNull(const std::optional<double>& value);
Result<Eigen::Isometry3d> isometryFromJson(const nlohmann::json& value, const std::string& where,
                                           const Limit& reach = limits::kScanReach_mm);
/// The same of a matrix that another program hands in.
Result<Eigen::Isometry3d> rigidTransform(const Eigen::Matrix4d& matrix, const std::string& where,
                                         const Limit& reach = limits::kScanReach_mm);

}  // namespace ostraka
