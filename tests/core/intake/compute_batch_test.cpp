// What the queue's work leaves in a project, with real scans.
#include "intake/compute_batch.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "files/files.h"
#include "files/json.h"
#include "intake/computed_again.h"
#include "sherds/measurements.h"
#include "sherds/sherds.h"
#include "synthetic_out.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;
using catalogue::valueIn;

// A batch of two sherds in the queue, as another scanner left its scans.
class ComputeBatch : public catalogue::SmallProject {
 protected:
  ComputeBatch() {
    records::BatchRecord queued;
    queued.state = records::BatchState::Queued;
    batch = valueIn(catalogue::Batches(catalogue()).add(queued, anna));
    const auto truth = pipeline::writeSyntheticOut(folder_.path() / "truth",
                                                   {.sherds = 2, .swapped_look_alikes = false});
    fs::create_directories(project_->batchFolder("B0001"));
    for (const char* side : {"front", "back"})
      fs::copy(truth.output / "work" / (std::string("scans_") + side),
               project_->batchFolder("B0001") / side);
  }
  BatchFigures compute(Progress& progress) {
    return valueIn(computeBatch({project_->folder(), "B0001"}, progress, {}));
  }
  records::BatchState state() { return catalogue::Batches(catalogue()).get(batch)->state; }

  store::BatchRow batch;
  QuietProgress quiet;
};

// From another scanner's files to rows with models and measures, as photographs do.
TEST_F(ComputeBatch, ImportedScansBecomeSherdsOfTheCatalogue) {
  const BatchFigures figures = compute(quiet);
  EXPECT_EQ(figures.sherds, 2);
  const auto rows = valueIn(sherds::Sherds(catalogue()).rows(batch));
  ASSERT_EQ(rows.size(), 2u);
  for (const records::SherdRecord& sherd : valueIn(sherds::Sherds(catalogue()).of(rows))) {
    ASSERT_FALSE(sherd.model_path.empty());
    EXPECT_TRUE(fs::exists(project_->folder() / sherd.model_path));
    const auto measured = valueIn(sherds::Measurements(catalogue()).of(sherd.row));
    EXPECT_TRUE(std::any_of(measured.begin(), measured.end(),
                            [](const auto& m) { return m.kind == "length" && m.value > 15; }));
  }
  EXPECT_EQ(state(), figures.ask > 0 ? records::BatchState::Review : records::BatchState::Done);
}

TEST_F(ComputeBatch, APieceThatFoundNoPartnerWantsAPerson) {
  ASSERT_TRUE(fs::remove(project_->batchFolder("B0001") / "back" / "b002.ply"));
  const BatchFigures figures = compute(quiet);
  EXPECT_EQ(figures.sherds, 2);
  EXPECT_EQ(figures.sure, 1);
  EXPECT_EQ(figures.ask, 1);
  EXPECT_EQ(state(), records::BatchState::Review);
}

TEST_F(ComputeBatch, AnotherNumberOfSherdsThanWasCountedIsSaid) {
  class Notes final : public Progress {
   public:
    void begin(std::string_view, double) override {}
    void report(std::int64_t, std::int64_t) override {}
    void note(NoteLevel, const Message& sentence) override { said += sentence.english(); }
    std::string said;
  } notes;
  records::BatchRecord record = *catalogue::Batches(catalogue()).get(batch);
  record.counted = 3;
  ASSERT_TRUE(catalogue::Batches(catalogue()).save(record, anna));
  EXPECT_EQ(compute(notes).counted, 3);
  EXPECT_THAT(notes.said, testing::HasSubstr("Sherds counted on the plate: 3,"));
}

TEST_F(ComputeBatch, PhotographsThatWentAwayWhileItWaitedAreNamedInTheResults) {
  for (const char* name : {"IMG_1.jpg", "IMG_2.jpg"}) {
    records::FileRecord file;
    file.path = std::string("batches/B0001/front/") + name;
    file.sha256 = sha256(name);
    file.media_type = "image/jpeg";
    file.role = "photo";
    file.batch = batch;
    ASSERT_TRUE(catalogue::Files(catalogue()).save(file, anna));
  }
  ASSERT_TRUE(writeFileAtomically(project_->batchFolder("B0001") / "front/IMG_1.jpg", "IMG_1.jpg"));
  compute(quiet);
  const auto report = readJson(project_->resultsFolder("B0001") / "report.json");
  ASSERT_TRUE(report);
  EXPECT_THAT(report->at("warnings").dump(), testing::HasSubstr("folder (1): front/IMG_2.jpg."));
}

TEST_F(ComputeBatch, ResultsOfAnotherComputerAreEnteredAsItsOwnOnce) {
  const records::BatchRecord begun = *catalogue::Batches(catalogue()).get(batch);
  const BatchFigures own = compute(quiet);
  const records::BatchState state_after = state();
  const auto rows = valueIn(sherds::Sherds(catalogue()).rows(batch));
  for (int times = 0; times < 2; ++times) {
    ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Queued, anna));
    const Result<BatchFigures> entered = enterComputed(*project_, begun, quiet, {});
    ASSERT_TRUE(entered) << entered.error().sentence();
    EXPECT_EQ(entered->sherds, own.sherds);
    EXPECT_EQ(entered->sure, own.sure);
    EXPECT_EQ(entered->ask, own.ask);
    EXPECT_EQ(entered->uncertainty_mm, own.uncertainty_mm);
    EXPECT_GT(entered->seconds, 0);
    EXPECT_EQ(state(), state_after);
    EXPECT_EQ(valueIn(sherds::Sherds(catalogue()).rows(batch)), rows);
  }
  EXPECT_EQ(keptFigures(catalogue(), "B0001")->sherds, own.sherds);
  ASSERT_TRUE(fs::remove(project_->resultsFolder("B0001") / "report.json"));
  EXPECT_EQ(enterComputed(*project_, begun, quiet, {}).error().code, ErrorCode::Missing);
}

// In its midst somebody decides, and wants that computed, too.
TEST_F(ComputeBatch, WhatIsAskedWhileABatchIsComputedIsQueuedAgain) {
  class Asking final : public Progress {
   public:
    explicit Asking(fs::path project) : project_(std::move(project)) {}
    void begin(std::string_view stage, double) override {
      if (stage != "pairs") return;
      auto rows = upkeep::Project::connect(project_);
      asked = rows && queueAgain(*rows, "B0001", {}).has_value();
    }
    void report(std::int64_t, std::int64_t) override {}
    void note(NoteLevel, const Message&) override {}
    bool asked = false;

   private:
    fs::path project_;
  };
  Asking progress(project_->folder());
  compute(progress);
  EXPECT_TRUE(progress.asked);
  EXPECT_EQ(state(), records::BatchState::Queued);
  compute(quiet);
  EXPECT_NE(state(), records::BatchState::Queued);
}

// 48 batches must not become 529 when a first, small one has been computed, nor grow with each.
TEST(RoomForBatches, IsPredictedFromTheirPhotographs) {
  const catalogue::TemporaryFolder folder;
  const fs::path& place = folder.path();
  const double before = bytesPerBatch(place);
  const auto photograph = [&](const char* batch, std::size_t bytes) {
    for (const char* side : {"front", "back"})
      ASSERT_TRUE(writeFileAtomically(place / "batches" / batch / side / "cam0_pos00.jpg",
                                      std::string(bytes, 'x')));
  };
  photograph("B0001", 1000);
  EXPECT_EQ(bytesPerBatch(place), before);
  photograph("B0002", 20'000'000);
  photograph("B0003", 1000);
  const double three = bytesPerBatch(place);
  EXPECT_EQ(three, 3 * 40e6) << "its results are expected, too";
  photograph("B0004", 1000);
  EXPECT_EQ(bytesPerBatch(place), three);
  photograph("B0005", 30'000'000);
  EXPECT_EQ(bytesPerBatch(place), 3 * 60e6);
  // Scans that were imported, however many, say nothing of what is photographed.
  for (int i = 100; i < 120; ++i)
    for (const char* side : {"front", "back"})
      ASSERT_TRUE(writeFileAtomically(
          place / "batches" / ("B0" + std::to_string(i)) / side / "f001.ply", "ply"));
  EXPECT_EQ(bytesPerBatch(place), 3 * 60e6);
}

}  // namespace
}  // namespace ostraka::intake
