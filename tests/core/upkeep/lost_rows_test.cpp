// Sherds and places of which only the history and other rows speak.
#include <gmock/gmock.h>

#include "catalogue/places.h"
#include "sherds/measurements.h"
#include "tests/core/upkeep/repaired_project.h"

namespace ostraka::upkeep {
namespace {

using ::testing::Contains;
using ::testing::Not;

using LostTables = RepairedProject;

// Site ARM2 with trench T9 and context 0099, and a sherd there with a weight: all newer than the
// backup.
class LostRows : public RepairedProject {
 protected:
  void SetUp() override {
    old_ = numbered(context12);
    ASSERT_TRUE(project_->backUp());
    std::vector<std::string> made;
    catalogue::Places places(catalogue());
    ASSERT_TRUE(places.contextAt("ARM2", "T9", "0099", anna, made));
    sherd_ = placed("ARM2", "T9", "0099", "X-1");
    ASSERT_TRUE(set(sherd_, "weight_g", "12.5 ± 0.4"));
    ASSERT_TRUE(set(sherd_, "joins", numberOf(old_)));
  }
  void expectTheSherdAsItWas() {
    EXPECT_EQ(sherds::Sherds(catalogue()).rows({}, {})->size(), 2u);
    EXPECT_EQ(sherds::Sherds(catalogue()).byNumber("X-1")->value, sherd_.value);
    EXPECT_EQ(valueOf(sherd_, "site"), "ARM2");
    EXPECT_EQ(valueOf(sherd_, "trench"), "T9");
    EXPECT_EQ(valueOf(sherd_, "context"), "0099");
    EXPECT_EQ(valueOf(sherd_, "weight_g"), "12.5");
    EXPECT_EQ(valueOf(sherd_, "joins"), numberOf(old_));
    EXPECT_EQ(found("ARM2").size(), 1u);
  }
  store::SherdRow old_, sherd_;
};

TEST_F(LostRows, AreMadeAnewWhereTheContextIsLost) {
  const std::vector<std::string> words = repairedWithout("context");
  expectTheSherdAsItWas();
  EXPECT_THAT(words, Contains("context 3 (0099): from the history"));
  EXPECT_THAT(words, Contains("context 3 (0099), kind, excavated_on, period, date_edtf, note: not "
                              "restored"));
}

TEST_F(LostRows, AreMadeAnewWhereTheTrenchIsLost) {
  repairedWithout("trench");
  expectTheSherdAsItWas();
}

TEST_F(LostRows, AreMadeAnewWhereTheSiteIsLost) {
  EXPECT_THAT(repairedWithout("site"), Contains("site 2 (ARM2): from the history"));
  expectTheSherdAsItWas();
}

TEST_F(LostRows, AreThoseOfASherdWhoseOwnRowIsLost) {
  const std::vector<std::string> words = repairedWithout("sherd");
  expectTheSherdAsItWas();
  EXPECT_THAT(words, Contains("sherd 2 (X-1): from the history"));
  EXPECT_THAT(words, Not(Contains("sherd_join: not restored")));
  EXPECT_THAT(words, Not(Contains("measurement: not restored")));
}

TEST_F(LostRows, MeasurementsThatAreLostComeFromTheHistory) {
  const std::vector<std::string> words = repairedWithout("measurement");
  expectTheSherdAsItWas();
  EXPECT_THAT(words, Contains("sherd 2 (X-1), weight: from the history"));
  const auto measures = *sherds::Measurements(catalogue()).of(sherd_);
  ASSERT_EQ(measures.size(), 1u);
  EXPECT_EQ(measures[0].uncertainty, 0.4);
}

TEST_F(LostRows, NumbersThatWereGivenStayTaken) {
  ASSERT_TRUE(set(sherd_, "number", "X-2"));
  repairedWithout("given_number");
  EXPECT_EQ(sherds::Sherds(catalogue()).byNumber("X-2")->value, sherd_.value);
  EXPECT_FALSE(set(old_, "number", "X-1"));
}

// The photographed sherd's history does not name its place.
TEST_F(LostTables, ASherdStaysWhereNothingTellsTheSiteOfItsContext) {
  ASSERT_TRUE(project_->backUp());
  const store::SherdRow sherd = numbered(context("0050"));
  const std::string number = numberOf(sherd);
  const std::vector<std::string> words = repairedWithout("context");
  EXPECT_EQ(numberOf(sherd), number);
  EXPECT_EQ(valueOf(sherd, "context"), "0050");
  EXPECT_EQ(valueOf(sherd, "site"), "ARM1") << "the only one";
  EXPECT_THAT(words, Contains("context 3 (0050), site, trench, kind, excavated_on, period, "
                              "date_edtf, note: not restored"));
}

TEST_F(LostTables, TheRowNumberOfALostSherdIsNotGivenAgain) {
  const store::SherdRow first = draft(context12);
  catalogue::remember(catalogue(), anna, "sherd", first.value + 6, "note", "", "lost");
  EXPECT_EQ(draft(context12).value, first.value + 7);
}

}  // namespace
}  // namespace ostraka::upkeep
