#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/sequence.h"
#include "capture/silhouettes.h"
#include "tests/core/capture/flat_rig.h"

namespace ostraka::capture {
namespace {

using testing::flatPicture;
using testing::flatPlate;
using testing::FlatScene;

TEST(CheckSide, TellsBeforeTheFlipThatOneOutlineMayBeTwoSherds) {
  FlatScene scene;
  scene.width = 1280;
  scene.sherds = {{-30, 0, 15}, {-8, 0, 15}, {-20, 60, 15}};  // the neck is 0.68 of a width
  std::vector<std::vector<SidePhotograph>> photographs(1);
  for (const double degrees : {0.0, 120.0, 240.0}) {
    auto inspection = inspectAndMap(flatPicture(scene, 2, degrees, ""), flatPlate(), {});
    ASSERT_TRUE(inspection.has_value());
    photographs[0].push_back(
        {{}, std::make_shared<const MappedInspection>(std::move(*inspection))});
  }
  const SideCheck check = checkSide(photographs, flatPlate(), {}, {});
  EXPECT_EQ(check.sherds, 2);
  EXPECT_EQ(check.doubtful, 1);
  ASSERT_EQ(check.sentences.size(), 1u);
  EXPECT_NE(check.sentences[0].english().find("(-19, 0) mm"), std::string::npos)
      << check.sentences[0];
  EXPECT_FALSE(check.sentences[0].templateWords().empty()) << "nobody can translate it";
}

TEST(CompareSides, FindsALostSherdAndSherdsThatWereNotTurned) {
  SideCheck front;
  front.counted = true;
  front.sherds = 3;
  front.places = {{0, 0, 500}, {50, 0, 600}, {0, 50, 700}};
  SideCheck back = front;
  EXPECT_THAT(compareSides(front, back).at(0), ::testing::HasSubstr("looks like the front"));
  back.places = {{2, 0, 500}, {50, 4, 600}};
  back.sherds = 2;
  EXPECT_THAT(compareSides(front, back).at(0), ::testing::HasSubstr("Find the missing ones"));
  back.places.push_back({0, 56, 700});
  back.sherds = 3;
  EXPECT_TRUE(compareSides(front, back).empty());
}

TEST(CompareSides, TellsSherdsThatWereAddedAndSidesThatWereNotCounted) {
  SideCheck three;
  three.counted = true;
  three.sherds = 3;
  three.places = {{0, 0, 500}, {50, 0, 600}, {0, 50, 700}};
  SideCheck four = three, none;
  four.sherds = 4;
  four.places = {{0, 5, 500}, {50, 9, 600}, {0, 90, 700}, {90, 0, 400}};
  const std::vector<Message> added = compareSides(three, four);
  ASSERT_EQ(added.size(), 1u);
  EXPECT_THAT(added[0], ::testing::HasSubstr("front: 3, on the back: 4. Check whether one was"));
  // No number is known, so nobody is told to look for a sherd.
  EXPECT_THAT(compareSides(three, none).at(0),
              ::testing::HasSubstr("The sherds of the back could not be counted"));
  EXPECT_THAT(compareSides(none, three).at(0),
              ::testing::HasSubstr("The sherds of the front could not be counted"));
}

}  // namespace
}  // namespace ostraka::capture
