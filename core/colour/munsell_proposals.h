#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "cloud/points_and_meshes.h"
#include "colour/correction.h"
#include "colour/munsell.h"

namespace ostraka::colour {

/// For one part of a sherd.
struct MunsellProposal {
  Color colour;  ///< sRGB, the part's median
  MunsellMatch match;
};

/// What the photographs propose for the Munsell fields of a sherd; a person enters it or not.
struct MunsellProposals {
  std::optional<MunsellProposal> out, in, core;
  bool front_is_out = true;  ///< the side that lay up first is the outer one
  /// What a colour chart left, CIEDE2000; none: there was no chart, and the proposals are rough.
  struct ByChart {
    double median = 0, within_95 = 0;
  };
  std::optional<ByChart> chart;
};

MunsellProposal proposedFor(const Color& colour);

/// {"chart": {"ciede2000_median", "ciede2000_95"} or null, "out": {"side", "srgb", "munsell",
/// "ciede2000", "second", "second_ciede2000"}, "in", "core"}; parts without a colour are left out.
nlohmann::ordered_json toJson(const MunsellProposals& proposals);
/// What toJson made, as text; none where it is anything else, or names what is no chip.
std::optional<MunsellProposals> parseMunsellProposals(std::string_view text);

/// A sentence on the nearest chips and one on how they were found; empty without proposals.
std::string englishOf(const MunsellProposals& proposals);

}  // namespace ostraka::colour
