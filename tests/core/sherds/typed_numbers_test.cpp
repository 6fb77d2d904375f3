#include "sherds/typed_numbers.h"

#include <gmock/gmock.h>

#include "catalogue/settings.h"
#include "records/sherd.h"
#include "sherds/numbers.h"
#include "sherds/pair_decisions.h"
#include "tests/core/sherds/three_on_a_plate.h"

namespace ostraka::sherds {
namespace {

using testing::ElementsAre;

using TypedNumbers = ThreeOnAPlate;

TEST_F(TypedNumbers, FollowTheirSherdsByTheirPlaces) {
  ASSERT_TRUE(type({{{152, 14}, "ARM1-T3-0012-0007"}, {{47, 6}, "OLD-1"}}));
  results();
  EXPECT_TRUE(enter().numbers_left.empty());
  EXPECT_EQ(numberOf("f003"), "ARM1-T3-0012-0007");
  EXPECT_EQ(numberOf("f001"), "OLD-1");
  EXPECT_EQ(numberOf("f002"), "");
  EXPECT_TRUE(enter().numbers_left.empty()) << "twice gives once";
}

TEST_F(TypedNumbers, ThatAPersonTookAwayStayAway) {
  ASSERT_TRUE(type({{{152, 14}, "A-7"}, {{47, 6}, "A-1"}}));
  results();
  enter();
  ASSERT_TRUE(set(*Sherds(catalogue()).byNumber("A-7"), "number", ""));
  EXPECT_TRUE(enter().numbers_left.empty());
  EXPECT_EQ(numberOf("f003"), "");
  EXPECT_EQ(numberOf("f001"), "A-1");
}

TEST_F(TypedNumbers, StayWithTheFrontOfADoubtfulPairWhateverIsDecided) {
  ASSERT_TRUE(type({{{50, 10}, "A-1"}, {{100, 10}, "A-2"}}));
  results(true);
  enter();
  EXPECT_EQ(numberOf("f001"), "A-1");
  EXPECT_EQ(numberOf("f002"), "A-2");
  std::map<std::string, store::ScanRow> scans;
  for (const records::ScanRecord& scan :
       catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch)))
    scans[scan.name] = scan.row;
  records::PairDecision swapped;
  swapped.batch = batch;
  swapped.front = scans["f001"];
  swapped.back = scans["b002"];
  ASSERT_TRUE(PairDecisions(catalogue()).add(swapped, anna));
  EXPECT_EQ(numberOf("f001"), "A-1");
}

TEST_F(TypedNumbers, ThatFindNoSherdAreNamed) {
  ASSERT_TRUE(type({{{50, 200}, "FAR-1"}, {{100, 12}, "NEAR-1"}, {{100, 18}, "NEAR-2"}}));
  results();
  EXPECT_THAT(enter().numbers_left, ElementsAre("FAR-1", "NEAR-2"));
  EXPECT_EQ(numberOf("f002"), "NEAR-1");
}

TEST_F(TypedNumbers, AreRefusedWhenTheyAreNotUnique) {
  const store::SherdRow photographed = numbered(context12);
  ASSERT_TRUE(Sherds(catalogue()).setModel(photographed, "models/B0007/1/model.ply", ""));
  const auto why = [&](const std::vector<TypedNumber>& numbers) {
    const Result<void> done = type(numbers);
    return done ? std::string("accepted") : done.error().what.english();
  };
  EXPECT_EQ(why({{{0, 0}, "A-1"}, {{50, 0}, "a-1"}}),
            "The number a-1 appears on two sherds of this plate.");
  EXPECT_EQ(why({{{0, 0}, "ARM1-T3-0012-0001"}}),
            "The number ARM1-T3-0012-0001 already belongs to another sherd.");
  ASSERT_TRUE(type({{{0, 0}, "A-1"}}));
  const TypedNumber again{{0, 0}, "A-1"};
  EXPECT_FALSE(setTypedNumbers(catalogue(), newBatch({bag5}), std::span(&again, 1)))
      << "it waits on another plate";
  EXPECT_EQ(catalogue::valueIn(typedNumbers(catalogue(), batch)).size(), 1u);
}

TEST_F(TypedNumbers, AreGivenToNobodyElseBeforeTheirPlateIsComputed) {
  ASSERT_TRUE(type({{{50, 10}, "A-1"}, {{400, 10}, "A-9"}}));
  const store::SherdRow other = numbered(context12);
  const auto refused = set(other, "number", "a-1");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what,
            "The number a-1 was entered for a sherd of B0001, which is not processed yet.");
  const TypedNumber lost{{10, 10}, "A-9"};
  const store::BatchRow next = newBatch({bag4});
  EXPECT_FALSE(setTypedNumbers(catalogue(), next, std::span(&lost, 1)));
  results();
  EXPECT_THAT(enter().numbers_left, ElementsAre("A-9"));
  EXPECT_EQ(numberOf("f001"), "A-1");
  EXPECT_TRUE(setTypedNumbers(catalogue(), next, std::span(&lost, 1)))
      << "no sherd lay there: it is laid down once more";
}

TEST_F(TypedNumbers, OneThatIsTakenMeanwhileHindersNoOther) {
  ASSERT_TRUE(type({{{50, 10}, "A-1"}}));
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Failed, {}));
  const store::SherdRow other = numbered(context12);
  ASSERT_TRUE(Sherds(catalogue()).setModel(other, "models/B0007/1/model.ply", ""));
  ASSERT_TRUE(set(other, "number", "A-1"));
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Flipped, {}));
  EXPECT_TRUE(type({{{50, 10}, "A-1"}, {{100, 10}, "A-2"}}));
  EXPECT_TRUE(type({{{100, 10}, "A-2"}})) << "and can be taken away";
  EXPECT_FALSE(type({{{50, 10}, "A-1"}, {{100, 10}, "A-2"}}));
}

TEST_F(TypedNumbers, AreNotProposedToOthers) {
  ASSERT_TRUE(type({{{0, 0}, "ARM1-T3-0012-0001"}}));
  const std::vector<store::SherdRow> rows = {draft(context12)};
  EXPECT_THAT(*Numbers(catalogue()).propose(rows), ElementsAre("ARM1-T3-0012-0002"));
}

TEST_F(TypedNumbers, DigitsAndCodesOfLabelsBecomeWholeNumbers) {
  const auto whole = [&](const std::string& typed) {
    return *wholeNumber(catalogue(), batch, typed);
  };
  EXPECT_EQ(whole(" 7 "), "ARM1-T3-0012-0007");
  EXPECT_EQ(whole("OST1:S:ARM1-T3-0012-0009:7F3K9Q2M"), "ARM1-T3-0012-0009");
  EXPECT_EQ(whole("ost1:s:12:7:7f3k9q2m"), "12:7") << "a number with a colon";
  EXPECT_FALSE(wholeNumber(catalogue(), batch, "OST1:S:ARM1-T3")) << "half a code";
  EXPECT_FALSE(wholeNumber(catalogue(), batch, "OST1:S:B0031-01")) << "a place is no number";
  const std::string id = valueOf(numbered(context13), "uuid");
  EXPECT_EQ(whole("OST1:S:B0031-01:" + id.substr(id.size() - 8)), "ARM1-T3-0013-0001")
      << "it had none when the label was printed";
  EXPECT_EQ(whole("Ar/Ts.WSH.02.C.12"), "Ar/Ts.WSH.02.C.12");
  EXPECT_FALSE(wholeNumber(catalogue(), newBatch({}), "7")) << "no context says whose seventh";
}

TEST_F(TypedNumbers, DigitsMeanTheSameForOneSherdInItsContext) {
  const store::SherdRow there = draft(context13, bag1), nowhere = draft({});
  EXPECT_EQ(*wholeNumber(catalogue(), there, "62"), "ARM1-T3-0013-0062");
  EXPECT_EQ(*wholeNumber(catalogue(), there, " =62 "), "62") << "as it stands";
  EXPECT_EQ(*wholeNumber(catalogue(), there, "A 62"), "A 62");
  EXPECT_EQ(*wholeNumber(catalogue(), there, ""), "");
  EXPECT_FALSE(wholeNumber(catalogue(), nowhere, "62")) << "no context says whose";
  EXPECT_EQ(*wholeNumber(catalogue(), batch, "=62"), "62");
  EXPECT_FALSE(wholeNumber(catalogue(), batch, " = ")) << "it would take the number away";
}

TEST_F(TypedNumbers, ALabelsNumberThatLooksLikeAPlaceIsOneWhereTheSchemeGivesSuch) {
  const auto whole = [&](const std::string& typed) {
    const Result<std::string> number = wholeNumber(catalogue(), batch, typed);
    return number ? *number : std::string();
  };
  EXPECT_EQ(whole("OST1:S:B0031-01:7F3K9Q2M"), "") << "a sherd of another laptop without a number";
  records::ProjectRecord record = *catalogue::Settings(catalogue()).project();
  for (const auto& [scheme, number] :
       {std::pair{"{batch}-{n:02}", "B0031-01"}, std::pair{"B{yy}-{n:04}", "B26-0012"}}) {
    record.numbering = scheme;
    ASSERT_TRUE(catalogue::Settings(catalogue()).setProject(record, anna));
    EXPECT_EQ(whole(std::string("OST1:S:") + number + ":7F3K9Q2M"), number);
    EXPECT_EQ(whole(std::string("OST1:S:") + number), "") << "without an id it is a place";
  }
  EXPECT_EQ(whole("OST1:S:B0031-01:7F3K9Q2M"), "") << "the scheme pads to four digits";
  const store::SherdRow none = draft(context12);
  const std::string id = valueOf(none, "uuid");
  EXPECT_EQ(whole("OST1:S:B26-0012:" + id.substr(id.size() - 8)), "") << "it has no number";
}

}  // namespace
}  // namespace ostraka::sherds
