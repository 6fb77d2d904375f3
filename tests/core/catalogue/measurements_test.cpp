#include <gmock/gmock.h>

#include "small_project.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

class Measurements : public SmallProject {
 protected:
  Measurements() : sherd(numbered(context12)) {}
  void program(double value, const std::string& model) {
    EXPECT_TRUE(catalogue().measure({sherd, "length", {}, value, {}, "program", {}, model}, {}));
  }
  int rows() {
    int count = 0;
    store::Statement all = catalogue().database().sql("SELECT count(*) FROM measurement");
    if (all.next()) all >> count;
    return count;
  }
  store::SherdRow sherd;
};

TEST_F(Measurements, ANewValueIsANewRowAndCounts) {
  program(61.42, "m1");
  program(61.5, "m2");
  EXPECT_EQ(valueOf(sherd, "length_mm"), "61.5");
  EXPECT_EQ(rows(), 2);
  const std::vector<records::Measurement> now = *catalogue().measurements(sherd);
  ASSERT_EQ(now.size(), 1u);
  EXPECT_EQ(now[0].unit, "mm");
  EXPECT_EQ(now[0].model_sha256, "m2");
}

TEST_F(Measurements, TheSameAgainIsNoNewRow) {
  program(61.42, "m1");
  program(61.42, "m1");
  EXPECT_EQ(rows(), 1);
}

TEST_F(Measurements, APersonsStaysAboveTheProgramsUntilItIsTakenAway) {
  program(61.42, "m1");
  ASSERT_TRUE(set(sherd, "length_mm", "62"));
  program(61.44, "m2");
  program(61.44, "m2");
  EXPECT_EQ(valueOf(sherd, "length_mm"), "62");
  EXPECT_EQ(catalogue().measurements(sherd)->front().method, "calliper");
  EXPECT_EQ(catalogue().measurements(sherd)->front().by, anna.person);
  EXPECT_EQ(rows(), 3) << "the program's is kept all the same, once";
}

TEST_F(Measurements, UndoingAPersonsBringsTheProgramsBackWithItsMethod) {
  program(61.42, "m1");
  const Result<std::vector<records::FieldChange>> undo = set(sherd, "length_mm", "62");
  ASSERT_TRUE(undo);
  ASSERT_TRUE(catalogue().change(*undo, anna));
  const records::Measurement now = catalogue().measurements(sherd)->front();
  EXPECT_EQ(now.value, 61.42);
  EXPECT_EQ(now.method, "program");
  EXPECT_EQ(now.model_sha256, "m1");
  EXPECT_FALSE(now.by);
}

TEST_F(Measurements, OfAPersonWithoutANameStayAboveTheProgramsToo) {
  program(61.42, "m1");
  const records::FieldChange typed{sherd, "length_mm", "62", records::Confirmation::Given};
  ASSERT_TRUE(catalogue().change(std::span(&typed, 1), {}));
  program(61.44, "m2");
  EXPECT_EQ(valueOf(sherd, "length_mm"), "62");
  const std::vector<records::Measurement> by_hand =
      *catalogue().measuredByHand(std::span(&sherd, 1));
  ASSERT_EQ(by_hand.size(), 1u);
  EXPECT_EQ(by_hand[0].value, 62);
}

TEST_F(Measurements, UndoingAPersonsBringsWhatTheProgramSaysOfTheModelThatIsThereNow) {
  program(60.2, "m1");
  const Result<std::vector<records::FieldChange>> undo = set(sherd, "length_mm", "62");
  ASSERT_TRUE(undo);
  program(60.9, "m2");
  ASSERT_TRUE(catalogue().change(*undo, anna));
  const records::Measurement now = catalogue().measurements(sherd)->front();
  EXPECT_EQ(now.value, 60.9);
  EXPECT_EQ(now.model_sha256, "m2");
}

TEST_F(Measurements, ThatEqualAnEarlierModelsAreThePersonsAllTheSame) {
  program(60.2, "m1");
  program(60.9, "m2");
  ASSERT_TRUE(set(sherd, "length_mm", "60.2"));
  const records::Measurement now = catalogue().measurements(sherd)->front();
  EXPECT_EQ(now.value, 60.2);
  EXPECT_EQ(now.method, "calliper");
  EXPECT_EQ(now.by, anna.person);
}

TEST_F(Measurements, AWeightIsTypedAndTakenAway) {
  ASSERT_TRUE(set(sherd, "weight_g", "23,4"));
  EXPECT_EQ(catalogue().measurements(sherd)->front().method, "scale");
  ASSERT_TRUE(set(sherd, "weight_g", ""));
  EXPECT_EQ(valueOf(sherd, "weight_g"), "");
  EXPECT_TRUE(catalogue().measurements(sherd)->empty());
}

TEST_F(Measurements, OfAnUnknownKindOrBelowZeroAreRefused) {
  EXPECT_FALSE(catalogue().measure({sherd, "beauty", {}, 1, {}, "program", {}, ""}, {}));
  EXPECT_FALSE(catalogue().measure({sherd, "length", {}, -1, {}, "program", {}, ""}, {}));
}

}  // namespace
}  // namespace ostraka::catalogue
