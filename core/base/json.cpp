#include "base/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/files.h"

namespace ostraka {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{64} << 20;
constexpr int kMaxDepth = 64;

}  // namespace

Result<nlohmann::json> parseJson(std::string_view text, const std::string& where) {
  if (text.size() > kMaxBytes)
    return Error::unusable("The JSON text is larger than 64 MiB.", where);
  bool too_deep = false;
  const nlohmann::json::parser_callback_t check = [&](int depth, nlohmann::json::parse_event_t,
                                                      nlohmann::json&) {
    if (depth > kMaxDepth) too_deep = true;
    return depth <= kMaxDepth;
  };
  try {
    nlohmann::json value = nlohmann::json::parse(text, check);
    if (too_deep) return Error::unusable("The JSON is nested deeper than 64 levels.", where);
    return value;
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    return Error::unusable("This is not valid JSON (line " +
                               std::to_string(1 + std::count(text.begin(), end, '\n')) +
                               "); mend it there, or copy the file again.",
                           where);
  } catch (const nlohmann::json::exception&) {
    return Error::unusable("The JSON holds a number that is too large; mend it.", where);
  }
}

Result<nlohmann::json> readJson(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, kMaxBytes);
  if (!text) return text.error();
  return parseJson(*text, path.string());
}

Result<void> writeJson(const std::filesystem::path& path, const nlohmann::ordered_json& value) {
  return writeFileAtomically(
      path, value.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

nlohmann::ordered_json toJson(const Eigen::Isometry3d& transform) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (int r = 0; r < 4; ++r) {
    nlohmann::ordered_json row = nlohmann::ordered_json::array();
    for (int c = 0; c < 4; ++c) row.push_back(transform.matrix()(r, c));
    rows.push_back(std::move(row));
  }
  return rows;
}

Result<Eigen::Isometry3d> isometryFromJson(const nlohmann::json& value, const std::string& where) {
  nlohmann::json flat = nlohmann::json::array();
  if (value.is_array())
    for (const nlohmann::json& row : value) {
      if (row.is_array())
        flat.insert(flat.end(), row.begin(), row.end());
      else
        flat.push_back(row);
    }
  if (flat.size() != 16) return Error::unusable("A transform must be a 4x4 matrix.", where);
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i) {
    if (!flat[i].is_number())
      return Error::unusable("A transform holds something not a number.", where);
    matrix(i / 4, i % 4) = flat[i].get<double>();
  }
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const double skew =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!matrix.allFinite() || !(skew < 1e-3) || rotation.determinant() < 0 ||
      (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > 1e-6)
    return Error::unusable("A transform is not rigid.", where);
  Eigen::Isometry3d transform;
  transform.matrix() = matrix;
  return transform;
}

}  // namespace ostraka
