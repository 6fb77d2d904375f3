#include <cmath>
#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "batch/batch.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::batch {
namespace {

KnownLength lengthFromJson(const nlohmann::json& value) {
  KnownLength known;
  const auto side = value.at("side").get<std::string>();
  if (side != name(Side::Front) && side != name(Side::Back))
    throw std::invalid_argument("'side' must be 'front' or 'back'");
  known.side = side == name(Side::Front) ? Side::Front : Side::Back;
  known.length_mm = numberAt(value, "length", 0.01, limits::kPlateReach_mm.most);
  const nlohmann::json& ends = value.at("ends");
  if (!ends.is_array() || ends.size() != 2)
    throw std::invalid_argument("'ends' must be two lists of marks");
  for (int e = 0; e < 2; ++e) {
    for (const nlohmann::json& mark : ends[e])
      known.ends[e].push_back(
          {mark.at("file").get<std::string>(),
           {numberIn(mark.at("pixel").at(0), "pixel"), numberIn(mark.at("pixel").at(1), "pixel")}});
    if (known.ends[e].size() < 2)
      throw std::invalid_argument("each end must be marked on at least two photographs");
  }
  return known;
}

}  // namespace

Result<std::vector<KnownLength>> readKnownLengths(const std::filesystem::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  const auto unusable = [&](const std::string& what) {
    return Error::unusable("The known lengths cannot be used: " + what + ".", file.string());
  };
  std::vector<KnownLength> lengths;
  try {
    if (json->value("unit", "mm") != "mm") return unusable("their unit must be mm");
    for (const nlohmann::json& value : json->at("lengths"))
      lengths.push_back(lengthFromJson(value));
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(
        refused, unusable("each needs 'side', 'length' and 'ends' with 'file' and 'pixel'").what,
        file.string());
  } catch (const std::invalid_argument& error) {
    return unusable(error.what());
  }
  return lengths;
}

}  // namespace ostraka::batch
