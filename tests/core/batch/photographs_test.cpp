#include "batch/photographs.h"

#include <gmock/gmock.h>

#include <opencv2/imgproc.hpp>

#include "batch_folder.h"
#include "files/files.h"

namespace ostraka::batch {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kSheet =
    R"({"dictionary":"DICT_4X4_50","sheet":[297,210],"markers":[{"id":0,"corners":)"
    R"([[0,20,0],[20,20,0],[20,0,0],[0,0,0]]}]})";

void series(const BatchFolder& folder, const std::string& side, int from, int count) {
  for (int i = from; i < from + count; ++i)
    folder.image(side + "/IMG_" + std::to_string(i) + ".jpg", 800, 600);
}

std::vector<std::string> namesOf(const Batch& batch) {
  std::vector<std::string> names;
  for (const Shot& shot : batch.shots) names.push_back(shot.file.filename().string());
  return names;
}

Result<Batch> readPlain(const BatchFolder& folder, Listener& listener,
                        const ReadBatchOptions& options = {}) {
  return readPhotographs(folder.path() / "front", folder.path() / "back", {}, options, listener);
}

TEST(NaturalOrder, CountsNumbersByTheirValueAndCapitalsAsSmallLetters) {
  EXPECT_TRUE(inNaturalOrder("IMG_2.jpg", "IMG_10.jpg"));
  EXPECT_FALSE(inNaturalOrder("IMG_10.jpg", "img_2.jpg"));
  EXPECT_TRUE(inNaturalOrder("IMG_0009.JPG", "img_10.jpg"));
  EXPECT_TRUE(inNaturalOrder("a", "a1"));
  EXPECT_TRUE(inNaturalOrder("a1b2", "a1b10"));
  EXPECT_FALSE(inNaturalOrder("a1", "a1"));
  // Of equal value: one comes before the other, whichever way they are asked.
  EXPECT_NE(inNaturalOrder("a01", "a1"), inNaturalOrder("a1", "a01"));
  // A number longer than any integer.
  EXPECT_TRUE(inNaturalOrder("9" + std::string(40, '0'), "10" + std::string(40, '0')));
}

TEST(ReadBatch, TakesPhotographsUnderAnyNamesAsFreeCamerasInNaturalOrder) {
  const BatchFolder folder;
  for (const char* name : {"IMG_10.jpg", "IMG_2.jpg", "IMG_1.JPG"})
    folder.image(std::string("front/") + name, 800, 600);
  folder.image("front/IMG_3.jpg", 600, 800);
  series(folder, "back", 1, 3);
  folder.write("plate.json", kSheet);
  Listener listener;
  const auto batch = readBatch(folder.path(), {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->way, Way::FreeCamera);
  EXPECT_THAT(namesOf(*batch), ElementsAre("IMG_1.JPG", "IMG_2.jpg", "IMG_3.jpg", "IMG_10.jpg",
                                           "IMG_1.jpg", "IMG_2.jpg", "IMG_3.jpg"));
  EXPECT_EQ(batch->shots[2].camera, 2);
  EXPECT_EQ(batch->shots[2].stop, 0);
  EXPECT_EQ(batch->shots[2].height, 800);
  EXPECT_EQ(batch->shots[4].camera, 0);
  EXPECT_EQ(batch->shots[4].side, Side::Back);
  ASSERT_TRUE(batch->plate && batch->plate->sheet);
  EXPECT_EQ(batch->plate_file.filename(), "plate.json");
  EXPECT_THAT(listener.warnings, IsEmpty());
}

TEST(ReadBatch, LetsMostNamesDecideAndNamesTheOthers) {
  const BatchFolder folder;
  series(folder, "front", 1, 4);
  folder.image("front/cam0_pos00.jpg", 800, 600);
  series(folder, "back", 1, 3);
  Listener listener;
  const auto batch = readBatch(folder.path(), {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->way, Way::FreeCamera);
  EXPECT_EQ(batch->shots.size(), 7U);
  EXPECT_THAT(listener.warnings, ElementsAre(HasSubstr("cam0_pos00.jpg: This file name follows ")));
}

TEST(ReadBatch, TakesAFrontAloneOfFreeCamerasAndNoOtherSideAlone) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  Listener listener;
  const auto batch = readBatch(folder.path(), {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->shots.size(), 3U);
  std::filesystem::rename(folder.path() / "front", folder.path() / "back");
  EXPECT_THAT(readBatch(folder.path(), {}, listener).error().sentence(),
              HasSubstr("front side is missing"));
}

TEST(ReadBatch, TakesMasksOfFreeCamerasByTheStemsOfTheirPhotographs) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  folder.image("front_masks/img_2.png", 800, 600);
  folder.image("front_masks/IMG_3.png", 60, 40);
  Listener listener;
  const auto batch = readBatch(folder.path(), {}, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->shots[0].mask_file, "");
  EXPECT_EQ(batch->shots[1].mask_file.filename(), "img_2.png");
  EXPECT_EQ(batch->shots[2].mask_file, "");
  EXPECT_THAT(listener.warnings,
              ElementsAre(HasSubstr("IMG_3.png: The mask and its photograph differ")));
}

TEST(ReadPhotographs, JoinsTwoFoldersToABatchWithTheSheetAboveBoth) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  series(folder, "back", 1, 4);
  folder.write("plate.json", kSheet);
  Listener listener;
  const auto batch = readPlain(folder, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->way, Way::FreeCamera);
  EXPECT_EQ(batch->folder, folder.path());
  EXPECT_EQ(batch->shots.size(), 7U);
  ASSERT_TRUE(batch->plate && batch->plate->sheet);
}

TEST(ReadPhotographs, TakesTheNamedSheetBeforeTheOneThatLiesBeside) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  folder.write("front/plate.json", "not even JSON");
  folder.write("elsewhere/markers.json", kSheet);
  Listener listener;
  const auto batch = readPhotographs(folder.path() / "front/", {},
                                     folder.path() / "elsewhere/markers.json", {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->folder, folder.path() / "front");
  EXPECT_EQ(batch->plate_file, folder.path() / "elsewhere/markers.json");
  EXPECT_THAT(readPhotographs(folder.path() / "front", {}, {}, {}, listener).error().sentence(),
              HasSubstr("plate.json"));
  EXPECT_THAT(
      readPhotographs(folder.path() / "front", {}, folder.path() / "none.json", {}, listener)
          .error()
          .sentence(),
      HasSubstr("none.json: There is no such file"));
}

TEST(ReadPhotographs, ReadsABatchFolderAsOne) {
  const BatchFolder folder;
  for (const char* side : {"front", "back"})
    for (int stop = 0; stop < 3; ++stop)
      folder.image(std::string(side) + "/cam0_pos0" + std::to_string(stop) + ".jpg");
  folder.write("sheet.json", kSheet);
  Listener listener;
  const auto batch = readPhotographs(folder.path(), {}, folder.path() / "sheet.json", {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->way, Way::Rig);
  EXPECT_EQ(batch->shots.size(), 6U);
  EXPECT_TRUE(batch->plate.has_value());
}

TEST(ReadPhotographs, FindsMasksBesideOneFolderOfPhotographs) {
  const BatchFolder folder;
  series(folder, "photographs", 1, 3);
  series(folder, "masks", 1, 2);
  Listener listener;
  const auto batch = readPhotographs(folder.path() / "photographs", {}, {}, {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->shots[1].mask_file, folder.path() / "masks/IMG_2.jpg");
  EXPECT_EQ(batch->shots[2].mask_file, "");
}

TEST(ReadPhotographs, RefusesFoldersWithoutPhotographsByName) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  folder.write("back/Thumbs.db", "x");
  std::filesystem::create_directories(folder.path() / "back/IMG_1.jpg.folder");
  Listener listener;
  EXPECT_THAT(readPlain(folder, listener).error().sentence(),
              AllOf(HasSubstr("back: This folder contains no photographs")));
  EXPECT_THAT(readPhotographs(folder.path() / "back", {}, {}, {}, listener).error().sentence(),
              HasSubstr("neither photographs nor the folders 'front' and 'back'"));
  EXPECT_THAT(readPhotographs(folder.path() / "front", folder.path() / "away", {}, {}, listener)
                  .error()
                  .sentence(),
              HasSubstr("away: There is no such folder"));
  EXPECT_THAT(
      readPhotographs(folder.path() / "front", folder.path() / "back/../front", {}, {}, listener)
          .error()
          .sentence(),
      HasSubstr("given for the front and the back"));
}

TEST(ReadPhotographs, LeavesOutWhatIsNoPictureAndLinksThatLeadNowhere) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  folder.write("front/IMG_4.jpg", "GIF89a");
  folder.write("front/a\nline\x1b[31m\xff.jpg", "");
  folder.image("front/.IMG_5.jpg", 800, 600);
  std::filesystem::create_directories(folder.path() / "front/IMG_6.jpg");
  std::filesystem::create_symlink("nowhere", folder.path() / "front/IMG_7.jpg");
  std::filesystem::create_symlink("IMG_8.jpg", folder.path() / "front/IMG_8.jpg");
  std::filesystem::create_symlink("IMG_1.jpg", folder.path() / "front/IMG_9.jpg");
  Listener listener;
  const auto batch = readPhotographs(folder.path() / "front", {}, {}, {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_THAT(namesOf(*batch), ElementsAre("IMG_1.jpg", "IMG_2.jpg", "IMG_3.jpg", "IMG_9.jpg"));
  EXPECT_EQ(listener.warnings.size(), 5U);
  for (const std::string& warning : listener.warnings)
    EXPECT_THAT(warning, HasSubstr("This photograph is left out."));
}

TEST(ReadPhotographs, TakesOneOfTwoFormatsOfAPhotograph) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  folder.image("front/img_2.png", 800, 600);
  Listener listener;
  const auto batch = readPhotographs(folder.path() / "front", {}, {}, {}, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->shots.size(), 3U);
  EXPECT_THAT(listener.warnings, ElementsAre(HasSubstr("Another photograph has the same name")));
}

TEST(ReadPhotographs, TakesTheDevelopedPictureBesideARawFile) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  folder.write("front/img_2.CR2", "never opened");
  folder.write("front/IMG_4.NEF", "RAW alone, and damaged");
  Listener listener;
  const auto batch = readPhotographs(folder.path() / "front", {}, {}, {}, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_THAT(namesOf(*batch), ElementsAre("IMG_1.jpg", "IMG_2.jpg", "IMG_3.jpg"));
  EXPECT_THAT(listener.warnings, ElementsAre(HasSubstr("IMG_4.NEF: The RAW image is damaged")));
}

TEST(ReadPhotographs, LeavesOutThumbnailsWithOneSentence) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  for (int i = 4; i < 10; ++i) folder.image("front/IMG_" + std::to_string(i) + ".jpg", 640, 480);
  Listener listener;
  const auto batch = readPhotographs(folder.path() / "front", {}, {}, {}, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->shots.size(), 3U);
  EXPECT_THAT(listener.warnings,
              ElementsAre(HasSubstr("less than 0.35 megapixels are left out (IMG_4.jpg, IMG_5.jpg, "
                                    "IMG_6.jpg and 3 more)")));
}

TEST(ReadPhotographs, NeedsThreePhotographsOfEachSideThatIsThere) {
  const BatchFolder folder;
  series(folder, "front", 1, 3);
  series(folder, "back", 1, 2);
  Listener listener;
  const auto batch = readPlain(folder, listener);
  ASSERT_FALSE(batch.has_value());
  EXPECT_EQ(batch.error().code, ErrorCode::NotEnough);
  EXPECT_THAT(batch.error().sentence(), HasSubstr("Usable photographs of the back side: 2"));
  folder.write("back/IMG_7.jpg", "no image");
  folder.image("back/IMG_8.jpg", 64, 48);
  folder.image("back/cam0_pos00.jpg");
  const std::string words = readPlain(folder, listener).error().what.english();
  EXPECT_THAT(words, HasSubstr("side: 2; at least 3 are needed. Photographs left out: 3; the "
                               "first: "));
}

// Every third photograph is sharp, the others are blurred: of the neighbourhoods of three, the
// compressed size finds the sharp one.
TEST(ReadPhotographs, ThinsALongSeriesToTheSharpestOfItsNeighbours) {
  const BatchFolder folder;
  cv::Mat sharp(600, 800, CV_8UC3), blurred;
  cv::theRNG().state = 7;
  cv::randu(sharp, 0, 255);
  cv::GaussianBlur(sharp, sharp, {}, 1);
  cv::GaussianBlur(sharp, blurred, {}, 2);
  std::filesystem::create_directories(folder.path() / "front");
  std::vector<std::string> expected;
  for (int i = 0; i < 15; ++i) {
    const std::string name = "IMG_" + std::to_string(i) + ".jpg";
    cv::imwrite((folder.path() / "front" / name).string(), i % 3 == 1 ? sharp : blurred);
    if (i % 3 == 1) expected.push_back(name);
  }
  Listener listener;
  ReadBatchOptions options;
  options.max_free_views = 5;
  const auto batch = readPhotographs(folder.path() / "front", {}, {}, options, listener);
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(namesOf(*batch), expected);
  EXPECT_EQ(batch->shots[4].camera, 4);
  EXPECT_THAT(listener.warnings, ElementsAre(HasSubstr("5 of the 15 photographs are used")));
}

}  // namespace
}  // namespace ostraka::batch
