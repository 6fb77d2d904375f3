#include "batch/copied_photographs.h"

#include <gmock/gmock.h>

#include "batch_folder.h"

namespace ostraka::batch {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class CopiedPhotographs : public testing::Test {
 protected:
  void take(Side side, const std::string& name, const std::string& bytes,
            const std::string& mask = {}) {
    const std::string file = std::string(batch::name(side)) + "/" + name;
    folder.write(file, bytes);
    batch.shots.push_back(
        {side, static_cast<int>(batch.shots.size()), 0, folder.path() / file, mask, 640, 480});
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Shot& shot : batch.shots) all.push_back(shot.file.filename().string());
    return all;
  }
  Result<void> leaveOut() {
    ReadBatchOptions options;
    options.min_views_per_side = 2;
    return leaveOutCopies(batch, options, heard);
  }

  BatchFolder folder;
  Batch batch;
  Listener heard;
};

TEST_F(CopiedPhotographs, OfOneSideAreLeftOutWithAWarningThatNamesBoth) {
  batch.way = Way::FreeCamera;
  take(Side::Front, "IMG_1 Kopie.jpg", "first one");
  take(Side::Front, "IMG_1.jpg", "first one");
  take(Side::Front, "IMG_2.jpg", "other one");  // as long, another picture
  take(Side::Front, "IMG_3.jpg", "a third one");
  ASSERT_TRUE(leaveOut().has_value());
  EXPECT_THAT(names(), ElementsAre("IMG_1.jpg", "IMG_2.jpg", "IMG_3.jpg"));
  ASSERT_EQ(heard.warnings.size(), 1u);
  EXPECT_THAT(heard.warnings[0], HasSubstr("IMG_1 Kopie.jpg: This photograph is identical to "
                                           "IMG_1.jpg; it is left out."));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(batch.shots[static_cast<std::size_t>(i)].camera, i);
}

TEST_F(CopiedPhotographs, KeepTheOneThatHasAMask) {
  take(Side::Front, "a.jpg", "one", {});
  take(Side::Front, "a copy.jpg", "one", "a copy.png");
  take(Side::Front, "b.jpg", "two");
  ASSERT_TRUE(leaveOut().has_value());
  EXPECT_THAT(names(), ElementsAre("a copy.jpg", "b.jpg"));
}

TEST_F(CopiedPhotographs, OfARigKeepTheirPositions) {
  for (const char* name : {"cam0_pos00.jpg", "cam0_pos01.jpg", "cam0_pos02.jpg"})
    take(Side::Front, name, name[9] == '1' ? "cam0_pos00.jpg" : name);
  ASSERT_TRUE(leaveOut().has_value());
  EXPECT_THAT(names(), ElementsAre("cam0_pos00.jpg", "cam0_pos02.jpg"));
  EXPECT_EQ(batch.shots[1].camera, 2);
}

TEST_F(CopiedPhotographs, OfTheOtherSideAreARefusalIfTheyAreMostOfASide) {
  for (const char* name : {"a.jpg", "b.jpg", "c.jpg", "d.jpg"}) take(Side::Front, name, name);
  for (const char* name : {"b.jpg", "c.jpg"}) take(Side::Back, name, name);
  take(Side::Back, "c copy.jpg", "c.jpg");
  take(Side::Back, "own.jpg", "own");
  const Result<void> refused = leaveOut();
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(refused.error().what,
            "2 of the 3 photographs of the back side are identical to photographs of the front "
            "side (such as b.jpg, c.jpg), so the batch cannot be used; give each side its own "
            "photographs.");
  EXPECT_EQ(refused.error().where, (folder.path() / "back").string());
  EXPECT_EQ(batch.shots.size(), 8u) << "the batch stays whole";
}

TEST_F(CopiedPhotographs, AreARefusalWhicheverSideIsTheOther) {
  for (const char* name : {"a.jpg", "b.jpg"}) take(Side::Front, name, name);
  for (const char* name : {"1.jpg", "2.jpg", "3.jpg"}) take(Side::Back, name, name);
  for (const char* name : {"a.jpg", "b.jpg"}) take(Side::Back, name, name);
  const Result<void> refused = leaveOut();
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().what.english(),
              HasSubstr("2 of the 2 photographs of the front side are identical to photographs of "
                        "the back side"));
}

TEST_F(CopiedPhotographs, OfTheOtherSideAreLeftOutOfBothIfTheyAreFew) {
  batch.way = Way::FreeCamera;
  for (const char* name : {"a.jpg", "b.jpg", "c.jpg"}) take(Side::Front, name, name);
  for (const char* name : {"c copy.jpg", "d.jpg", "e.jpg"})
    take(Side::Back, name, name[0] == 'c' ? "c.jpg" : name);
  ASSERT_TRUE(leaveOut().has_value());
  EXPECT_THAT(names(), ElementsAre("a.jpg", "b.jpg", "d.jpg", "e.jpg"));
  EXPECT_THAT(heard.warnings, ElementsAre((folder.path() / "back" / "c copy.jpg").string() +
                                          ": This photograph is identical to " +
                                          (folder.path() / "front" / "c.jpg").string() +
                                          " of the front side; it is left out of both sides."));
  for (const int i : {0, 1}) {
    EXPECT_EQ(batch.shots[static_cast<std::size_t>(i)].camera, i);
    EXPECT_EQ(batch.shots[static_cast<std::size_t>(2 + i)].camera, i);
  }
}

TEST_F(CopiedPhotographs, DoNotMakeASideEnough) {
  for (const char* name : {"a.jpg", "b.jpg", "c.jpg"}) take(Side::Back, name, "the same");
  const Result<void> enough = leaveOut();
  ASSERT_FALSE(enough.has_value());
  EXPECT_EQ(enough.error().code, ErrorCode::NotEnough);
  EXPECT_THAT(enough.error().what, HasSubstr("Usable photographs of the back side: 1"));
}

}  // namespace
}  // namespace ostraka::batch
