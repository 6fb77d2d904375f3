#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "evaluate/pairs.h"
#include "files/contained_path.h"
#include "files/json.h"

namespace ostraka::evaluate {
namespace {

using Json = nlohmann::json;

std::string stem(const std::string& name) {
  return std::filesystem::path(name).stem().string();
}

std::optional<double> numberAt(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return {};
  return found->get<double>();
}

std::vector<std::string> stemsAt(const Json& object, const char* key) {
  std::vector<std::string> names;
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array()) return names;
  for (const Json& entry : *found)
    if (entry.is_string()) names.push_back(stem(entry.get<std::string>()));
  return names;
}

// Sixteen finite numbers, nested or flat; a matrix that is one but not rigid, or moves farther than
// scans can lie from each other, counts as such.
bool isMatrix(const Json& value) {
  std::size_t numbers = 0;
  const auto count = [&](const Json& v) {
    numbers += v.is_number() && std::isfinite(v.get<double>());
  };
  if (!value.is_array()) return false;
  for (const Json& row : value) {
    if (row.is_array())
      for (const Json& v : row) count(v);
    else
      count(row);
  }
  return numbers == 16;
}

Result<ProposedPair> readPair(const Json& entry, const std::filesystem::path& file) {
  if (!entry.is_object() || !entry.contains("front") || !entry.contains("back") ||
      !entry["front"].is_string() || !entry["back"].is_string())
    return Error::unusable("A pair has no front or no back.", file);
  ProposedPair pair;
  pair.front = stem(entry["front"].get<std::string>());
  pair.back = stem(entry["back"].get<std::string>());
  pair.score = numberAt(entry, "score");
  pair.margin = numberAt(entry, "margin");
  pair.fracture_rms_mm = numberAt(entry, "fracture_rms_mm");
  const auto flag = entry.find("ambiguous");
  pair.ambiguous = flag != entry.end() && flag->is_boolean() && flag->get<bool>();
  if (const auto others = entry.find("alternatives"); others != entry.end() && others->is_array())
    for (const Json& other : *others) {
      if (other.is_string()) pair.alternative_backs.push_back(stem(other.get<std::string>()));
      if (other.is_object() && other.contains("back") && other["back"].is_string())
        pair.alternative_backs.push_back(stem(other["back"].get<std::string>()));
    }
  const auto matrix = entry.find("T_front_from_back");
  if (matrix == entry.end() || matrix->is_null()) return pair;
  const Result<Eigen::Isometry3d> transform = isometryFromJson(*matrix, file.string());
  if (!transform && !isMatrix(*matrix))
    return Error::unusable("T_front_from_back of pair " + pair.front + " is not a 4x4 matrix.",
                           file);
  pair.has_transform = transform.has_value();
  pair.transform_not_rigid = !transform;
  if (transform) pair.front_from_back = *transform;
  return pair;
}

}  // namespace

Result<Proposal> readProposal(const std::filesystem::path& pairs_json) {
  const Result<Json> value = readJson(pairs_json);
  if (!value) return value.error();
  if (!value->is_object())
    return Error::unusable("The list of pairs is not a JSON object.", pairs_json);
  Proposal proposal;
  proposal.unpaired_front = stemsAt(*value, "unpaired_front");
  proposal.unpaired_back = stemsAt(*value, "unpaired_back");
  const auto pairs = value->find("pairs");
  if (pairs == value->end()) return proposal;
  if (!pairs->is_array()) return Error::unusable("'pairs' is not a list.", pairs_json);
  for (const Json& entry : *pairs) {
    Result<ProposedPair> pair = readPair(entry, pairs_json);
    if (!pair) return pair.error();
    proposal.pairs.push_back(std::move(*pair));
  }
  return proposal;
}

Result<PairsTruth> readPairsTruth(const std::filesystem::path& truth_json) {
  const Result<Json> value = readJson(truth_json);
  if (!value) return value.error();
  const auto pairs = value->find("pairs");
  if (!value->is_object() || pairs == value->end() || !pairs->is_array())
    return Error::unusable("The truth has no list 'pairs'.", truth_json);
  PairsTruth truth;
  truth.set = std::filesystem::absolute(truth_json).parent_path().filename().string();
  truth.unpaired_front = stemsAt(*value, "unpaired_front");
  truth.unpaired_back = stemsAt(*value, "unpaired_back");
  for (const Json& entry : *pairs) {
    if (!entry.is_object() || !entry.contains("front") || !entry.contains("back") ||
        !entry["front"].is_string() || !entry["back"].is_string() ||
        !entry.contains("T_front_from_back"))
      return Error::unusable("A true pair lacks front, back or T_front_from_back.", truth_json);
    const Result<Eigen::Isometry3d> transform =
        isometryFromJson(entry["T_front_from_back"], truth_json.string());
    if (!transform) return transform.error();
    TruePair pair;
    for (const auto& [key, name] :
         {std::pair("front", &pair.front_file), std::pair("back", &pair.back_file)}) {
      const Result<ContainedPath> path = ContainedPath::parse(entry[key].get<std::string>());
      if (!path) return Error::unusable(path.error().what, truth_json);
      *name = path->text();
    }
    pair.front = stem(pair.front_file);
    pair.back = stem(pair.back_file);
    pair.front_from_back = *transform;
    truth.pairs.push_back(std::move(pair));
  }
  return truth;
}

}  // namespace ostraka::evaluate
