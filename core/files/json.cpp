#include "files/json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "base/limits.h"
#include "base/message.h"
#include "base/text.h"
#include "files/files.h"
#include "files/json_numbers.h"
#include "files/json_text.h"

namespace ostraka {
namespace {

// Looks at a text before it is parsed: its depth, and keys that one object has twice, of which
// nobody could say which one holds. Not while it is parsed: the library's callback walks a whole
// list after each object in it.
class Inspection final : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool start_object(std::size_t) override {
    keys_.emplace_back();
    return goesDeeper();
  }
  bool end_object() override {
    keys_.pop_back();
    return end_array();
  }
  bool start_array(std::size_t) override { return goesDeeper(); }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool key(std::string& key) override {
    if (!keys_.back().insert(key).second) twice = key;
    return true;
  }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool number_float(double, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(nlohmann::json::binary_t&) override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;
  }

  bool too_deep = false;
  std::optional<std::string> twice;

 private:
  bool goesDeeper() {
    too_deep = ++depth_ > limits::kJsonDepth.most;
    return !too_deep;
  }
  std::uint64_t depth_ = 0;
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
};

template <class Json>
Result<Json> parsed(std::string_view text, const std::string& where) {
  if (text.size() > limits::kJsonBytes.most)
    return Error::unusable(message("The JSON text is larger than 64 MiB."), where);
  Inspection inspection;
  nlohmann::json::sax_parse(text, &inspection);
  if (inspection.too_deep)
    return Error::unusable(message("The JSON is nested more than 64 levels deep."), where);
  try {
    Json value = Json::parse(text);
    if (inspection.twice)
      return Error::unusable(
          message("The JSON contains '%1' twice in one object; delete one of the two.",
                  *inspection.twice),
          where);
    return value;
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    return Error::unusable(
        message("Not valid JSON (line %1); correct that line, or copy the file again.",
                1 + std::count(text.begin(), end, '\n')),
        where);
  } catch (const nlohmann::json::exception&) {
    return Error::unusable(message("The JSON contains a number that is too large; correct it."),
                           where);
  }
}

// Without the zeros behind the point that say nothing.
std::string plain(double value) {
  std::string text = fixed(value, 6);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

void refuseWhole(const std::string& name, std::int64_t least, std::int64_t most) {
  throw JsonValueError(
      message("'%1' must be a whole number from %2 to %3; correct it.", name, least, most));
}

void refuseNumber(const std::string& name, double least, double most) {
  if (least == -kMostNumber && most == kMostNumber)
    throw JsonValueError(message("'%1' must be a number; correct it.", name));
  throw JsonValueError(
      message("'%1' must be a number from %2 to %3; correct it.", name, plain(least), plain(most)));
}

Error unusableJson(const nlohmann::json::exception& refused, const Message& otherwise,
                   const std::string& where) {
  const auto* value = dynamic_cast<const JsonValueError*>(&refused);
  return Error::unusable(value != nullptr ? value->sentence : otherwise, where);
}

Result<nlohmann::json> parseJson(std::string_view text, const std::string& where) {
  return parsed<nlohmann::json>(text, where);
}

Result<nlohmann::ordered_json> parseOrderedJson(std::string_view text, const std::string& where) {
  return parsed<nlohmann::ordered_json>(text, where);
}

nlohmann::json jsonOrDiscarded(std::string_view text) {
  Result<nlohmann::json> value = parseJson(text, {});
  return value ? std::move(*value) : nlohmann::json(nlohmann::json::value_t::discarded);
}

nlohmann::ordered_json orderedJsonOrDiscarded(std::string_view text) {
  Result<nlohmann::ordered_json> value = parseOrderedJson(text, {});
  return value ? std::move(*value)
               : nlohmann::ordered_json(nlohmann::ordered_json::value_t::discarded);
}

Result<nlohmann::json> readJson(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path, limits::kJsonBytes.most);
  if (!text) return text.error();
  return parseJson(*text, path.string());
}

std::string jsonText(const nlohmann::ordered_json& value) {
  return value.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Result<void> writeJson(const std::filesystem::path& path, const nlohmann::ordered_json& value) {
  return writeFileAtomically(path, jsonText(value));
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

nlohmann::ordered_json orNull(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

Result<Eigen::Isometry3d> isometryFromJson(const nlohmann::json& value, const std::string& where,
                                           const Limit& reach) {
  nlohmann::json flat = nlohmann::json::array();
  if (value.is_array())
    for (const nlohmann::json& row : value) {
      if (row.is_array())
        flat.insert(flat.end(), row.begin(), row.end());
      else
        flat.push_back(row);
    }
  if (flat.size() != 16)
    return Error::unusable(message("A transform must be a 4x4 matrix."), where);
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i) {
    if (!flat[i].is_number())
      return Error::unusable(message("A transform contains a value that is not a number."), where);
    matrix(i / 4, i % 4) = flat[i].get<double>();
  }
  return rigidTransform(matrix, where, reach);
}

Result<Eigen::Isometry3d> rigidTransform(const Eigen::Matrix4d& matrix, const std::string& where,
                                         const Limit& reach) {
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const double skew =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!matrix.allFinite() || !(skew < 1e-3) || rotation.determinant() < 0 ||
      (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > 1e-6)
    return Error::unusable(message("A transform is not rigid."), where);
  if (!(matrix.topRightCorner<3, 1>().norm() <= static_cast<double>(reach.most)))
    return Error::unusable(
        message("A transform moves by more than %1 mm; check that its last column is in mm.",
                reach.most),
        where);
  Eigen::Isometry3d transform;
  transform.matrix() = matrix;
  return transform;
}

}  // namespace ostraka
