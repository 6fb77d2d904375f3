#include "batch/batch.h"

#include <gmock/gmock.h>

#include "batch_folder.h"

namespace ostraka::batch {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void threeViewsPerSide(const BatchFolder& folder) {
  for (const char* side : {"front", "back"})
    for (int stop = 0; stop < 3; ++stop)
      folder.image(std::string(side) + "/cam0_pos0" + std::to_string(stop) + ".jpg");
}

Result<Batch> read(const BatchFolder& folder, Listener& listener) {
  return readBatch(folder.path(), {}, listener);
}

TEST(CameraLetter, CountsAsPeopleDo) {
  EXPECT_EQ(cameraLetter(0), "A");
  EXPECT_EQ(cameraLetter(25), "Z");
  EXPECT_EQ(cameraLetter(26), "26");
}

TEST(ReadBatch, SortsShotsBySideCameraAndStop) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  folder.image("front/cam1_pos11.PNG", 20, 10);
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  ASSERT_EQ(batch->shots.size(), 7U);
  EXPECT_EQ(batch->shots[2].stop, 2);
  EXPECT_EQ(batch->shots[3].camera, 1);
  EXPECT_EQ(batch->shots[3].stop, 11);
  EXPECT_EQ(batch->shots[3].width, 20);
  EXPECT_EQ(batch->shots[4].side, Side::Back);
  EXPECT_FALSE(batch->plate.has_value());
  EXPECT_THAT(listener.warnings,
              ElementsAre(HasSubstr("front: Photographs are missing: cam0_pos03, cam0_pos04")));
}

TEST(ReadBatch, TakesTheLettersThatTheCamerasHaveInTheWindow) {
  const BatchFolder folder;
  for (const char* side : {"front", "back"})
    for (const char* name : {"camA_pos00.jpg", "camA_pos01.jpg", "camB_pos00.jpg"})
      folder.image(std::string(side) + "/" + name);
  folder.image("calib/empty_camB.jpg");
  folder.image("front/camAB_pos00.jpg");
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  ASSERT_EQ(batch->shots.size(), 6U);
  EXPECT_EQ(batch->shots[1].camera, 0);
  EXPECT_EQ(batch->shots[1].stop, 1);
  EXPECT_EQ(batch->shots[2].camera, 1);
  EXPECT_THAT(listener.warnings, testing::Contains(HasSubstr("camAB_pos00.jpg")));
}

TEST(ReadBatch, ReadsThePapersLayoutWithCamerasFromOneAndItsMasks) {
  const BatchFolder folder;
  for (const char* side : {"top", "bottom"})
    for (int k = 1; k <= 3; ++k) {
      const std::string stem = "/cam1_image00" + std::to_string(k);
      folder.image(std::string(side) + "_images" + stem + ".tif");
      folder.image(std::string(side) + "_masks" + stem + ".png");
    }
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  ASSERT_EQ(batch->shots.size(), 6U);
  EXPECT_EQ(batch->shots[0].camera, 0);
  EXPECT_EQ(batch->shots[0].stop, 1);
  EXPECT_EQ(batch->shots[0].mask_file.filename(), "cam1_image001.png");
  EXPECT_EQ(batch->shots[0].mask_file.parent_path().filename(), "top_masks");
}

TEST(ReadBatch, NamesItsFilesWithoutDetours) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  Listener listener;
  const auto batch = readBatch(folder.path() / "front" / "..", {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->shots[0].file.string().find(".."), std::string::npos) << batch->shots[0].file;
  EXPECT_EQ(batch->shots[0].file.lexically_proximate(batch->folder).begin()->string(), "front");
}

TEST(ReadBatch, NamesTheMissingSide) {
  const BatchFolder folder;
  folder.image("front/cam0_pos00.jpg");
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_FALSE(batch.has_value());
  EXPECT_EQ(batch.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(batch.error().sentence(), HasSubstr("back"));
}

TEST(ReadBatch, RefusesAFolderThatIsNoBatch) {
  const BatchFolder folder;
  Listener listener;
  EXPECT_THAT(read(folder, listener).error().what, HasSubstr("Not a batch folder"));
  EXPECT_THAT(readBatch(folder.path() / "nowhere", {}, listener).error().what,
              HasSubstr("no such folder"));
}

TEST(ReadBatch, LeavesOutTheCutOffPhotographOnly) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  folder.image("front/cam0_pos03.jpg");
  const std::string whole = folder.read("front/cam0_pos03.jpg");
  folder.write("front/cam0_pos03.jpg", whole.substr(0, whole.size() - 20));
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->shots.size(), 6U);
  EXPECT_THAT(listener.warnings,
              ElementsAre(testing::AllOf(HasSubstr("cam0_pos03.jpg"), HasSubstr("truncated"))));
}

TEST(ReadBatch, LeavesOutThePhotographOfAnotherSize) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  folder.image("back/cam0_pos03.jpg", 12, 16);
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->shots.size(), 6U);
  EXPECT_THAT(listener.warnings, ElementsAre(HasSubstr("12 x 16")));
}

TEST(ReadBatch, NeedsThreeUsableViewsPerSide) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  std::filesystem::remove(folder.path() / "back/cam0_pos01.jpg");
  Listener listener;
  const auto refusal = [&] { return read(folder, listener).error(); };
  EXPECT_EQ(refusal().code, ErrorCode::NotEnough);
  EXPECT_THAT(refusal().what.english(),
              testing::StartsWith("Usable photographs of the back side: 2; at least 3 are needed. "
                                  "Take more"));
  std::filesystem::remove_all(folder.path() / "back");
  std::filesystem::create_directory(folder.path() / "back");
  EXPECT_THAT(refusal().what.english(), HasSubstr("Add photographs named cam<C>_pos<PP>.jpg."));
}

// Who silenced the warnings reads the error alone: it must not ask for names that the files have.
TEST(ReadBatch, SaysHowManyPhotographsOfASideAreLeftOutAndWhyTheFirst) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  for (const char* name : {"front/cam0_pos00.jpg", "front/cam0_pos01.jpg", "front/cam0_pos02.jpg"})
    folder.write(name, "no image");
  folder.image("front/IMG_1234.jpg");
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_FALSE(batch.has_value());
  EXPECT_EQ(batch.error().code, ErrorCode::NotEnough);
  const std::string words = batch.error().what.english();
  EXPECT_THAT(words, HasSubstr("of the front side: 0; at least 3 are needed. Photographs left "
                               "out: 4; the first: "));
  EXPECT_THAT(words, HasSubstr("IMG_1234.jpg: The file name does not match"));
  std::filesystem::remove(folder.path() / "front/IMG_1234.jpg");
  const std::string unreadable = read(folder, listener).error().what.english();
  EXPECT_THAT(unreadable, HasSubstr("left out: 3; the first: "));
  EXPECT_THAT(unreadable, HasSubstr("front/cam0_pos00.jpg: "));
  EXPECT_THAT(unreadable, testing::Not(HasSubstr("named")));
}

TEST(ReadBatch, WarnsOfNamesItDoesNotUnderstandAndOfDoubles) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  folder.image("front/IMG_1234.jpg");
  folder.image("front/cam0_pos00.png");
  folder.write("front/Thumbs.db", "x");
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->shots.size(), 6U);
  EXPECT_THAT(listener.warnings, ElementsAre(HasSubstr("IMG_1234"), HasSubstr("cam0_pos00.png")));
}

TEST(ReadBatch, NamesThePhotographsThatAreMissing) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  for (const char* name : {"cam0_pos04", "cam1_pos00", "cam1_pos01", "cam1_pos02", "cam1_pos04"})
    folder.image(std::string("front/") + name + ".jpg");
  folder.write("front/cam1_pos03.jpg", "not there as a picture, but by name");
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->shots.size(), 11U);
  ASSERT_EQ(listener.warnings.size(), 3U);
  EXPECT_THAT(listener.warnings[0], HasSubstr("cam1_pos03.jpg"));
  EXPECT_THAT(listener.warnings[1], testing::AllOf(HasSubstr("front"), HasSubstr(": cam0_pos03.")));
  EXPECT_THAT(listener.warnings[2],
              testing::AllOf(HasSubstr("back"), HasSubstr("cam1_pos00, cam1_pos01, cam1_pos02")));
}

TEST(ReadBatch, TakesCalibrationAndEmptyPlatesOfItsCamerasOnly) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  folder.image("calib/cam0_cal00.jpg");
  folder.image("calib/cam7_cal00.jpg");
  folder.image("calib/empty_cam0.jpg");
  folder.image("calib/cam0_cal01.jpg", 99, 9);
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->calibration.size(), 1U);
  EXPECT_EQ(batch->empty_plates.size(), 1U);
  EXPECT_THAT(listener.warnings, ElementsAre(HasSubstr("99 x 9")));
}

TEST(ReadBatch, StopsAtABrokenPlateFile) {
  const BatchFolder folder;
  threeViewsPerSide(folder);
  folder.write("plate.json", "{\"dictionary\":");
  Listener listener;
  const auto batch = read(folder, listener);
  ASSERT_FALSE(batch.has_value());
  EXPECT_THAT(batch.error().sentence(), HasSubstr("plate.json"));
}

TEST(ThreadsForOriginals, TakeHalfOfWhatIsFreeAndAreNeverNone) {
  Batch batch;
  batch.shots.push_back({Side::Front, 0, 0, "a.jpg", {}, 10'000, 10'000});  // 1 GB
  batch.shots.push_back({Side::Front, 0, 1, "b.jpg", {}, 100, 100});
  EXPECT_EQ(threadsForOriginals(batch, 16, 8000), 4);
  EXPECT_EQ(threadsForOriginals(batch, 3, 8000), 3);
  EXPECT_EQ(threadsForOriginals(batch, 16, 100), 1);
  EXPECT_EQ(threadsForOriginals(batch, 16, 0), 16) << "free memory is not known";
  EXPECT_GE(threadsForOriginals(batch, 0, 0), 1);
  EXPECT_EQ(threadsForOriginals(Batch{}, 16, 8000), 16);
}

}  // namespace
}  // namespace ostraka::batch
