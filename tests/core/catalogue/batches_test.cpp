#include "small_project.h"

namespace ostraka::catalogue {
namespace {

using Batches = SmallProject;

TEST_F(Batches, AreNumberedOneAfterTheOther) {
  EXPECT_EQ(*catalogue().nextBatchNumber(), "B0001");
  const store::BatchRow first = newBatch({bag4, bag1});
  EXPECT_EQ(catalogue().batch(first)->number, "B0001");
  EXPECT_EQ(catalogue().batch(first)->bags, (std::vector<store::BagRow>{bag4, bag1}));
  records::BatchRecord far;
  far.number = "B9999";
  ASSERT_TRUE(catalogue().addBatch(far, anna));
  EXPECT_EQ(catalogue().batch(newBatch({}))->number, "B10000");
  records::BatchRecord again;
  again.number = "B0001";
  EXPECT_FALSE(catalogue().addBatch(again, anna));
  again.number = "../B1";
  EXPECT_FALSE(catalogue().addBatch(again, anna));
}

TEST_F(Batches, AStateIsKeptWithWhoAndWhen) {
  const store::BatchRow row = newBatch({bag4});
  ASSERT_TRUE(catalogue().setBatchState(row, records::BatchState::Queued, anna));
  ASSERT_TRUE(catalogue().setBatchState(row, records::BatchState::Queued, anna));
  EXPECT_EQ(catalogue().batchByNumber("B0001")->state, records::BatchState::Queued);
  const std::vector<records::HistoryEntry> history = *catalogue().history("batch", row.value);
  ASSERT_EQ(history.size(), 2u);
  EXPECT_EQ(history[0].old_value, "placed");
  EXPECT_EQ(history[0].new_value, "queued");
  EXPECT_EQ(history[0].by, anna.person);
  EXPECT_EQ(catalogue().batches()->front().row, row);
}

TEST_F(Batches, APlateHoldsSixtySherdsAtMost) {
  records::BatchRecord b;
  b.counted = 61;
  EXPECT_FALSE(catalogue().addBatch(b, anna));
}

TEST_F(Batches, APhotographIsKnownByItsSideCameraStopAndTake) {
  records::PhotographRecord p;
  p.batch = newBatch({bag4});
  p.camera = 'B';
  p.stop = 5;
  p.path = "batches/B0001/front/cam1_pos05.jpg";
  const store::PhotographRow first = *catalogue().save(p, anna);
  p.sharpness = 1.25;
  EXPECT_EQ(*catalogue().save(p, anna), first);
  p.take = 1;
  p.path = "batches/B0001/front/cam1_pos05_1.jpg";
  EXPECT_NE(*catalogue().save(p, anna), first);
  const std::vector<records::PhotographRecord> all = *catalogue().photographs(p.batch);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].camera, 'B');
  EXPECT_EQ(all[0].sharpness, 1.25);
  EXPECT_EQ(catalogue().history("photograph", first.value)->size(), 1u);
  p.path = "/etc/passwd";
  EXPECT_FALSE(catalogue().save(p, anna));
}

TEST_F(Batches, AFileIsKnownByItsPathAndItsChecksumIsRemembered) {
  records::FileRecord f;
  f.path = "results/B0001/report.json";
  f.sha256 = std::string(64, 'a');
  f.bytes = 10;
  f.media_type = "application/json";
  f.role = "report";
  const store::FileRow row = *catalogue().save(f, anna);
  f.sha256 = std::string(64, 'b');
  EXPECT_EQ(*catalogue().save(f, anna), row);
  EXPECT_EQ(catalogue().files()->size(), 1u);
  EXPECT_EQ(catalogue().history("file", row.value)->front().old_value, std::string(64, 'a'));
  f.role = "poem";
  EXPECT_FALSE(catalogue().save(f, anna));
}

}  // namespace
}  // namespace ostraka::catalogue
