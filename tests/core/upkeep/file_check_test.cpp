#include "upkeep/file_check.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>

#include "base/uuid.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/settings.h"
#include "decisions/decisions.h"
#include "decisions/mask_strokes.h"
#include "files/files.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/pair_decisions.h"
#include "store/database.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

class FileCheck : public catalogue::SmallProject {
 protected:
  FileCheck() : batch(newBatch({bag4})), sherd(numbered(context12)) {
    enter("batches/B0001/front/cam0_pos00.jpg", "photo", std::string(3000, 'p'));
    enter("models/B0001/aa/model.ply", "model", std::string(2000, 'm'));
    enter("models/B0001/aa/preview.png", "preview", std::string(1000, 'v'));
    enter("results/B0001/work/scans_front/f001.ply", "scan", std::string(500, 's'));
    EXPECT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Done, anna));
  }
  fs::path at(const std::string& path) const { return project_->folder() / path; }
  void enter(const std::string& path, const std::string& role, const std::string& bytes) {
    ASSERT_TRUE(writeFileAtomically(at(path), bytes));
    // So that what is written to it later has another time for sure.
    fs::last_write_time(at(path), fs::last_write_time(at(path)) - std::chrono::hours(1));
    records::FileRecord file;
    file.path = path;
    file.role = role;
    file.sha256 = sha256(bytes);
    file.bytes = static_cast<std::int64_t>(bytes.size());
    file.media_type = "application/octet-stream";
    file.batch = batch;
    if (role != "photo" && role != "scan") file.sherd = sherd;
    ASSERT_TRUE(catalogue::Files(catalogue()).save(file, anna));
  }
  // One bit, as a disk does it.
  void flipBit(const std::string& path) {
    std::fstream file(at(path), std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(100);
    const int byte = file.get();
    file.seekp(100);
    file.put(static_cast<char>(byte ^ 4));
  }
  CheckedFiles check(CheckDepth depth = CheckDepth::Hashes) {
    return catalogue::valueIn(checkFiles(catalogue(), project_->folder(), depth, quiet, {}));
  }
  CheckedFiles share(std::int64_t bytes) {
    return catalogue::valueIn(checkShare(catalogue(), project_->folder(), bytes, quiet, {}));
  }
  static std::vector<std::string> sentences(const CheckedFiles& checked) {
    std::vector<std::string> all;
    for (const DamagedFile& file : checked.damaged) all.push_back(sentenceOf(file));
    return all;
  }
  store::BatchRow batch;
  store::SherdRow sherd;
  QuietProgress quiet;
};

TEST_F(FileCheck, FindsOneBitFlippedInEachKindOfFile) {
  EXPECT_THAT(sentences(check()), testing::IsEmpty());
  for (const KnownFile& file : catalogue::valueIn(knownFiles(catalogue()))) flipBit(file.path);
  EXPECT_THAT(sentences(check(CheckDepth::NamesAndSizes)), testing::IsEmpty())
      << "a bit changes no size";
  EXPECT_THAT(sentences(check()),
              testing::ElementsAre(
                  "batches/B0001/front/cam0_pos00.jpg (batch B0001) has changed since it was "
                  "entered.",
                  "models/B0001/aa/model.ply (sherd ARM1-T3-0012-0001, batch B0001) has changed "
                  "since it was entered.",
                  "models/B0001/aa/preview.png (sherd ARM1-T3-0012-0001, batch B0001) has changed "
                  "since it was entered.",
                  "results/B0001/work/scans_front/f001.ply (batch B0001) has changed since it was "
                  "entered."));
}

TEST_F(FileCheck, FindsWhatIsMissingAndWhatHasAnotherSizeByNamesAlone) {
  fs::remove(at("models/B0001/aa/model.ply"));
  std::ofstream(at("batches/B0001/front/cam0_pos00.jpg")) << "cut off";
  for (const CheckDepth depth : {CheckDepth::NamesAndSizes, CheckDepth::Hashes}) {
    const CheckedFiles checked = check(depth);
    ASSERT_EQ(checked.damaged.size(), 2u);
    EXPECT_EQ(checked.damaged[0].damage, Damage::Changed);
    EXPECT_EQ(checked.damaged[1].damage, Damage::Missing);
    EXPECT_EQ(checked.files, 4);
  }
}

// The same bytes, but not the project's: no archive takes them along.
TEST_F(FileCheck, CountsALinkAsDamageWhereverItLeads) {
  fs::rename(at("batches/B0001/front"), folder_.path() / "front");
  fs::create_directory_symlink(folder_.path() / "front", at("batches/B0001/front"));
  fs::rename(at("models/B0001/aa/model.ply"), folder_.path() / "model.ply");
  fs::create_symlink(folder_.path() / "model.ply", at("models/B0001/aa/model.ply"));
  for (const CheckDepth depth : {CheckDepth::NamesAndSizes, CheckDepth::Hashes}) {
    const CheckedFiles checked = check(depth);
    ASSERT_EQ(checked.damaged.size(), 2u);
    EXPECT_EQ(checked.damaged[0].file.path, "batches/B0001/front/cam0_pos00.jpg");
    EXPECT_EQ(checked.damaged[1].file.path, "models/B0001/aa/model.ply");
    EXPECT_EQ(checked.damaged[1].damage, Damage::Unreadable);
  }
  EXPECT_EQ(share(1 << 20).damaged.size(), 2u);
}

TEST_F(FileCheck, LeavesOutTheResultsOfABatchThatIsBeingComputed) {
  flipBit("results/B0001/work/scans_front/f001.ply");
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Queued, anna));
  EXPECT_THAT(sentences(check()), testing::IsEmpty());
  ASSERT_TRUE(catalogue::Batches(catalogue()).setState(batch, records::BatchState::Review, anna));
  EXPECT_EQ(check().damaged.size(), 1u);
}

// Stops when it has said so often how far it is.
class StoppingAt final : public Progress {
 public:
  StoppingAt(int reports, std::stop_source& stop) : left_(reports), stop_(stop) {}
  void report(std::int64_t done, std::int64_t total) override {
    EXPECT_LE(done, total);
    if (--left_ == 0) stop_.request_stop();
  }
  void note(NoteLevel, const Message&) override {}

 private:
  int left_;
  std::stop_source& stop_;
};

TEST_F(FileCheck, GoesOnWhereItWasInterrupted) {
  std::stop_source stop;
  StoppingAt third(3, stop);
  const auto stopped =
      checkFiles(catalogue(), project_->folder(), CheckDepth::Hashes, third, stop.get_token());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  const CheckedFiles rest = check();
  EXPECT_EQ(rest.files, 4);
  EXPECT_EQ(rest.checked, 2) << "the two before were whole";
  EXPECT_EQ(check().checked, 4) << "a check that ended begins anew";
}

TEST_F(FileCheck, NamesTheDamageThatItFoundBeforeItWasInterrupted) {
  flipBit("batches/B0001/front/cam0_pos00.jpg");
  std::stop_source stop;
  StoppingAt last(4, stop);
  ASSERT_FALSE(
      checkFiles(catalogue(), project_->folder(), CheckDepth::Hashes, last, stop.get_token()));
  const CheckedFiles rest = check();
  ASSERT_EQ(rest.damaged.size(), 1u);
  EXPECT_EQ(rest.checked, 2) << "what was damaged is looked at again";
}

TEST_F(FileCheck, GoesOnFromALineThatWasCutOff) {
  std::stop_source stop;
  StoppingAt third(3, stop);
  ASSERT_FALSE(
      checkFiles(catalogue(), project_->folder(), CheckDepth::Hashes, third, stop.get_token()));
  const fs::path log = at("file-checks.txt");
  fs::resize_file(log, fs::file_size(log) - 5);
  EXPECT_EQ(check().checked, 3);
  std::ofstream(log) << "\x01\xff nonsense\n9223372036854775807 begin\n-3 whole\n";
  EXPECT_THAT(sentences(check()), testing::IsEmpty());
}

TEST_F(FileCheck, LooksAgainAtAFileThatWasEnteredAnewMeanwhile) {
  std::stop_source stop;
  StoppingAt last(4, stop);
  ASSERT_FALSE(
      checkFiles(catalogue(), project_->folder(), CheckDepth::Hashes, last, stop.get_token()));
  enter("batches/B0001/front/cam0_pos00.jpg", "photo", "another");
  flipBit("models/B0001/aa/model.ply");
  const CheckedFiles rest = check();
  EXPECT_EQ(rest.checked, 3) << "the new photograph, the model, the scan that was not reached";
  EXPECT_EQ(rest.damaged.size(), 1u);
}

// Of the same size and time of writing, as a copy that keeps times.
TEST_F(FileCheck, LooksAgainAtAFileThatAnotherTookThePlaceOf) {
  std::stop_source stop;
  StoppingAt last(4, stop);
  ASSERT_FALSE(
      checkFiles(catalogue(), project_->folder(), CheckDepth::Hashes, last, stop.get_token()));
  const fs::path model = at("models/B0001/aa/model.ply"), before = at("before.ply");
  fs::rename(model, before);
  fs::copy_file(before, model);
  flipBit("models/B0001/aa/model.ply");
  fs::last_write_time(model, fs::last_write_time(before));
  const CheckedFiles rest = check();
  EXPECT_EQ(rest.checked, 2);
  EXPECT_EQ(rest.damaged.size(), 1u);
}

// A project from elsewhere may say anything of its own files.
TEST_F(FileCheck, BelievesNoLogOfAnotherComputer) {
  std::string log = std::to_string(now_ms - 2) + " begin\n";
  for (const KnownFile& file : catalogue::valueIn(knownFiles(catalogue())))
    for (const char* stamp : {"", "- ", "3000,1,1.0,1.0 "})
      log += std::to_string(now_ms - 1) + " whole " + file.sha256 + " " + stamp + file.path + "\n";
  ASSERT_TRUE(writeFileAtomically(at("file-checks.txt"), log));
  flipBit("models/B0001/aa/model.ply");
  const CheckedFiles checked = check();
  EXPECT_EQ(checked.checked, 4);
  EXPECT_EQ(checked.damaged.size(), 1u);
}

TEST_F(FileCheck, SaysHowManyFilesItReadNowAndHowManyEarlier) {
  std::stop_source stop;
  StoppingAt third(3, stop);
  ASSERT_FALSE(
      checkFiles(catalogue(), project_->folder(), CheckDepth::Hashes, third, stop.get_token()));
  for (const std::int64_t read_now : {2, 4}) {
    const Result<CheckedFiles> checked =
        checkFiles(catalogue(), project_->folder(), CheckDepth::Hashes, quiet, {});
    ASSERT_TRUE(checked);
    EXPECT_EQ(checked->checked, read_now);
    EXPECT_EQ(checked->files, 4);
  }
}

TEST_F(FileCheck, OfAShareTakesTheLongestUncheckedInTurn) {
  for (int opening = 0; opening < 4; ++opening) {
    const CheckedFiles checked = share(1);
    EXPECT_EQ(checked.checked, 1);
    EXPECT_EQ(checked.files, 4);
  }
  flipBit("models/B0001/aa/preview.png");
  CheckedFiles found;
  int openings = 0;
  for (; found.damaged.empty() && openings < 10; ++openings) found = share(1);
  EXPECT_EQ(openings, 3) << "the third in its turn";
  EXPECT_EQ(share(1).damaged.size(), 1u) << "what was damaged is said until it is mended";
  ASSERT_TRUE(writeFileAtomically(at("models/B0001/aa/preview.png"), std::string(1000, 'v')));
  EXPECT_TRUE(share(1).damaged.empty());
  EXPECT_EQ(share(1 << 20).checked, 4);
}

TEST_F(FileCheck, FindsAFileUnderTheVeryNameThatTheDiskHas) {
  for (const char* name : {"\xC3\xA9", "e\xCC\x81"})  // composed and decomposed
    enter("batches/B0001/front/" + std::string(name) + ".jpg", "photo", name);
  EXPECT_EQ(check().files, 6);
  EXPECT_THAT(sentences(check()), testing::IsEmpty());
}

TEST_F(FileCheck, GoesOnFromWhatAShareLookedAtMeanwhile) {
  std::stop_source stop;
  StoppingAt third(3, stop);
  ASSERT_FALSE(
      checkFiles(catalogue(), project_->folder(), CheckDepth::Hashes, third, stop.get_token()));
  EXPECT_EQ(share(1 << 20).checked, 4);
  EXPECT_EQ(check().checked, 0);
}

TEST_F(FileCheck, NeedsNoRightToWrite) {
  fs::create_directory(at("file-checks.txt"));  // where root may write everywhere
  flipBit("models/B0001/aa/model.ply");
  EXPECT_EQ(check().damaged.size(), 1u);
  EXPECT_EQ(share(1 << 20).damaged.size(), 1u);
}

TEST_F(FileCheck, RefusesACatalogueThatNamesPlacesWhereNoFilesOfItLie) {
  EXPECT_TRUE(checkPaths(catalogue()));
  for (const char* path : {"../../.ssh/id_rsa", "catalogue.sqlite", "results/B0001/decisions.json"})
    for (const char* column : {"sherd SET model_path", "sherd SET preview_path", "file SET path"}) {
      catalogue().database().script("SAVEPOINT before");
      const std::string one = column[0] == 'f' ? " WHERE role = 'preview'" : "";
      catalogue().database().run("UPDATE " + std::string(column) + " = ?" + one, std::string(path));
      const Result<void> paths = checkPaths(catalogue());
      ASSERT_FALSE(paths) << column << " " << path;
      EXPECT_EQ(paths.error().code, ErrorCode::UnusableInput);
      catalogue().database().script("ROLLBACK TO before; RELEASE before");
    }
  EXPECT_TRUE(checkPaths(catalogue()));
}

TEST_F(FileCheck, IsNotPutOffByTimesThatAreStillToCome) {
  constexpr std::int64_t kYear_ms = 365LL * 24 * 3600 * 1000;
  now_ms += kYear_ms;  // a clock that runs ahead
  ASSERT_TRUE(check().damaged.empty());
  now_ms -= kYear_ms;
  flipBit("models/B0001/aa/model.ply");
  EXPECT_THAT(sentences(check()), testing::SizeIs(1));
}

class PeoplesFiles : public FileCheck {
 protected:
  PeoplesFiles() {
    decisions::PairDecision aside;
    aside.kind = decisions::DecisionKind::Aside;
    aside.by = "AP";
    aside.scans = {{batch::Side::Front, "f001", {1, 2}, {}}};
    const auto written = decisions::appendDecision(at("results/B0001"), aside);
    EXPECT_TRUE(written) << written.error().sentence();
    records::PairDecision entered;
    entered.decision = written->id;
    entered.batch = batch;
    entered.front = scan(batch, batch::Side::Front, 1);
    entered.verdict = records::Verdict::Aside;
    entered.by = anna.person;
    EXPECT_TRUE(sherds::PairDecisions(catalogue()).add(entered, anna));
    text_ = *readFile(at(kFile));
  }
  static constexpr const char* kFile = "results/B0001/decisions.json";
  std::string text_;
};

TEST_F(PeoplesFiles, HoldTheDecisionsOfTheCatalogueOrAreDamaged) {
  EXPECT_THAT(sentences(check()), testing::IsEmpty());
  ASSERT_TRUE(writeFileAtomically(at(kFile), decisions::textOf(decisions::Decisions())));
  EXPECT_THAT(sentences(check()),
              testing::ElementsAre("results/B0001/decisions.json (batch B0001) has "
                                   "changed since it was entered."));
  ASSERT_TRUE(writeFileAtomically(at(kFile), text_.substr(0, text_.size() / 2)));
  EXPECT_THAT(sentences(check(CheckDepth::NamesAndSizes)),
              testing::ElementsAre("results/B0001/decisions.json (batch B0001) cannot be read."));
  fs::remove(at(kFile));
  EXPECT_THAT(sentences(share(1 << 20)),
              testing::ElementsAre("results/B0001/decisions.json (batch B0001) is missing."));
}

// Whatever its clock said: no file here ever had it.
TEST_F(PeoplesFiles, NeedNotHoldADecisionThatCameWithAnExport) {
  records::PairDecision came;
  came.decision = "0190a0b0-0000-7000-8000-000000000001";
  came.batch = batch;
  came.front = scan(batch, batch::Side::Front, 2);
  came.verdict = records::Verdict::Aside;
  came.by = anna.person;
  for (const std::int64_t ahead_ms : {-86'400'000, 86'400'000}) {
    came.at_ms = now_ms + ahead_ms;
    came.id = newId(came.at_ms);
    ASSERT_TRUE(sherds::restoreDecision(catalogue(), came));
    EXPECT_THAT(sentences(check()), testing::IsEmpty());
  }
}

TEST_F(PeoplesFiles, HoldTheStrokesThatTheCatalogueKnowsOrAreDamaged) {
  const auto stroke = [](int position, double x) {
    decisions::MaskStroke s;
    s.stop = position;
    s.radius_px = 5;
    s.path_px = {{x, 10}};
    s.photograph = sha256(std::to_string(position));
    return s;
  };
  const std::vector<decisions::MaskStroke> known = {stroke(0, 1), stroke(3, 2), stroke(0, 3)};
  const auto checkedWith = [&](const std::vector<decisions::MaskStroke>& strokes) {
    EXPECT_TRUE(decisions::writeMaskStrokes(at("results/B0001"), strokes));
    return sentences(check());
  };
  ASSERT_TRUE(
      catalogue::Settings(catalogue())
          .setValue(std::string(decisions::kKnownStrokes) + "B0001", decisions::knownText(known)));
  EXPECT_THAT(checkedWith(known), testing::IsEmpty());
  EXPECT_THAT(checkedWith({stroke(0, 1), stroke(0, 3), stroke(3, 2), stroke(3, 4)}),
              testing::IsEmpty())
      << "painted on, as where the program ended before the catalogue learned of it";
  const auto changed = testing::ElementsAre(
      "results/B0001/mask_strokes.json (batch B0001) has changed since it was entered.");
  EXPECT_THAT(checkedWith({stroke(0, 1), stroke(3, 2)}), changed);
  EXPECT_THAT(checkedWith({stroke(0, 1), stroke(3, 7), stroke(0, 3)}), changed);
  fs::remove(at("results/B0001/mask_strokes.json"));
  EXPECT_THAT(sentences(share(1 << 20)),
              testing::ElementsAre("results/B0001/mask_strokes.json (batch B0001) is missing."));
}

TEST_F(PeoplesFiles, AreReadThoughTheCatalogueDoesNotKnowThem) {
  ASSERT_TRUE(decisions::writeMaskStrokes(at("results/B0001"), {}));
  EXPECT_THAT(sentences(check()), testing::IsEmpty());
  ASSERT_TRUE(writeFileAtomically(at("results/B0001/mask_strokes.json"), "[{"));
  EXPECT_THAT(sentences(check()),
              testing::ElementsAre("results/B0001/mask_strokes.json (batch B0001) "
                                   "cannot be read."));
}

}  // namespace
}  // namespace ostraka::upkeep
