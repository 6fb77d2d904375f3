#include "pipeline/preflight.h"

#include <gmock/gmock.h>

namespace ostraka::pipeline {
namespace {

using testing::HasSubstr;

batch::Batch batchOf(int width, int height, int stops = 8) {
  batch::Batch batch;
  batch.plate = batch::Plate{};
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
    for (int camera = 0; camera < 3; ++camera)
      for (int stop = 0; stop < stops; ++stop)
        batch.shots.push_back({side, camera, stop, "a.jpg", {}, width, height});
  return batch;
}

ProcessOptions onThreads(int threads) {
  ProcessOptions options;
  options.threads = threads;
  return options;
}

TEST(Preflight, SaysWhatThereIsAndWhatItWillTake) {
  const Result<Preflight> ahead = preflight(batchOf(2592, 1944), {}, 8000);
  ASSERT_TRUE(ahead.has_value()) << ahead.error().sentence();
  EXPECT_NEAR(ahead->megapixels, 5.0, 0.05);
  // Measured: 4.03 GB with 5 megapixels, 1.59 with 1.92 (docs/experiments.md); a tenth is near.
  EXPECT_NEAR(ahead->memory_mb, 4030, 400);
  EXPECT_NEAR(preflight(batchOf(1600, 1200), {}, 0)->memory_mb, 1590, 160);
  ASSERT_EQ(ahead->lines.size(), 3u);
  EXPECT_THAT(ahead->lines[0],
              HasSubstr("24 of the front, 24 of the back, from 3 cameras at 8 positions; "));
  EXPECT_THAT(ahead->lines[1], HasSubstr("from the plate's markers alone"));
  EXPECT_THAT(ahead->lines[2], HasSubstr("8.0 GB are free; time: about 19 minutes of one core"));
  EXPECT_TRUE(ahead->warnings.empty());
}

TEST(Preflight, CountsCamerasAndPositionsOnlyWhereTheCamerasStand) {
  EXPECT_THAT(preflight(batchOf(2592, 1944, 1), {}, 0)->lines[0],
              HasSubstr("3 of the front, 3 of the back, from 3 cameras at 1 position; "));
  batch::Batch by_hand = batchOf(2592, 1944, 1);
  by_hand.way = batch::Way::FreeCamera;
  EXPECT_THAT(preflight(by_hand, {}, 0)->lines[0],
              HasSubstr("3 of the front, 3 of the back, taken by hand; "));
}

TEST(Preflight, NamesTheFileThatDescribesTheSheetWhereverItLies) {
  batch::Batch batch = batchOf(2592, 1944);
  batch.plate_file = "/above/plate.json";
  EXPECT_THAT(preflight(batch, {}, 0)->lines,
              testing::Contains(HasSubstr("sheet: as in /above/plate.json")));
}

TEST(Preflight, LargePhotographsAreReducedAndTakeLittleMore) {
  const auto small = preflight(batchOf(2592, 1944), onThreads(4), 0);
  const auto large = preflight(batchOf(6000, 4000), onThreads(4), 0);
  ASSERT_TRUE(small && large);
  EXPECT_DOUBLE_EQ(large->megapixels, 5);
  EXPECT_NEAR(large->memory_mb, small->memory_mb, 50);
  EXPECT_THAT(large->lines[0], HasSubstr("24.0 megapixels, used with 5.0"));
  EXPECT_TRUE(large->warnings.empty()) << "free memory is not known";
}

// 200 megapixels: 2 GB for each that is decoded at one time.
TEST(Preflight, TheOriginalsThatAreDecodedAtOneTimeCount) {
  const batch::Batch batch = batchOf(16320, 12240, 1);  // three a side: pictures take 0.5 GB
  EXPECT_NEAR(preflight(batch, onThreads(1), 0)->memory_mb, 2080, 20);
  EXPECT_NEAR(preflight(batch, onThreads(4), 0)->memory_mb, 8070, 20);
  const auto bounded = preflight(batch, onThreads(16), 9000);
  EXPECT_NEAR(bounded->memory_mb, 4080, 20) << "two of them fit into half of 9 GB";
  EXPECT_TRUE(bounded->warnings.empty());
  const auto scarce = preflight(batch, onThreads(16), 1500);
  ASSERT_EQ(scarce->warnings.size(), 1u);
  EXPECT_THAT(scarce->warnings[0], HasSubstr("This needs about 2.1 GB of memory, but only 1.5 GB"));
}

// Measured: 943 s for 40 photographs of 5 megapixels (tests/bench/RESULTS.md).
TEST(Preflight, TimeGrowsWithPhotographsAndTheirPixels) {
  EXPECT_NEAR(needsOf(batchOf(2592, 1944), {}, 0).core_s, 943 * 48 / 40, 20);
  EXPECT_NEAR(needsOf(batchOf(1600, 1200), {}, 0).core_s, 943 * 48 / 40 * 1.92 / 5, 10);
}

TEST(Preflight, TheLargerSidesPhotographsDecideOnTheMasks) {
  batch::Batch twice = batchOf(2592, 1944, 16);
  EXPECT_NEAR(maskMegapixels({}, twice), 2.54, 0.01);
  std::erase_if(twice.shots,
                [](const batch::Shot& s) { return s.side == batch::Side::Back && s.stop > 0; });
  EXPECT_NEAR(maskMegapixels({}, twice), 2.54, 0.01) << "sides come one by one";
}

TEST(Preflight, TooLittleMemoryIsSaidBeforeTheStartAndADraftTakesLess) {
  const auto ahead = preflight(batchOf(2592, 1944), {}, 1200);
  ASSERT_TRUE(ahead.has_value());
  ASSERT_EQ(ahead->warnings.size(), 1u);
  EXPECT_THAT(ahead->warnings[0], HasSubstr("1.2 GB are free"));
  ProcessOptions draft;
  draft.megapixels = kDraftMegapixels;
  EXPECT_TRUE(preflight(batchOf(2592, 1944), draft, 1200)->warnings.empty());
}

TEST(Preflight, ManyPhotographsTakeNoMoreMemoryThanGiven) {
  EXPECT_DOUBLE_EQ(maskMegapixels({}, {}), 5);
  EXPECT_DOUBLE_EQ(maskMegapixels({}, batchOf(4000, 3000)), 5);
  EXPECT_NEAR(maskMegapixels({}, batchOf(4000, 3000, 10)), 4.07, 0.01);
  EXPECT_DOUBLE_EQ(maskMegapixels({}, batchOf(4000, 3000, 134)), 1);
  const batch::Batch batch = batchOf(4000, 3000, 16);  // 48 a side
  ProcessOptions all = onThreads(2);
  all.megapixels = 12;
  EXPECT_EQ(preflight(batch, {}, 0)->megapixels, 5);
  EXPECT_EQ(preflight(batch, all, 0)->megapixels, 12);
  EXPECT_NEAR(preflight(batch, all, 0)->memory_mb, 4096, 300);
  all.memory_gb = 8;
  EXPECT_NEAR(preflight(batch, all, 0)->memory_mb, 8192, 600);
  EXPECT_DOUBLE_EQ(maskMegapixels(all, batch), 5);
  EXPECT_GT(stereoMemory_mb(all, batch, 0), stereoMemory_mb(all, batch, 2));
  all.batch = "batch";
  all.output = "results";
  EXPECT_TRUE(all.check());
  all.memory_gb = 0.1;
  const Result<void> little = all.check();
  ASSERT_FALSE(little);
  EXPECT_THAT(little.error().what, HasSubstr("at least 1 GB"));
}

TEST(Preflight, WhatCannotBeMaskedIsToldBeforeItsCamerasAreSought) {
  batch::Batch bare = batchOf(800, 600);
  bare.plate.reset();
  const auto ahead = preflight(bare, {}, 0);
  ASSERT_FALSE(ahead.has_value());
  EXPECT_EQ(ahead.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(ahead.error().what, HasSubstr("plate.json"));
}

TEST(Preflight, TellsHowLongItWillTakeToWhoWantsToHearIt) {
  ProcessOptions options;
  double told_s = 0;
  options.estimated = [&told_s](double core_s) { told_s = core_s; };
  const auto ahead = preflight(batchOf(800, 600), options, 0);
  ASSERT_TRUE(ahead.has_value());
  EXPECT_GT(told_s, 0);
  EXPECT_EQ(told_s, ahead->core_s);
}

TEST(Preflight, AProgramThatALaterStageWouldMissIsNamedAtOnce) {
  ASSERT_EQ(::setenv("PATH", "/nowhere", 1), 0);
  ProcessOptions options;
  options.dense = DenseMethod::OpenMvs;
  const auto openmvs = preflight(batchOf(800, 600), options, 0);
  ASSERT_FALSE(openmvs.has_value());
  EXPECT_EQ(openmvs.error().code, ErrorCode::Missing);
  EXPECT_THAT(openmvs.error().what, HasSubstr("InterfaceCOLMAP"));
  batch::Batch without_plate = batchOf(800, 600);
  without_plate.plate.reset();
  without_plate.shots.front().mask_file = "a.png";
  const auto colmap = preflight(without_plate, {}, 0);
  ASSERT_FALSE(colmap.has_value());
  EXPECT_THAT(colmap.error().what, HasSubstr("colmap"));
  EXPECT_TRUE(preflight(batchOf(800, 600), {}, 0).has_value()) << "the built-in needs nothing";
}

}  // namespace
}  // namespace ostraka::pipeline
