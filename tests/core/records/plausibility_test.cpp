#include "records/plausibility.h"

#include <gmock/gmock.h>

#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::records {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<MeasureDoubt> doubtsOf(const std::vector<MeasureFinding>& findings) {
  std::vector<MeasureDoubt> doubts;
  for (const MeasureFinding& finding : findings) doubts.push_back(finding.doubt);
  return doubts;
}

TEST(Plausibility, OfAValueNearTheComputedOneFindsNothing) {
  EXPECT_TRUE(
      implausible({"length"}, {{"length", 71}, {"width", 60.77}}, {{"length", 72.39}}).empty());
}

TEST(Plausibility, FindsCentimetresTypedAsMillimetresAndTheOtherWayRound) {
  EXPECT_THAT(doubtsOf(implausible({"length"}, {{"length", 7}}, {{"length", 72.39}})),
              ElementsAre(MeasureDoubt::TenTimesComputed));
  EXPECT_THAT(doubtsOf(implausible({"length"}, {{"length", 720}}, {{"length", 72.39}})),
              ElementsAre(MeasureDoubt::TenTimesComputed));
}

TEST(Plausibility, FindsWhatIsThreeTimesOffTheComputedValue) {
  EXPECT_THAT(doubtsOf(implausible({"width"}, {{"width", 20}}, {{"width", 60.77}})),
              ElementsAre(MeasureDoubt::FarFromComputed));
  EXPECT_TRUE(implausible({"width"}, {{"width", 21}}, {{"width", 60.77}}).empty());
}

TEST(Plausibility, FindsALengthBelowTheWidthAndAWidthBelowTheThickness) {
  const auto findings =
      implausible({"length"}, {{"length", 50}, {"width", 60.77}, {"thickness_mean", 6}}, {});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(sentenceOf(findings[0]),
            "Check the values: the length (50 mm) is below the width (60.77 mm).");
  EXPECT_THAT(doubtsOf(implausible({"width"}, {{"width", 5}, {"thickness_mean", 6}}, {})),
              ElementsAre(MeasureDoubt::OrderReversed));
  EXPECT_THAT(
      doubtsOf(implausible({"thickness_max"}, {{"thickness_max", 5}, {"thickness_min", 6}}, {})),
      ElementsAre(MeasureDoubt::OrderReversed));
}

// What was wrong before is no reason to ask about another value.
TEST(Plausibility, SaysNothingOfValuesThatNobodyChanges) {
  EXPECT_TRUE(implausible({"weight"}, {{"length", 50}, {"width", 60}, {"weight", 9}}, {}).empty());
}

class TypedMeasure : public catalogue::SmallProject {
 protected:
  TypedMeasure() : sherd(numbered(context12)) {
    for (const auto& [kind, value] : {std::pair("length", 72.39), std::pair("width", 60.77)})
      EXPECT_TRUE(sherds::Measurements(catalogue())
                      .add({sherd, kind, {}, value, {}, "program", {}, "m1"}, {}));
  }
  FieldChange typed(const std::string& value, Confirmation confirmation = Confirmation::None) {
    return {sherd, "length_mm", value, confirmation};
  }
  ChangePreview previewOf(const FieldChange& change) {
    return sherds::SherdChanges(catalogue()).preview(std::span(&change, 1))->front();
  }
  store::SherdRow sherd;
};

TEST_F(TypedMeasure, NeverTakesTheComputedOnesPlaceUnasked) {
  const FieldChange slip = typed("7");
  const ChangePreview shown = previewOf(slip);
  EXPECT_TRUE(shown.asks());
  EXPECT_THAT(shown.question, HasSubstr("7 mm is about a tenth of the computed value."));
  EXPECT_THAT(shown.question, HasSubstr("the length (7 mm) is below the width (60.77 mm)."));
  EXPECT_THAT(shown.question,
              HasSubstr("The computed value is 72.39 mm. Replace it with the measured value?"));
  const Message asked = sentenceOf({MeasureDoubt::ReplacesComputed, "length", 7, {}, 72.39});
  ASSERT_EQ(asked.values().front().kind, MessageValue::Kind::Message);
  EXPECT_EQ(asked.values().front().message->values().front().kind, MessageValue::Kind::Decimal)
      << "each language writes it in its own way";
  const auto refused = sherds::SherdChanges(catalogue()).apply(std::span(&slip, 1), anna);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().what, HasSubstr("Replace it with the measured value?"));
  EXPECT_EQ(valueOf(sherd, "length_mm"), "72.39");
}

TEST_F(TypedMeasure, OnceConfirmedKeepsTheComputedOneBesideIt) {
  const FieldChange replace = typed("70.5", Confirmation::Given);
  const auto undo = sherds::SherdChanges(catalogue()).apply(std::span(&replace, 1), anna);
  ASSERT_TRUE(undo) << undo.error().sentence();
  SherdRecord record = *sherds::Sherds(catalogue()).get(sherd);
  EXPECT_EQ(record.measures.at("length"), 70.5);
  EXPECT_THAT(record.replaced, ElementsAre(testing::Pair("length", 72.39)));
  EXPECT_FALSE(previewOf(typed("70.4")).asks()) << "a person's value gives way to another";
  EXPECT_FALSE(previewOf(typed("72.39")).asks()) << "nor is the computed one asked about";
  ASSERT_TRUE(sherds::SherdChanges(catalogue()).apply(*undo, anna))
      << "what undoes it asks nothing";
  record = *sherds::Sherds(catalogue()).get(sherd);
  EXPECT_EQ(record.measures.at("length"), 72.39);
  EXPECT_TRUE(record.replaced.empty());
}

TEST_F(TypedMeasure, ComparesLengthAndWidthThatChangeTogether) {
  const std::vector<FieldChange> both = {typed("50"), {sherd, "width_mm", "40"}};
  const auto previews = sherds::SherdChanges(catalogue()).preview(both);
  ASSERT_TRUE(previews);
  for (const ChangePreview& one : *previews)
    EXPECT_THAT(one.question, Not(HasSubstr("is below"))) << one.change.field;
}

TEST_F(TypedMeasure, ThatDeletesAComputedOneIsAskedAboutToo) {
  EXPECT_EQ(previewOf(typed("")).question, "The computed value is 72.39 mm. Delete it?");
}

TEST_F(TypedMeasure, WhereNothingWasComputedIsAskedAboutOnlyWhenImplausible) {
  EXPECT_FALSE(previewOf({sherd, "weight_g", "31"}).asks());
  EXPECT_FALSE(previewOf({sherd, "thickness_mean_mm", "6"}).asks());
  EXPECT_TRUE(previewOf({sherd, "thickness_mean_mm", "61"}).asks()) << "thicker than wide";
  EXPECT_FALSE(previewOf({sherd, "weight_g", "-3"}).refusal.empty());
}

}  // namespace
}  // namespace ostraka::records
