#include "records/sherd.h"

#include <gtest/gtest.h>

namespace ostraka::records {
namespace {

Term termOf(const std::string& term, std::map<std::string, std::string> labels = {}) {
  return {term, std::move(labels), {}};
}

TEST(UnitOf, IsTheOneInWhichAKindIsStored) {
  const std::map<std::string, std::string> units = {
      {"length", "mm"},         {"width", "mm"},         {"thickness_min", "mm"},
      {"thickness_mean", "mm"}, {"thickness_max", "mm"}, {"rim_diameter", "mm"},
      {"area", "mm2"},          {"volume", "mm3"},       {"weight", "g"},
      {"filled_pct", "pct"},    {"rim_pct", "pct"}};
  for (const auto& [kind, unit] : units) EXPECT_EQ(unitOf(kind), unit) << kind;
}

TEST(UnitOf, IsNoneOfWhatOnlyLooksLikeAKind) {
  for (const char* kind : {"", "Length", "length_mm", "thickness", "weight ", "rim", "colour"})
    EXPECT_EQ(unitOf(kind), "") << kind;
}

TEST(NotATerm, NamesTheTermsInEachLanguageThatHasLabels) {
  const Message said = notATerm("rimm", {termOf("rim", {{"de", "Rand"}, {"fr", "bord"}}),
                                         termOf("neck", {{"de", "Hals"}}), termOf("base")});
  EXPECT_EQ(said.english(),
            "'rimm' is not a term; choose one of rim, neck, base, or add it in the settings.");
  const MessageValue& names = said.values().at(1);
  EXPECT_EQ(names.translations.size(), 2U);
  EXPECT_EQ(names.translations.at("de"), "Rand, Hals, base");
  EXPECT_EQ(names.translations.at("fr"), "bord, neck, base")
      << "where a label is missing, the term";
}

TEST(NotATerm, NamesEightOfALongVocabulary) {
  std::vector<Term> terms;
  for (const char* term : {"a", "b", "c", "d", "e", "f", "g", "h"}) terms.push_back(termOf(term));
  EXPECT_EQ(notATerm("x", terms).english(),
            "'x' is not a term; choose one of a, b, c, d, e, f, g, h, or add it in the settings.");
  terms.push_back(termOf("i"));
  EXPECT_EQ(notATerm("x", terms).english(),
            "'x' is not a term; choose one of a, b, c, d, e, f, g, h, \u2026, or add it in the "
            "settings.");
}

TEST(NotATerm, SaysThatAVocabularyIsEmpty) {
  EXPECT_EQ(notATerm("rim", {}).english(),
            "'rim' is not a term: the vocabulary is empty; add it in the settings.");
}

// What was typed may hold what a template uses for its values.
TEST(NotATerm, TellsWhatWasTypedLetterByLetter) {
  EXPECT_EQ(notATerm("%2", {termOf("rim")}).english(),
            "'%2' is not a term; choose one of rim, or add it in the settings.");
}

TEST(ChangePreview, AsksOnlyWhereSomethingWasFoundAndNobodyConfirmedIt) {
  ChangePreview preview;
  EXPECT_FALSE(preview.asks());
  preview.findings.emplace_back();
  EXPECT_TRUE(preview.asks());
  preview.change.confirmation = Confirmation::Given;
  EXPECT_FALSE(preview.asks());
}

}  // namespace
}  // namespace ostraka::records
