#include <gtest/gtest.h>

#include "batch/photographs.h"
#include "batch_folder.h"

namespace ostraka::batch {
namespace {

TEST(ReadBatch, ReadsTheDemoBatchWhole) {
  Listener listener;
  const auto batch = readBatch(OSTRAKA_SHARED_DIR "/batches/demo", {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->shots.size(), 48U);
  EXPECT_EQ(batch->calibration.size(), 36U);
  EXPECT_EQ(batch->empty_plates.size(), 3U);
  ASSERT_TRUE(batch->plate && batch->board);
  EXPECT_EQ(batch->plate->markers.size(), 24U);
  EXPECT_EQ(batch->board->squares_x, 9);
  EXPECT_TRUE(listener.warnings.empty());
}

TEST(ReadPhotographs, ReadsBothSidesOfATelephonesPhotographsOverASheet) {
  const std::filesystem::path hand = OSTRAKA_SHARED_DIR "/batches/hand";
  Listener listener;
  const auto batch = readPhotographs(hand / "front", hand / "back", {}, {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->way, Way::FreeCamera);
  EXPECT_EQ(batch->folder, hand.lexically_normal());
  EXPECT_EQ(batch->shots.size(), 40U);
  EXPECT_EQ(batch->shots[20].file.filename(), "IMG_2437.jpg");
  ASSERT_TRUE(batch->plate && batch->plate->sheet);
  EXPECT_EQ(batch->plate->sheet->sizes().x(), 297);
  EXPECT_TRUE(listener.warnings.empty());
  const auto folder = readBatch(hand, {}, listener);
  ASSERT_TRUE(folder.has_value());
  EXPECT_EQ(folder->shots.size(), 40U);
}

TEST(ReadPhotographs, ReadsOneSideWithASheetOfAnothersMakingAndItsMasks) {
  const std::filesystem::path apple = OSTRAKA_SHARED_DIR "/real/apple";
  Listener listener;
  const auto batch =
      readPhotographs(apple / "photographs", {}, apple / "markers.json", {}, listener);
  ASSERT_TRUE(batch.has_value()) << batch.error().sentence();
  EXPECT_EQ(batch->shots.size(), 42U);
  for (const Shot& shot : batch->shots) EXPECT_FALSE(shot.mask_file.empty()) << shot.file;
  ASSERT_TRUE(batch->plate && batch->plate->sheet);
  EXPECT_EQ(batch->plate->markers.size(), 35U);
}

}  // namespace
}  // namespace ostraka::batch
