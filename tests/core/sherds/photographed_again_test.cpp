#include "sherds/photographed_again.h"

#include <gmock/gmock.h>

#include "intake/plate_sherds.h"
#include "sherds/numbers.h"
#include "sherds/pair_decisions.h"
#include "tests/core/sherds/three_on_a_plate.h"

namespace ostraka::sherds {
namespace {

using SherdsOnTwoPlates = ThreeOnAPlate;

// Sherd 1 of B0001 is set for new photographs and lies on the plate of B0002.
TEST_F(SherdsOnTwoPlates, ThatWaitForNewPhotographsAreFoundByTheirNumbers) {
  ASSERT_TRUE(type({{{50, 10}, "ARM1-T3-0012-0031"}}));
  results();
  enter();
  const std::vector<store::SherdRow> rows = catalogue::valueIn(Sherds(catalogue()).rows(batch));
  ASSERT_TRUE(Numbers(catalogue()).assign(rows, anna));
  const records::SherdRecord before = *Sherds(catalogue()).get(rows[0]);
  ASSERT_FALSE(before.number.empty());
  ASSERT_TRUE(set(before.row, "note", "a handle"));
  const TypedNumber typed{{50, 10}, before.number};
  const store::BatchRow again = newBatch({bag5});
  EXPECT_FALSE(setTypedNumbers(catalogue(), again, std::span(&typed, 1))) << "it has its pair";
  EXPECT_TRUE(toPhotographAgain(catalogue())->empty());

  records::PairDecision reshoot;
  reshoot.batch = batch;
  reshoot.verdict = records::Verdict::Reshoot;
  reshoot.front = before.front;
  reshoot.back = before.back;
  const store::DecisionRow asked =
      catalogue::valueIn(PairDecisions(catalogue()).add(reshoot, anna));
  ASSERT_EQ(toPhotographAgain(catalogue())->size(), 1u);
  EXPECT_EQ(toPhotographAgain(catalogue())->front().number, before.number);
  ASSERT_TRUE(setTypedNumbers(catalogue(), again, std::span(&typed, 1)));

  catalogue::ResultFolder out(project_->resultsFolder("B0002"), 2);
  out.places_mm = {{50, 10}, {100, 10}};
  out.length_mm = 70;
  out.write();
  QuietProgress quiet;
  const auto entered = intake::enterResults(catalogue(), project_->folder(), again,
                                            project_->resultsFolder("B0002"), {}, quiet, {});
  ASSERT_TRUE(entered) << entered.error().sentence();
  EXPECT_TRUE(entered->numbers_left.empty());
  const records::SherdRecord after = *Sherds(catalogue()).get(before.row);
  EXPECT_EQ(after.number, before.number);
  EXPECT_EQ(after.note, "a handle");
  EXPECT_EQ(after.batch, again);
  EXPECT_TRUE(after.back);
  EXPECT_EQ(after.measures.at("length"), 71);
  const std::vector<UnlikeBefore> unlike = catalogue::valueIn(unlikeBefore(catalogue(), again));
  ASSERT_EQ(unlike.size(), 1u) << "it was 61 mm long; is it the same?";
  EXPECT_EQ(unlike[0].number, before.number);
  EXPECT_EQ(unlike[0].now_mm, 71);
  EXPECT_THAT(after.model_path, testing::StartsWith("models/B0002/"));
  EXPECT_TRUE(toPhotographAgain(catalogue())->empty());
  const std::vector<PhotographedAgain> moved =
      catalogue::valueIn(photographedAgain(catalogue(), batch));
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(moved[0].front, before.front);
  EXPECT_EQ(moved[0].number, before.number);
  EXPECT_EQ(moved[0].batch_number, "B0002");
  EXPECT_TRUE(photographedAgain(catalogue(), again)->empty());
  const intake::PlateSherds old_plate(catalogue(), "B0001");
  ASSERT_NE(old_plate.again({50, 10}), nullptr) << "nobody photographs it a third time";
  EXPECT_EQ(old_plate.again({100, 10}), nullptr);
  int unnumbered = 0;
  const auto on_plate = Sherds(catalogue()).of(*Sherds(catalogue()).rows(again));
  for (const records::SherdRecord& sherd : *on_plate)
    unnumbered += sherd.number.empty() && sherd.state != records::SherdState::Void ? 1 : 0;
  EXPECT_EQ(unnumbered, 1) << "the other one of the plate";
  // Computed again, or the old plate's word taken back: it stays what it is.
  ASSERT_TRUE(intake::enterResults(catalogue(), project_->folder(), again,
                                   project_->resultsFolder("B0002"), {}, quiet, {}));
  records::PairDecision back;
  back.batch = batch;
  back.verdict = records::Verdict::Withdraw;
  back.replaces = asked;
  ASSERT_TRUE(PairDecisions(catalogue()).add(back, anna));
  EXPECT_EQ(Sherds(catalogue()).get(before.row)->front, after.front);
  EXPECT_EQ(Sherds(catalogue()).get(before.row)->model_path, after.model_path);
  // Those photographs are no good either: once more.
  reshoot.batch = again;
  reshoot.front = after.front;
  reshoot.back = after.back;
  ASSERT_TRUE(PairDecisions(catalogue()).add(reshoot, anna));
  ASSERT_EQ(toPhotographAgain(catalogue())->size(), 1u);
  EXPECT_TRUE(setTypedNumbers(catalogue(), newBatch({bag5}), std::span(&typed, 1)));
}

// Its request was taken back while the new plate was computed, and made again afterwards.
TEST_F(SherdsOnTwoPlates, ThatAreAskedForAfterTheirPlateWasComputedTakeItsModel) {
  results();
  enter();
  const store::SherdRow row = catalogue::valueIn(Sherds(catalogue()).rows(batch))[0];
  ASSERT_TRUE(Numbers(catalogue()).assign(std::span(&row, 1), anna));
  const records::SherdRecord before = *Sherds(catalogue()).get(row);
  records::PairDecision reshoot;
  reshoot.batch = batch;
  reshoot.verdict = records::Verdict::Reshoot;
  reshoot.front = before.front;
  reshoot.back = before.back;
  const store::DecisionRow asked =
      catalogue::valueIn(PairDecisions(catalogue()).add(reshoot, anna));
  const TypedNumber typed{{50, 10}, before.number};
  const store::BatchRow again = newBatch({bag4});
  ASSERT_TRUE(setTypedNumbers(catalogue(), again, std::span(&typed, 1)));
  records::PairDecision back;
  back.batch = batch;
  back.verdict = records::Verdict::Withdraw;
  back.replaces = asked;
  ASSERT_TRUE(PairDecisions(catalogue()).add(back, anna));
  catalogue::ResultFolder out(project_->resultsFolder("B0002"), 2);
  out.places_mm = {{50, 10}, {100, 10}};
  out.write();
  const auto compute = [&] {
    QuietProgress quiet;
    return intake::enterResults(catalogue(), project_->folder(), again,
                                project_->resultsFolder("B0002"), {}, quiet, {});
  };
  EXPECT_THAT(compute()->numbers_left, testing::ElementsAre(before.number))
      << "it has its old pair";
  ASSERT_TRUE(PairDecisions(catalogue()).add(reshoot, anna));
  EXPECT_TRUE(compute()->numbers_left.empty());
  const records::SherdRecord after = *Sherds(catalogue()).get(row);
  EXPECT_EQ(after.batch, again);
  EXPECT_THAT(after.model_path, testing::StartsWith("models/B0002/"));
  EXPECT_EQ(after.measures.at("length"), 51);
}

TEST_F(SherdsOnTwoPlates, ThatWereNumberedAfterADescriptionTakeItAlong) {
  results();
  enter();
  const store::SherdRow draft = catalogue::valueIn(Sherds(catalogue()).rows(batch))[0];
  ASSERT_TRUE(set(draft, "note", "burnt on one side"));
  ASSERT_TRUE(set(draft, "ware", "red slip"));
  ASSERT_TRUE(set(draft, "fabric", "coarse"));
  ASSERT_TRUE(set(draft, "weight_g", "41.5"));
  ASSERT_TRUE(set(draft, "length_mm", "72"));
  const store::SherdRow listed = numbered(context12);
  ASSERT_TRUE(set(listed, "note", "from the list"));
  ASSERT_TRUE(set(listed, "fabric", "fine"));
  ASSERT_TRUE(set(listed, "weight_g", "40"));
  const std::string number = Sherds(catalogue()).get(listed)->number;
  ASSERT_TRUE(type({{{50, 10}, number}}));
  ASSERT_THAT(*giveTypedNumbers(catalogue(), batch, anna), testing::IsEmpty());

  const records::SherdRecord after = *Sherds(catalogue()).get(listed);
  EXPECT_TRUE(after.front);
  EXPECT_EQ(after.note, "from the list; burnt on one side");
  EXPECT_EQ(after.ware, "red slip");
  EXPECT_EQ(after.fabric, "fine") << "what it says itself holds";
  EXPECT_EQ(after.measures.at("weight"), 40);
  EXPECT_EQ(after.measures.at("length"), 72) << "by a person";
  const records::SherdRecord left = *Sherds(catalogue()).get(draft);
  EXPECT_EQ(left.state, records::SherdState::Void);
  EXPECT_EQ(left.fabric, "coarse") << "still to be read";
}

}  // namespace
}  // namespace ostraka::sherds
