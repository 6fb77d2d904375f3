#include "sherds/typed_numbers.h"

#include <gmock/gmock.h>

#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "cloud/ply.h"
#include "intake/enter_results.h"
#include "intake/plate_sherds.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/numbers.h"
#include "sherds/pair_decisions.h"
#include "sherds/photographed_again.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/result_folder.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

using testing::ElementsAre;

// Three sherds 50 mm apart on a plate; the results come when entered.
class TypedNumbers : public catalogue::SmallProject {
 protected:
  TypedNumbers() : batch(newBatch({bag4})) {}
  void results(bool doubtful = false) {
    catalogue::ResultFolder out(project_->resultsFolder("B0001"), 3);
    out.pairs()[0].ambiguous = out.pairs()[1].ambiguous = doubtful;
    out.write();
    for (const int i : {1, 2, 3}) {
      PointCloud cloud;
      const auto x = static_cast<float>(50 * i);
      cloud.points = {{x - 2, 10, 0}, {x + 2, 10, 0}};
      EXPECT_TRUE(writePly(project_->resultsFolder("B0001") / "work/scans_front" /
                               ("f00" + std::to_string(i) + ".ply"),
                           cloud, "plate_front"));
    }
  }
  intake::EnteredResults enter() {
    QuietProgress quiet;
    const auto entered = intake::enterResults(catalogue(), project_->folder(), batch,
                                              project_->resultsFolder("B0001"), {}, quiet, {});
    EXPECT_TRUE(entered) << (entered ? "" : entered.error().sentence());
    return entered ? *entered : intake::EnteredResults{};
  }
  std::string numberOf(const std::string& front) {
    for (const records::ScanRecord& scan :
         catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch)))
      if (scan.name == front)
        for (const records::SherdRecord& sherd : catalogue::valueIn(
                 Sherds(catalogue()).of(catalogue::valueIn(Sherds(catalogue()).rows(batch)))))
          if (sherd.front == scan.row) return sherd.number;
    return "no sherd";
  }
  Result<void> type(const std::vector<TypedNumber>& numbers) {
    return setTypedNumbers(catalogue(), batch, numbers);
  }
  store::BatchRow batch;
};

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

// Sherd 1 of B0001 is set for new photographs and lies on the plate of B0002.
TEST_F(TypedNumbers, OfASherdThatWaitsForNewPhotographsFindIt) {
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
TEST_F(TypedNumbers, OfASherdThatIsAskedForAfterItsPlateWasComputedFindItWithItsModel) {
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
  EXPECT_THAT(compute()->numbers_left, ElementsAre(before.number)) << "it has its old pair";
  ASSERT_TRUE(PairDecisions(catalogue()).add(reshoot, anna));
  EXPECT_TRUE(compute()->numbers_left.empty());
  const records::SherdRecord after = *Sherds(catalogue()).get(row);
  EXPECT_EQ(after.batch, again);
  EXPECT_THAT(after.model_path, testing::StartsWith("models/B0002/"));
  EXPECT_EQ(after.measures.at("length"), 51);
}

TEST_F(TypedNumbers, ThatCameAfterADescriptionTakeItAlong) {
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
