// What both houses say differently: listed, and settled by a person.
#include <gmock/gmock.h>

#include "merge/merging.h"
#include "store/database.h"
#include "two_houses.h"

namespace ostraka::merge {
namespace {

using namespace catalogue;

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

}  // namespace
}  // namespace ostraka::merge
