#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "base/message.h"
#include "batch/batch.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::batch {
namespace {

// Throws nlohmann's exceptions; what of an error is a phrase.
Result<KnownLength> lengthFromJson(const nlohmann::json& value) {
  KnownLength known;
  const auto side = value.at("side").get<std::string>();
  if (side != name(Side::Front) && side != name(Side::Back))
    return Error::unusable(message("'side' must be 'front' or 'back'"));
  known.side = side == name(Side::Front) ? Side::Front : Side::Back;
  known.length_mm = numberAt(value, "length", 0.01, limits::kPlateReach_mm.most);
  const nlohmann::json& ends = value.at("ends");
  if (!ends.is_array() || ends.size() != 2)
    return Error::unusable(message("'ends' must be two lists of marks"));
  for (int e = 0; e < 2; ++e) {
    for (const nlohmann::json& mark : ends[e])
      known.ends[e].push_back(
          {mark.at("file").get<std::string>(),
           {numberIn(mark.at("pixel").at(0), "pixel"), numberIn(mark.at("pixel").at(1), "pixel")}});
    if (known.ends[e].size() < 2)
      return Error::unusable(message("each end must be marked on at least two photographs"));
  }
  return known;
}

}  // namespace

Result<std::vector<KnownLength>> readKnownLengths(const std::filesystem::path& file) {
  const Result<nlohmann::json> json = readJson(file);
  if (!json) return json.error();
  const auto unusable = [&](const Message& what) {
    return Error::unusable(message("The known lengths cannot be used: %1.", what), file.string());
  };
  std::vector<KnownLength> lengths;
  try {
    if (json->value("unit", "mm") != "mm") return unusable(message("their unit must be mm"));
    for (const nlohmann::json& value : json->at("lengths")) {
      Result<KnownLength> length = lengthFromJson(value);
      if (!length) return unusable(length.error().what);
      lengths.push_back(std::move(*length));
    }
  } catch (const nlohmann::json::exception& refused) {
    return unusableJson(
        refused,
        unusable(message("each needs 'side', 'length' and 'ends' with 'file' and 'pixel'")).what,
        file.string());
  }
  return lengths;
}

}  // namespace ostraka::batch
