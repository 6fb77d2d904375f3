#include <gmock/gmock.h>

#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/sherd_changes.h"
#include "store/database.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::sherds {
namespace {

class MeasurementsTest : public catalogue::SmallProject {
 protected:
  MeasurementsTest() : sherd(numbered(context12)) {}
  void program(double value, const std::string& model) {
    EXPECT_TRUE(
        Measurements(catalogue()).add({sherd, "length", {}, value, {}, "program", {}, model}, {}));
  }
  int rows() {
    int count = 0;
    store::Statement all = catalogue().database().sql("SELECT count(*) FROM measurement");
    all.read(count);
    return count;
  }
  store::SherdRow sherd;
};

TEST_F(MeasurementsTest, ANewValueIsANewRowAndCounts) {
  program(61.42, "m1");
  program(61.5, "m2");
  EXPECT_EQ(valueOf(sherd, "length_mm"), "61.5");
  EXPECT_EQ(rows(), 2);
  const std::vector<records::Measurement> now = *Measurements(catalogue()).of(sherd);
  ASSERT_EQ(now.size(), 1u);
  EXPECT_EQ(now[0].unit, "mm");
  EXPECT_EQ(now[0].model_sha256, "m2");
}

TEST_F(MeasurementsTest, TheSameAgainIsNoNewRow) {
  program(61.42, "m1");
  program(61.42, "m1");
  EXPECT_EQ(rows(), 1);
}

TEST_F(MeasurementsTest, APersonsStaysAboveTheProgramsUntilItIsTakenAway) {
  program(61.42, "m1");
  ASSERT_TRUE(set(sherd, "length_mm", "62"));
  program(61.44, "m2");
  program(61.44, "m2");
  EXPECT_EQ(valueOf(sherd, "length_mm"), "62");
  EXPECT_EQ(Measurements(catalogue()).of(sherd)->front().method, "calliper");
  EXPECT_EQ(Measurements(catalogue()).of(sherd)->front().by, anna.person);
  EXPECT_EQ(rows(), 3) << "the program's is kept all the same, once";
}

TEST_F(MeasurementsTest, UndoingAPersonsBringsTheProgramsBackWithItsMethod) {
  program(61.42, "m1");
  const Result<std::vector<records::FieldChange>> undo = set(sherd, "length_mm", "62");
  ASSERT_TRUE(undo);
  ASSERT_TRUE(SherdChanges(catalogue()).apply(*undo, anna));
  const records::Measurement now = Measurements(catalogue()).of(sherd)->front();
  EXPECT_EQ(now.value, 61.42);
  EXPECT_EQ(now.method, "program");
  EXPECT_EQ(now.model_sha256, "m1");
  EXPECT_FALSE(now.by);
}

TEST_F(MeasurementsTest, OfAPersonWithoutANameStayAboveTheProgramsToo) {
  program(61.42, "m1");
  const records::FieldChange typed{sherd, "length_mm", "62", records::Confirmation::Given};
  ASSERT_TRUE(SherdChanges(catalogue()).apply(std::span(&typed, 1), {}));
  program(61.44, "m2");
  EXPECT_EQ(valueOf(sherd, "length_mm"), "62");
  const std::vector<records::Measurement> by_hand =
      *Measurements(catalogue()).byHand(std::span(&sherd, 1));
  ASSERT_EQ(by_hand.size(), 1u);
  EXPECT_EQ(by_hand[0].value, 62);
}

TEST_F(MeasurementsTest, UndoingAPersonsBringsWhatTheProgramSaysOfTheModelThatIsThereNow) {
  program(60.2, "m1");
  const Result<std::vector<records::FieldChange>> undo = set(sherd, "length_mm", "62");
  ASSERT_TRUE(undo);
  program(60.9, "m2");
  ASSERT_TRUE(SherdChanges(catalogue()).apply(*undo, anna));
  const records::Measurement now = Measurements(catalogue()).of(sherd)->front();
  EXPECT_EQ(now.value, 60.9);
  EXPECT_EQ(now.model_sha256, "m2");
}

TEST_F(MeasurementsTest, ThatEqualAnEarlierModelsAreThePersonsAllTheSame) {
  program(60.2, "m1");
  program(60.9, "m2");
  ASSERT_TRUE(set(sherd, "length_mm", "60.2"));
  const records::Measurement now = Measurements(catalogue()).of(sherd)->front();
  EXPECT_EQ(now.value, 60.2);
  EXPECT_EQ(now.method, "calliper");
  EXPECT_EQ(now.by, anna.person);
}

TEST_F(MeasurementsTest, AWeightIsTypedAndTakenAway) {
  ASSERT_TRUE(set(sherd, "weight_g", "23,4"));
  EXPECT_EQ(Measurements(catalogue()).of(sherd)->front().method, "scale");
  ASSERT_TRUE(set(sherd, "weight_g", ""));
  EXPECT_EQ(valueOf(sherd, "weight_g"), "");
  EXPECT_TRUE(Measurements(catalogue()).of(sherd)->empty());
}

TEST_F(MeasurementsTest, OfAnUnknownKindOrBelowZeroAreRefused) {
  EXPECT_FALSE(Measurements(catalogue()).add({sherd, "beauty", {}, 1, {}, "program", {}, ""}, {}));
  EXPECT_FALSE(Measurements(catalogue()).add({sherd, "length", {}, -1, {}, "program", {}, ""}, {}));
}

}  // namespace
}  // namespace ostraka::sherds
