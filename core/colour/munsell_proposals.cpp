#include "colour/munsell_proposals.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/text.h"
#include "batch/photograph.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::colour {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr double kMostDifference = 200;  // CIEDE2000 of any two colours is less

ordered_json partJson(const MunsellProposal& part, bool is_front) {
  return {
      {"side", is_front ? "front" : "back"}, {"srgb", part.colour},
      {"munsell", part.match.notation},      {"ciede2000", part.match.difference},
      {"second", part.match.second},         {"second_ciede2000", part.match.second_difference}};
}

std::string chipIn(const json& part, const char* name) {
  const auto notation = part.at(name).get<std::string>();
  const std::vector<MunsellChip>& chips = munsellChips();
  if (std::none_of(chips.begin(), chips.end(),
                   [&](const MunsellChip& chip) { return chip.notation == notation; }))
    throw std::invalid_argument(notation);
  return notation;
}

std::optional<MunsellProposal> partIn(const json& proposals, const char* name) {
  if (!proposals.contains(name)) return std::nullopt;
  const json& part = proposals.at(name);
  MunsellProposal read;
  read.colour = part.at("srgb").get<Color>();
  read.match = {chipIn(part, "munsell"), chipIn(part, "second"),
                numberAt(part, "ciede2000", 0, kMostDifference),
                numberAt(part, "second_ciede2000", 0, kMostDifference)};
  return read;
}

}  // namespace

MunsellProposal proposedFor(const Color& colour) {
  const std::array<double, 256>& light = batch::linearLight();
  return {colour, nearestMunsell(labOf({light[colour[0]], light[colour[1]], light[colour[2]]}))};
}

ordered_json toJson(const MunsellProposals& proposals) {
  ordered_json written = {{"chart", nullptr}};
  if (proposals.chart)
    written["chart"] = {{"ciede2000_median", proposals.chart->median},
                        {"ciede2000_95", proposals.chart->within_95}};
  if (proposals.out) written["out"] = partJson(*proposals.out, proposals.front_is_out);
  if (proposals.in) written["in"] = partJson(*proposals.in, !proposals.front_is_out);
  if (proposals.core) {
    written["core"] = partJson(*proposals.core, true);
    written["core"].erase("side");
  }
  return written;
}

std::optional<MunsellProposals> parseMunsellProposals(std::string_view text) {
  const Result<json> root = parseJson(text, {});
  if (!root || !root->is_object()) return std::nullopt;
  try {
    MunsellProposals read;
    if (const json& chart = root->at("chart"); !chart.is_null())
      read.chart = {numberAt(chart, "ciede2000_median", 0, kMostDifference),
                    numberAt(chart, "ciede2000_95", 0, kMostDifference)};
    read.out = partIn(*root, "out");
    read.in = partIn(*root, "in");
    read.core = partIn(*root, "core");
    const char* face = read.out ? "out" : "in";
    if (read.out || read.in)
      read.front_is_out =
          (root->at(face).at("side").get<std::string>() == "front") == read.out.has_value();
    return read;
  } catch (const std::exception&) {  // of nlohmann, numberAt and chipIn
    return std::nullopt;
  }
}

std::string englishOf(const MunsellProposals& proposals) {
  std::string words;
  const auto add = [&](const char* name, const std::optional<MunsellProposal>& part) {
    if (part)
      words += (words.empty() ? "" : ", ") + std::string(name) + ' ' + part->match.notation + " (" +
               fixed(part->match.difference, 1) + ')';
  };
  add("outside", proposals.out);
  add("inside", proposals.in);
  add("core", proposals.core);
  if (words.empty()) return words;
  return "Nearest Munsell colours (CIEDE2000 in brackets): " + words +
         (proposals.chart ? ". Measured by the colour chart."
                          : ". Rough: there is no usable colour chart in these photographs.");
}

}  // namespace ostraka::colour
