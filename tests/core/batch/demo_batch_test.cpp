#include <gtest/gtest.h>

#include "batch/batch.h"
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

}  // namespace
}  // namespace ostraka::batch
