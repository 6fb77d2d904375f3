#include <filesystem>

#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/history.h"
#include "records/records.h"
#include "records/sherd.h"
#include "small_project.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

using BatchesTest = SmallProject;

TEST_F(BatchesTest, AreNumberedOneAfterTheOther) {
  EXPECT_EQ(*Batches(catalogue()).nextNumber(), "B0001");
  const store::BatchRow first = newBatch({bag4, bag1});
  EXPECT_EQ(Batches(catalogue()).get(first)->number, "B0001");
  EXPECT_EQ(Batches(catalogue()).get(first)->bags, (std::vector<store::BagRow>{bag4, bag1}));
  records::BatchRecord far;
  far.number = "B9999";
  ASSERT_TRUE(Batches(catalogue()).add(far, anna));
  EXPECT_EQ(Batches(catalogue()).get(newBatch({}))->number, "B10000");
  records::BatchRecord again;
  again.number = "B0001";
  EXPECT_FALSE(Batches(catalogue()).add(again, anna));
  again.number = "../B1";
  EXPECT_FALSE(Batches(catalogue()).add(again, anna));
}

TEST_F(BatchesTest, TheNextNumberNeverOverflows) {
  records::BatchRecord far;
  far.number = "B9223372036854775807";
  EXPECT_FALSE(Batches(catalogue()).add(far, anna));
  catalogue().database().script(
      "INSERT INTO batch (id, created_at, updated_at, number, state) VALUES ('x', 1, 1, "
      "'B9223372036854775807', 'done')");
  EXPECT_EQ(*Batches(catalogue()).nextNumber(), "B0001") << "one from elsewhere counts for nothing";
  far.number = "B999999999";
  ASSERT_TRUE(Batches(catalogue()).add(far, anna));
  EXPECT_EQ(Batches(catalogue()).get(newBatch({}))->number, "B0001");
  EXPECT_EQ(Batches(catalogue()).get(newBatch({}))->number, "B0002");
}

TEST_F(BatchesTest, TheNextNumberHasNoFolderYet) {
  for (const char* folder : {"batches/B0001", "results/B0002", "models/B0003", "batches/B0005"})
    std::filesystem::create_directories(project_->folder() / folder);
  EXPECT_EQ(*Batches(catalogue()).nextNumber(), "B0004");
  EXPECT_EQ(Batches(catalogue()).get(newBatch({}))->number, "B0004");
  EXPECT_EQ(Batches(catalogue()).get(newBatch({}))->number, "B0006");
  // Unless the folders are those of a batch that is about to enter.
  EXPECT_EQ(*Batches(catalogue()).lowestFreeNumber(), "B0001");
  records::BatchRecord first;
  first.number = "B0001";
  ASSERT_TRUE(Batches(catalogue()).add(first, anna));
  EXPECT_EQ(*Batches(catalogue()).lowestFreeNumber(), "B0002");
}

TEST_F(BatchesTest, AStateIsKeptWithWhoAndWhen) {
  const store::BatchRow row = newBatch({bag4});
  ASSERT_TRUE(Batches(catalogue()).setState(row, records::BatchState::Queued, anna));
  ASSERT_TRUE(Batches(catalogue()).setState(row, records::BatchState::Queued, anna));
  EXPECT_EQ(Batches(catalogue()).byNumber("B0001")->state, records::BatchState::Queued);
  const std::vector<records::HistoryEntry> history = *History(catalogue()).of("batch", row.value);
  ASSERT_EQ(history.size(), 3u) << "it was begun, with its bag";
  EXPECT_EQ(history[0].old_value, "placed");
  EXPECT_EQ(history[0].new_value, "queued");
  EXPECT_EQ(history[0].by, anna.person);
  EXPECT_EQ(Batches(catalogue()).all()->front().row, row);
}

TEST_F(BatchesTest, APlateHoldsSixtySherdsAtMost) {
  records::BatchRecord b;
  b.counted = 61;
  EXPECT_FALSE(Batches(catalogue()).add(b, anna));
}

TEST_F(BatchesTest, APhotographIsKnownByItsSideCameraStopAndTake) {
  records::PhotographRecord p;
  p.batch = newBatch({bag4});
  p.camera = 'B';
  p.stop = 5;
  p.path = "batches/B0001/front/cam1_pos05.jpg";
  const store::PhotographRow first = *Batches(catalogue()).save(p, anna);
  p.sharpness = 1.25;
  EXPECT_EQ(*Batches(catalogue()).save(p, anna), first);
  p.take = 1;
  p.path = "batches/B0001/front/cam1_pos05_1.jpg";
  EXPECT_NE(*Batches(catalogue()).save(p, anna), first);
  const std::vector<records::PhotographRecord> all = *Batches(catalogue()).photographs(p.batch);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].camera, 'B');
  EXPECT_EQ(all[0].sharpness, 1.25);
  EXPECT_EQ(History(catalogue()).of("photograph", first.value)->size(), 1u);
  p.path = "/etc/passwd";
  EXPECT_FALSE(Batches(catalogue()).save(p, anna));
}

TEST_F(BatchesTest, ABatchOfTheVirtualRigIsInvented) {
  const store::BatchRow found = newBatch({bag4}), practice = newBatch({bag4});
  records::PhotographRecord p;
  p.batch = found;
  p.path = "batches/B0001/front/cam0_pos00.jpg";
  p.serial = "3012345";
  ASSERT_TRUE(Batches(catalogue()).save(p, anna));
  p.batch = practice;
  p.path = "batches/B0002/front/cam0_pos00.jpg";
  p.serial = "VIRTUAL-A (seed 1, 6 sherds, 1600 px)";
  ASSERT_TRUE(Batches(catalogue()).save(p, anna));
  EXPECT_FALSE(*Batches(catalogue()).isInvented(found));
  EXPECT_TRUE(*Batches(catalogue()).isInvented(practice));
}

TEST_F(BatchesTest, AFileIsKnownByItsPathAndItsChecksumIsRemembered) {
  records::FileRecord f;
  f.path = "results/B0001/report.json";
  f.sha256 = std::string(64, 'a');
  f.bytes = 10;
  f.media_type = "application/json";
  f.role = "report";
  const store::FileRow row = *Files(catalogue()).save(f, anna);
  f.sha256 = std::string(64, 'b');
  EXPECT_EQ(*Files(catalogue()).save(f, anna), row);
  EXPECT_EQ(Files(catalogue()).all()->size(), 1u);
  EXPECT_EQ(History(catalogue()).of("file", row.value)->front().old_value, std::string(64, 'a'));
  f.role = "poem";
  EXPECT_FALSE(Files(catalogue()).save(f, anna));
}

}  // namespace
}  // namespace ostraka::catalogue
