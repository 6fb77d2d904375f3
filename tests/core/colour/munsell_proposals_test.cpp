#include "colour/munsell_proposals.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace ostraka::colour {
namespace {

TEST(MunsellProposals, AreOfTheColourOnScreen) {
  const MunsellProposal proposal = proposedFor({152, 114, 83});
  EXPECT_EQ(proposal.match.notation, "7.5YR 5/4");
  EXPECT_NEAR(proposal.match.difference, 0.87, 0.02);
  EXPECT_EQ(proposedFor({119, 119, 119}).match.notation, "N 5/");
}

TEST(MunsellProposals, AreReadBackAsTheyWereWritten) {
  MunsellProposals proposals;
  proposals.out = proposedFor({152, 114, 83});
  proposals.core = proposedFor({84, 69, 53});
  proposals.front_is_out = false;
  EXPECT_TRUE(toJson(proposals)["chart"].is_null()) << "without a chart they are rough";
  proposals.chart = {0.8, 1.9};
  const auto read = parseMunsellProposals(toJson(proposals).dump());
  ASSERT_TRUE(read.has_value());
  ASSERT_TRUE(read->out && read->core && read->chart);
  EXPECT_FALSE(read->in);
  EXPECT_FALSE(read->front_is_out);
  EXPECT_EQ(read->out->colour, (Color{152, 114, 83}));
  EXPECT_EQ(read->out->match.second, "5YR 5/4");
  EXPECT_EQ(read->core->match.notation, "10YR 3/2");
  EXPECT_EQ(read->chart->within_95, 1.9);
}

TEST(MunsellProposals, OfADamagedFileAreNone) {
  MunsellProposals proposals;
  proposals.in = proposedFor({152, 114, 83});
  const nlohmann::ordered_json whole = toJson(proposals);
  EXPECT_TRUE(parseMunsellProposals(whole.dump()));
  const auto spoilt = [&](const char* key, const nlohmann::ordered_json& value) {
    nlohmann::ordered_json other = whole;
    other["in"][key] = value;
    return parseMunsellProposals(other.dump());
  };
  EXPECT_FALSE(spoilt("munsell", "brown"));
  EXPECT_FALSE(spoilt("munsell", 5));
  EXPECT_FALSE(spoilt("ciede2000", -1));
  EXPECT_FALSE(spoilt("srgb", {1, 2}));
  for (const char* text : {"", "[]", "{}", "null", "{\"chart\": 1}"})
    EXPECT_FALSE(parseMunsellProposals(text)) << text;
}

}  // namespace
}  // namespace ostraka::colour
