// What both houses say differently: listed, and settled by a person.
#include <gmock/gmock.h>

#include "merge/merging.h"
#include "store/database.h"
#include "two_houses.h"

namespace ostraka::merge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using namespace catalogue;

class Conflicts : public TwoCopies {
 protected:
  /// Nothing is written before it is settled; afterwards neither direction asks again.
  void settle(const Settled& settled) {
    const std::string before = contentIn(*project_), before_b = contentIn(b_);
    const MergeReport open = merged(*project_, b_);
    EXPECT_FALSE(open.entered);
    std::vector<std::string> ids;
    for (const auto& [id, choice] : settled) ids.push_back(id);
    EXPECT_THAT(openIn(open), testing::UnorderedElementsAreArray(ids));
    EXPECT_EQ(contentIn(*project_), before);
    const MergeReport done = merged(*project_, b_, settled);
    EXPECT_TRUE(done.entered);
    EXPECT_THAT(openIn(done), IsEmpty());
    EXPECT_EQ(contentIn(b_), before_b);
    const std::string after = contentIn(*project_);
    EXPECT_THAT(openIn(merged(*project_, b_)), IsEmpty());
    EXPECT_EQ(contentIn(*project_), after);
    EXPECT_THAT(openIn(merged(b_, *project_)), IsEmpty());
    EXPECT_TRUE(project_->catalogue().checkIntegrity());
    EXPECT_TRUE(b_.catalogue().checkIntegrity());
  }
  /// A new sherd in each project, with these numbers.
  std::pair<std::string, std::string> called(const std::string& in_a, const std::string& in_b) {
    const auto id = [&](upkeep::Project& project, const std::string& number) {
      const store::SherdRow sherd = newSherd(project, context13, false);
      say(project, sherd, "number", number);
      return sherds::Sherds(project.catalogue()).get(sherd)->id;
    };
    return {id(*project_, in_a), id(b_, in_b)};
  }
  std::string ownerOf(const std::string& number) {
    return catalogue()
        .database()
        .sql("SELECT s.id FROM given_number g JOIN sherd s ON s.row = g.sherd WHERE g.number = ?",
             number)
        .one<std::string>();
  }
};

TEST_F(Conflicts, AFieldThatBothChangedIsTakenFromB) {
  say(*project_, rows[0], "ware", "grey");
  say(b_, rows[0], "ware", "red");
  const std::string id = idOf(rows[0]);
  settle({{"sherd/" + id + "/ware", take(Take::B)}});
  EXPECT_EQ(saidOf(*project_, id, "ware"), "red");
  EXPECT_EQ(saidOf(b_, id, "ware"), "red");
}

TEST_F(Conflicts, AFieldThatBothChangedStaysAsInA) {
  say(*project_, rows[0], "ware", "grey");
  say(b_, rows[0], "ware", "red");
  const std::string id = idOf(rows[0]);
  settle({{"sherd/" + id + "/ware", take(Take::A)}});
  EXPECT_EQ(saidOf(*project_, id, "ware"), "grey");
  EXPECT_EQ(saidOf(b_, id, "ware"), "grey");
}

TEST_F(Conflicts, AMeasurementAndAFieldOfOnesOwnAreFieldsLikeOthers) {
  say(*project_, rows[0], "weight_g", "24");
  say(b_, rows[0], "weight_g", "25");
  say(*project_, rows[0], "extra.drawer", "8");
  say(b_, rows[0], "extra.drawer", "9");
  const std::string id = idOf(rows[0]);
  const auto kind = "sherd/" + id + "/weight";
  settle({{kind, take(Take::B)}, {"sherd/" + id + "/extra.drawer", take(Take::A)}});
  EXPECT_EQ(saidOf(*project_, id, "weight_g"), "25");
  EXPECT_EQ(saidOf(b_, id, "weight_g"), "25");
  EXPECT_EQ(saidOf(*project_, id, "extra.drawer"), "8");
}

TEST_F(Conflicts, ANumberGivenToTwoSherdsStaysWithOne) {
  const std::string own = sherds::Sherds(catalogue()).get(newSherd(*project_, context13, true))->id;
  const std::string theirs = sherds::Sherds(b_.catalogue()).get(newSherd(b_, context13, true))->id;
  ASSERT_EQ(saidOf(*project_, own, "number"), saidOf(b_, theirs, "number"));
  settle({{"number/" + theirs, take(Take::A)}});
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0001");
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "ARM1-T3-0013-0002");
}

TEST_F(Conflicts, ANumberGivenToTwoSherdsGoesToTheOther) {
  const std::string own = sherds::Sherds(catalogue()).get(newSherd(*project_, context13, true))->id;
  const std::string theirs = sherds::Sherds(b_.catalogue()).get(newSherd(b_, context13, true))->id;
  settle({{"number/" + theirs, take(Take::B)}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "ARM1-T3-0013-0001");
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0002");
}

TEST_F(Conflicts, ANumberGivenToTwoSherdsBecomesANewOne) {
  newSherd(*project_, context13, true);
  const std::string theirs = sherds::Sherds(b_.catalogue()).get(newSherd(b_, context13, true))->id;
  const Result<MergeReport> taken =
      tried(*project_, b_, {{"number/" + theirs, {Take::Number, "ARM1-T3-0012-0001"}}});
  ASSERT_FALSE(taken);
  EXPECT_THAT(taken.error().what, testing::HasSubstr("never reused"));
  settle({{"number/" + theirs, {Take::Number, "ARM1-T3-0013-0101"}}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "ARM1-T3-0013-0101");
}

TEST_F(Conflicts, ANumberInOtherLettersGoesToTheOther) {
  const auto [own, theirs] = called("q-7", "Q-7");
  settle({{"number/" + theirs, take(Take::B)}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "Q-7");
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0001");
  EXPECT_EQ(ownerOf("Q-7"), theirs);
}

TEST_F(Conflicts, ANumberWithTheSameFileNameGoesToTheOther) {
  const auto [own, theirs] = called("R/1", "R_1");
  settle({{"number/" + theirs, take(Take::B)}});
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "R_1");
  EXPECT_EQ(saidOf(*project_, own, "number"), "ARM1-T3-0013-0001");
  EXPECT_EQ(ownerOf("R_1"), theirs);
}

TEST_F(Conflicts, ANumberThatASherdHadBeforeStaysItsOwn) {
  say(*project_, rows[0], "number", "N-9");
  const auto [own, theirs] = called("N-8", "N-9");
  say(*project_, rows[0], "number", "N-10");
  settle({{"number/" + theirs, take(Take::A)}});
  EXPECT_EQ(ownerOf("N-9"), idOf(rows[0]));
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "ARM1-T3-0013-0001");
}

TEST_F(Conflicts, ANumberThatASherdHadBeforeGoesToAnotherAsAPersonSays) {
  say(*project_, rows[0], "number", "N-9");
  const auto [own, theirs] = called("N-8", "N-9");
  say(*project_, rows[0], "number", "N-10");
  settle({{"number/" + theirs, take(Take::B)}});
  EXPECT_EQ(ownerOf("N-9"), theirs);
  EXPECT_EQ(saidOf(*project_, theirs, "number"), "N-9");
  EXPECT_EQ(valueOf(rows[0], "number"), "N-10");
}

TEST_F(Conflicts, ANewNumberIsCheckedAsATypedOne) {
  const auto [own, theirs] = called("q-7", "q-7");
  for (const std::string& number : {std::string("8\0x", 3), std::string("a\nb"), std::string("  "),
                                    std::string("8\u202e"), std::string(121, 'x')}) {
    const Result<MergeReport> refused =
        tried(*project_, b_, {{"number/" + theirs, {Take::Number, number}}});
    ASSERT_FALSE(refused) << number;
    EXPECT_EQ(refused.error().where, "number/" + theirs);
  }
}

class TwoPlaces : public Conflicts {
 protected:
  std::string made(upkeep::Project& project, const std::string& period) {
    records::ContextRecord c;
    c.site = site;
    c.trench = trench;
    c.number = "0099";
    c.period = period;
    return Places(project.catalogue()).context(*Places(project.catalogue()).save(c, anna))->id;
  }
  std::size_t contexts() { return Places(catalogue()).contexts()->size(); }
};

TEST_F(TwoPlaces, ThatSayTheSameAreOneByThemselves) {
  made(*project_, "");
  made(b_, "Iron Age");
  const std::size_t before = contexts();
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_EQ(contexts(), before);
  const std::string after = contentIn(*project_);
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_EQ(contentIn(*project_), after);
  EXPECT_TRUE(merged(b_, *project_).entered);
}

TEST_F(TwoPlaces, ThatSayOtherThingsAreOneAsAPersonSays) {
  made(*project_, "Bronze Age");
  const std::string theirs = made(b_, "Iron Age");
  const std::size_t before = contexts();
  settle({{"context/" + theirs, take(Take::B)}});
  EXPECT_EQ(contexts(), before);
  const auto all_contexts = valueIn(Places(catalogue()).contexts());
  EXPECT_EQ(std::count_if(all_contexts.begin(), all_contexts.end(),
                          [](const auto& c) { return c.period == "Iron Age"; }),
            1);
}

TEST_F(TwoPlaces, ThatSayOtherThingsAreTwoUnderAnotherNumber) {
  made(*project_, "Bronze Age");
  const std::string theirs = made(b_, "Iron Age");
  const std::size_t before = contexts();
  settle({{"context/" + theirs, {Take::Number, "0100"}}});
  EXPECT_EQ(contexts(), before + 1);
}

TEST_F(TwoPlaces, KeepANumberThatNoOtherPlaceHas) {
  made(*project_, "Bronze Age");
  const std::string conflict = "context/" + made(b_, "Iron Age");
  const std::string before = contentIn(*project_);
  for (const char* number : {"0099", "0012", " 0013 "}) {
    const Result<MergeReport> taken = tried(*project_, b_, {{conflict, {Take::Number, number}}});
    ASSERT_FALSE(taken) << number;
    EXPECT_EQ(taken.error().code, ErrorCode::UnusableInput);
    EXPECT_THAT(taken.error().what, testing::HasSubstr(conflict));
  }
  EXPECT_EQ(contentIn(*project_), before);
}

TEST_F(TwoPlaces, AreNumberedAsIfTyped) {
  made(*project_, "Bronze Age");
  const std::string conflict = "context/" + made(b_, "Iron Age");
  for (const std::string& number : {std::string("8\0x", 3), std::string("a\nb"), std::string("  "),
                                    std::string("8\u202e"), std::string(1'500'000, 'x')}) {
    const Result<MergeReport> refused = tried(*project_, b_, {{conflict, {Take::Number, number}}});
    ASSERT_FALSE(refused) << number.substr(0, 9);
    EXPECT_EQ(refused.error().where, conflict);
  }
}

TEST_F(TwoPlaces, StayOneWhenOneIsRenamed) {
  made(*project_, "");
  made(b_, "");
  EXPECT_TRUE(merged(*project_, b_).entered);
  const std::size_t before = contexts();
  for (records::ContextRecord& c : valueIn(Places(catalogue()).contexts())) {
    if (c.number != "0099") continue;
    c.number = "0100";
    ASSERT_TRUE(Places(catalogue()).save(c, anna));
  }
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_EQ(contexts(), before);
}

class Aliases : public TwoPlaces {
 protected:
  /// As merges note it.
  static void callTheSame(upkeep::Project& in, const std::string& one, const std::string& other) {
    in.catalogue().database().run("INSERT INTO setting VALUES (?, ?)", kSameRow + one, other);
  }
  std::string contextCalled(const std::string& number) {
    const store::ContextRow row = *Places(catalogue()).contextByPlace("ARM1", "T3", number);
    return Places(catalogue()).context(row)->id;
  }
};

TEST_F(Aliases, OfRowsOfTwoTablesAreRefusedByName) {
  const std::string theirs = made(b_, "Iron Age");
  callTheSame(b_, theirs, idOf(rows[0]));
  const std::string before = contentIn(*project_);
  const Result<MergeReport> refused = tried(*project_, b_, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(refused.error().what, testing::HasSubstr(kSameRow + theirs));
  EXPECT_EQ(contentIn(*project_), before);
}

TEST_F(Aliases, OfPlacesWithDifferentNumbersAreRefused) {
  const std::string theirs = made(b_, "Iron Age");
  records::ContextRecord c;
  c.site = site;
  c.trench = trench;
  c.number = "0020";
  ASSERT_TRUE(Places(catalogue()).save(c, anna));
  callTheSame(b_, contextCalled("0020"), theirs);
  const Result<MergeReport> refused = tried(*project_, b_, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().what, testing::HasSubstr("the same"));
}

TEST_F(Aliases, OfAThatDoNotFitMeanNothing) {
  const std::string theirs = made(b_, "Iron Age");
  const store::ContextRow row = *Places(b_.catalogue()).contextByPlace("ARM1", "T3", "0099");
  const std::string sherd = sherds::Sherds(b_.catalogue()).get(newSherd(b_, row, false))->id;
  callTheSame(*project_, theirs, idOf(rows[0]));
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_EQ(saidOf(*project_, sherd, "context"), "0099");
}

class TwoDecisions : public Conflicts {
 protected:
  void decide(upkeep::Project& project, records::Verdict verdict) {
    const std::vector<records::ScanRecord> scans =
        valueIn(Batches(project.catalogue()).scans(batch));
    records::PairDecision d;
    d.batch = batch;
    d.verdict = verdict;
    for (const records::ScanRecord& scan : scans)
      if (scan.index == 1) (scan.side == batch::Side::Front ? d.front : d.back) = scan.row;
    EXPECT_TRUE(sherds::PairDecisions(project.catalogue()).add(d, anna));
  }
  bool accepted() {
    for (const auto& d : valueIn(sherds::PairDecisions(catalogue()).current(batch)))
      if (d.by && d.verdict == records::Verdict::Accept) return true;
    return false;
  }
};

TEST_F(TwoDecisions, ThatAreTheSameNeedNoPerson) {
  decide(*project_, records::Verdict::Accept);
  decide(b_, records::Verdict::Accept);
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_TRUE(accepted());
}

TEST_F(TwoDecisions, ThatDifferOnOnePairAreSettledAndNoneGoes) {
  decide(*project_, records::Verdict::Reject);
  decide(b_, records::Verdict::Accept);
  const MergeReport open = merged(*project_, b_);
  Settled settled;
  for (const std::string& id : openIn(open)) settled[id] = take(Take::B);
  ASSERT_FALSE(settled.empty());
  EXPECT_TRUE(settled.begin()->first.starts_with("pair/"));
  const std::size_t before = sherds::PairDecisions(catalogue()).all(batch)->size();
  EXPECT_TRUE(merged(*project_, b_, settled).entered);
  EXPECT_TRUE(accepted());
  EXPECT_EQ(sherds::PairDecisions(catalogue()).all(batch)->size(), before + 2)
      << "B's, and the withdrawal of A's";
  const std::string after = contentIn(*project_);
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_EQ(contentIn(*project_), after);
}

class TwoComputations : public Conflicts {
 protected:
  /// B0005 in both projects, computed in each; b_moves: by how much B finds its pieces elsewhere.
  void compute(double b_moves_mm) {
    for (upkeep::Project* project : {&*project_, &b_}) {
      records::BatchRecord b;
      b.number = "B0005";
      b.id = kBatch;
      const store::BatchRow row = valueIn(Batches(project->catalogue()).add(b, anna));
      ResultFolder two(project->resultsFolder("B0005"), 2);
      if (project == &b_)
        for (Eigen::Vector2d& place : two.places_mm) place.x() += b_moves_mm;
      two.write();
      ASSERT_TRUE(intake::enterResults(project->catalogue(), project->folder(), row,
                                       project->resultsFolder("B0005"), {}, quiet, {}));
      ASSERT_EQ(sherds::Sherds(project->catalogue()).rows(row)->size(), 2u);
    }
  }
  std::size_t sherdsOfBatch() {
    const store::BatchRow row = Batches(catalogue()).byNumber("B0005")->row;
    return sherds::Sherds(catalogue()).rows(row)->size();
  }
  const std::string kBatch = "01980000-0000-7000-8000-000000000005";
};

TEST_F(TwoComputations, ThatFoundTheSameAreOneByThemselves) {
  compute(0);
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_EQ(sherdsOfBatch(), 2u);
}

TEST_F(TwoComputations, ThatFoundOtherPiecesKeepTheResultsOfA) {
  compute(30);
  settle({{"batch/" + kBatch + "/results", take(Take::A)}});
  EXPECT_EQ(sherdsOfBatch(), 4u) << "nothing is lost";
}

}  // namespace
}  // namespace ostraka::merge
