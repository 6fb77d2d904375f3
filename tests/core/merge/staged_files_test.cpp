// Photographs, results and models of another house: whole, where they belong, or not at all.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "catalogue/file_places.h"
#include "decisions/decisions.h"
#include "two_houses.h"
#include "upkeep/file_check.h"

namespace ostraka::merge {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;

class MergedFiles : public TwoHouses {
 protected:
  MergedFiles() : b_(copied("b")) {
    here_ = plate(*project_, "of A");
    there_ = plate(b_, "of B");
  }
  // B0002, with one photograph, results and a draft with a model.
  std::string plate(upkeep::Project& project, const std::string& bytes) {
    records::BatchRecord record;
    record.number = "B0002";
    const store::BatchRow row = valueIn(Batches(project.catalogue()).add(record, anna));
    records::FileRecord f;
    f.path = "batches/B0002/front/cam0_pos00.jpg";
    f.sha256 = sha256(bytes);
    f.bytes = static_cast<std::int64_t>(bytes.size());
    f.media_type = "image/jpeg";
    f.role = "photo";
    f.batch = row;
    put(project.folder() / f.path, bytes);
    put(project.folder() / "batches/B0002/batch.json", "{}");
    EXPECT_TRUE(Files(project.catalogue()).save(f, anna));
    const ResultFolder one(project.resultsFolder("B0002"), 1);
    EXPECT_TRUE(intake::enterResults(project.catalogue(), project.folder(), row,
                                     project.resultsFolder("B0002"), {}, quiet, {}));
    return Batches(project.catalogue()).get(row)->id;
  }
  void nameInB(const std::string& path, const std::string& bytes, const std::string& of = {}) {
    records::FileRecord f;
    f.path = catalogue::recordedPath(path) ? path : "imported/put/x.jpg";
    f.sha256 = sha256(bytes);
    f.bytes = static_cast<std::int64_t>(bytes.size());
    f.media_type = "image/jpeg";
    f.role = "photo";
    if (!of.empty()) f.batch = valueIn(Batches(b_.catalogue()).byNumber(of)).row;
    put(b_.folder() / path, bytes);
    EXPECT_TRUE(Files(b_.catalogue()).save(f, anna));
    if (f.path != path)  // as only somebody else writes it
      b_.catalogue().database().run("UPDATE file SET path = ? WHERE path = ?", path, f.path);
  }
  // As a merge notes a file that waits in merge.partial.
  void noteWaiting(const std::string& to, const std::string& name, const std::string& over = {}) {
    nlohmann::json journal;
    journal[to] = nlohmann::json::array({name, over});
    ASSERT_TRUE(Settings(catalogue()).setValue("merge.files", journal.dump()));
  }
  upkeep::Project opened() { return valueIn(upkeep::Project::open(project_->folder())); }
  void everyFileIsThere() {
    for (const records::FileRecord& file : valueIn(Files(catalogue()).all()))
      EXPECT_EQ(sha256(bytesOf(project_->folder() / file.path)), file.sha256) << file.path;
  }
  upkeep::Project b_;
  std::string here_, there_;
};

TEST_F(MergedFiles, ABatchWhoseNumberIsTakenGetsTheNextOneWithItsFiles) {
  ASSERT_TRUE(catalogue::Settings(b_.catalogue())
                  .setValue(std::string(catalogue::kKeptTwice) + "B0002", "1", anna));
  const std::string bytes_of_b = bytesOf(b_.folder() / "catalogue.sqlite");
  const MergeReport report = merged(*project_, b_);
  const catalogue::Settings settings(catalogue());
  EXPECT_EQ(valueIn(settings.value("photographs.kept_twice.B0003")), "1") << "B keeps both";
  EXPECT_EQ(valueIn(settings.value("photographs.kept_twice.B0002")), "") << "that is A's own";
  EXPECT_THAT(report.renumbered, testing::ElementsAre(testing::Pair("B0002", "B0003")));
  EXPECT_EQ(bytesOf(b_.folder() / "catalogue.sqlite"), bytes_of_b) << "B is only read";
  const records::BatchRecord batch3 = valueIn(Batches(catalogue()).byNumber("B0003"));
  EXPECT_EQ(batch3.id, there_);
  EXPECT_EQ(Batches(catalogue()).byNumber("B0002")->id, here_);
  EXPECT_EQ(bytesOf(project_->folder() / "batches/B0003/front/cam0_pos00.jpg"), "of B");
  EXPECT_EQ(bytesOf(project_->folder() / "batches/B0003/batch.json"), "{}");
  EXPECT_TRUE(fs::exists(project_->folder() / "results/B0003/pairs.json"));
  everyFileIsThere();
  const auto sherds_of = valueIn(sherds::Sherds(catalogue()).rows(batch3.row));
  ASSERT_EQ(sherds_of.size(), 1u);
  const records::SherdRecord sherd = valueIn(sherds::Sherds(catalogue()).get(sherds_of[0]));
  EXPECT_TRUE(sherd.model_path.starts_with("models/B0003/")) << sherd.model_path;
  EXPECT_TRUE(fs::exists(project_->folder() / sherd.model_path));
  EXPECT_FALSE(fs::exists(project_->folder() / "merge.partial"));
  const std::string after = contentIn(*project_);
  EXPECT_EQ(merged(*project_, b_).files, 0);
  EXPECT_EQ(contentIn(*project_), after);
}

TEST_F(MergedFiles, AFileThatIsNotAsItsCatalogueHasItStopsAll) {
  put(b_.folder() / "batches/B0002/front/cam0_pos00.jpg", "oF B");
  const std::string before = contentIn(*project_);
  const Result<MergeReport> report = tried(*project_, b_, {});
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().where, testing::HasSubstr("cam0_pos00.jpg"));
  EXPECT_EQ(contentIn(*project_), before);
  EXPECT_FALSE(fs::exists(project_->folder() / "batches/B0003"));
  EXPECT_FALSE(fs::exists(project_->folder() / "merge.partial"));
}

TEST_F(MergedFiles, AFileThatBHasLostIsNamed) {
  fs::remove(b_.folder() / "batches/B0002/front/cam0_pos00.jpg");
  const MergeReport report = merged(*project_, b_);
  EXPECT_TRUE(report.entered);
  EXPECT_THAT(report.missing, testing::ElementsAre("batches/B0002/front/cam0_pos00.jpg"));
}

TEST_F(MergedFiles, FilesThatBHasAgainComeWithTheNextMerge) {
  const std::string named = "front/cam0_pos00.jpg", unnamed = "front/cam0_pos01.jpg";
  const fs::path there = b_.folder() / "batches/B0002", away = folder_.path() / "away",
                 here = project_->folder() / "batches/B0003";
  put(there / unnamed, "that no row names");
  fs::rename(there, away);
  EXPECT_THAT(merged(*project_, b_).missing, testing::ElementsAre("batches/B0002/" + named));
  const MergeReport still = merged(*project_, b_);
  EXPECT_EQ(still.files, 0);
  EXPECT_THAT(still.missing, testing::ElementsAre("batches/B0002/" + named)) << "said again";

  fs::rename(away, there);
  const MergeReport report = merged(*project_, b_);
  EXPECT_THAT(report.missing, testing::IsEmpty());
  EXPECT_EQ(report.added + report.changed, 0);
  EXPECT_EQ(bytesOf(here / named), "of B");
  EXPECT_EQ(bytesOf(here / unnamed), "that no row names");
  everyFileIsThere();
  const std::string after = contentIn(*project_);
  fs::remove(here / unnamed);
  EXPECT_EQ(merged(*project_, b_).files, 0) << "it was completed";
  EXPECT_EQ(contentIn(*project_), after);
}

TEST_F(MergedFiles, AFileThatALostComesFromACopyThatHasItWhole) {
  merged(*project_, b_);
  const fs::path lost = project_->folder() / "batches/B0003/front/cam0_pos00.jpg",
                 there = b_.folder() / "batches/B0002/front/cam0_pos00.jpg";
  fs::remove(lost);
  put(there, "oF B");
  EXPECT_EQ(merged(*project_, b_).missing.size(), 1u);
  EXPECT_FALSE(fs::exists(lost)) << "not whole";
  put(there, "of B");
  EXPECT_EQ(merged(*project_, b_).files, 1);
  EXPECT_EQ(bytesOf(lost), "of B");
}

TEST_F(MergedFiles, APreviewCountsWhatWouldCome) {
  fs::remove(b_.folder() / "batches/B0002/front/cam0_pos00.jpg");
  const std::string before = contentIn(*project_);
  const MergeReport preview =
      valueIn(mergeInto(*project_, b_.folder(), MergeMode::Preview, {}, anna, quiet, {}));
  EXPECT_FALSE(preview.entered);
  EXPECT_FALSE(fs::exists(project_->folder() / "batches/B0003"));
  EXPECT_EQ(contentIn(*project_), before);
  const MergeReport entered = merged(*project_, b_);
  EXPECT_EQ(preview.batches, 1);
  EXPECT_EQ(preview.sherds, 1);
  EXPECT_EQ(preview.files, entered.files);
  EXPECT_EQ(preview.bytes, entered.bytes);
  EXPECT_EQ(preview.missing, entered.missing);
  EXPECT_EQ(preview.renumbered, entered.renumbered);
}

// As a process leaves it that is killed after the catalogue was saved.
TEST_F(MergedFiles, AMergeThatWasKilledIsCompletedWhenTheProjectIsOpened) {
  merged(*project_, b_);
  const fs::path photograph = project_->folder() / "batches/B0003/front/cam0_pos00.jpg";
  fs::create_directories(project_->folder() / "merge.partial");
  fs::rename(photograph, project_->folder() / "merge.partial/1");
  noteWaiting("batches/B0003/front/cam0_pos00.jpg", "1");
  const auto checked = upkeep::checkFiles(catalogue(), project_->folder(),
                                          upkeep::CheckDepth::NamesAndSizes, quiet, {});
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->damaged.size(), 1u) << "nothing half merged looks whole";
  EXPECT_TRUE(opened().keptFiles().empty());
  EXPECT_EQ(bytesOf(photograph), "of B");
  EXPECT_EQ(valueIn(Settings(catalogue()).value("merge.files")), "");
  EXPECT_FALSE(fs::exists(project_->folder() / "merge.partial"));
  everyFileIsThere();
}

TEST_F(MergedFiles, WhatIsDecidedAfterAKillIsJoinedWithWhatTheMergeBrings) {
  const auto decided = [](const std::string& id) {
    decisions::PairDecision one;
    one.id = id;
    one.kind = decisions::DecisionKind::Aside;
    one.at = "2026-07-14T09:30:12Z";
    one.by = "AP";
    one.scans = {{batch::Side::Front, id, Eigen::Vector2d(10, 10)}};
    return one;
  };
  const auto before = decided("019f0000-0000-7000-8000-000000000001"),
             of_b = decided("019f0000-0000-7000-8000-000000000002"),
             later = decided("019f0000-0000-7000-8000-000000000003");
  const std::string place = "results/B0002/decisions.json";
  put(project_->folder() / "merge.partial/1", decisions::textOf({before, of_b}));
  noteWaiting(place, "1", sha256(decisions::textOf({before})));
  put(project_->folder() / place, decisions::textOf({before, later}));
  EXPECT_TRUE(opened().keptFiles().empty());
  const auto joined =
      valueIn(decisions::parseDecisions(bytesOf(project_->folder() / place), "decisions.json"));
  ASSERT_EQ(joined.size(), 3u);
  EXPECT_EQ(joined[1].id, later.id);
  EXPECT_EQ(joined[2].id, of_b.id);
}

TEST_F(MergedFiles, ResultsMadeAnewAfterAKillStayAsOneComputation) {
  const fs::path results = project_->resultsFolder("B0002");
  put(results / "report.json", "made anew");
  put(results / "f009.ply", "of before");
  put(project_->folder() / "merge.partial/1", "report of B");
  put(project_->folder() / "merge.partial/2", "scan of B");
  put(project_->folder() / "merge.partial/3", "photograph of B");
  const nlohmann::json journal = {
      {"results/B0002/report.json", {"1", sha256(std::string("of before"))}},
      {"results/B0002/f009.ply", {"2", sha256(std::string("of before"))}},
      {"batches/B0002/front/cam0_pos01.jpg", {"3", ""}}};
  ASSERT_TRUE(Settings(catalogue()).setValue("merge.files", journal.dump()));
  upkeep::Project again = opened();
  EXPECT_THAT(again.keptFiles(), testing::ElementsAre("results/B0002"));
  EXPECT_EQ(bytesOf(results / "report.json"), "made anew");
  EXPECT_EQ(bytesOf(results / "f009.ply"), "of before");
  EXPECT_EQ(bytesOf(project_->folder() / "batches/B0002/front/cam0_pos01.jpg"), "photograph of B");
  EXPECT_THAT(merged(again, b_).kept, testing::ElementsAre("results/B0002"));
}

// And one that is killed before.
TEST_F(MergedFiles, WhatAKilledMergeCopiedInVainGoes) {
  put(project_->folder() / "merge.partial/1", "half");
  merged(*project_, b_);
  EXPECT_FALSE(fs::exists(project_->folder() / "merge.partial"));
  everyFileIsThere();
}

// So that a disk that refuses a name, or takes two for one, does so before the catalogue is saved.
TEST_F(MergedFiles, WaitUnderThePathsThatTheyWillHave) {
  const std::string odd = "notes: 1.txt";
  put(b_.folder() / "batches/B0002/front" / odd, "hello");
  struct Watching : Progress {
    void report(std::int64_t, std::int64_t) override { seen |= fs::exists(watched); }
    void note(NoteLevel, const Message&) override {}
    fs::path watched;
    bool seen = false;
  } watching;
  watching.watched = project_->folder() / "merge.partial/batches/B0003/front" / odd;
  put(b_.folder() / "batches/B0002/front/of later.txt", "x");
  EXPECT_TRUE(mergeInto(*project_, b_.folder(), MergeMode::Enter, {}, anna, watching, {}));
  EXPECT_TRUE(watching.seen);
  EXPECT_EQ(bytesOf(project_->folder() / "batches/B0003/front" / odd), "hello");
}

TEST_F(MergedFiles, NoMergeBeginsWhileAFileOfAnEarlierOneWaits) {
  const std::string place = "batches/B0002/front/more.jpg";
  put(project_->folder() / "merge.partial" / place, "waits");
  noteWaiting(place, place);
  put(project_->folder() / place / "in_the_way", "x");
  const Result<MergeReport> refused = tried(*project_, b_, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(refused.error().where, testing::HasSubstr(place));
  fs::remove_all(project_->folder() / place);
  EXPECT_TRUE(merged(*project_, b_).entered);
  EXPECT_EQ(bytesOf(project_->folder() / place), "waits");
}

TEST_F(MergedFiles, ThoseThatBImportedWithAnExportComeToo) {
  const std::string path = "imported/export/models/B0001-01.ply";
  nameInB(path, "of an export");
  merged(*project_, b_);
  EXPECT_EQ(bytesOf(project_->folder() / path), "of an export");
  everyFileIsThere();
}

// Anybody may have written B.
TEST_F(MergedFiles, NoneComesToAPlaceThatIsNotOfABatch) {
  nameInB("backups/catalogue-20260101-000000-000.sqlite", "of B");
  const std::string before = contentIn(*project_);
  const Result<MergeReport> report = tried(*project_, b_, {});
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().where, testing::HasSubstr("backups/"));
  EXPECT_EQ(contentIn(*project_), before);
  EXPECT_FALSE(fs::exists(project_->folder() / "backups/catalogue-20260101-000000-000.sqlite"));
}

class PlantedFiles : public MergedFiles, public testing::WithParamInterface<const char*> {};

// B0005 is a batch of A alone, whatever batch of its own B names with the file.
TEST_P(PlantedFiles, NoneComesIntoABatchThatIsNotItsOwnOrSteersTheProgram) {
  records::BatchRecord own;
  own.number = "B0005";
  ASSERT_TRUE(Batches(catalogue()).add(own, anna));
  nameInB(GetParam(), "of B", "B0002");
  const std::string before = contentIn(*project_);
  const Result<MergeReport> report = tried(*project_, b_, {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(report.error().where, GetParam());
  EXPECT_EQ(contentIn(*project_), before);
  EXPECT_FALSE(fs::exists(project_->folder() / GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Merge, PlantedFiles,
                         testing::Values("results/B0005/decisions.json",
                                         "results/B0005/mask_strokes.json",
                                         "batches/B0005/rig.json", "batches/B0005/scale.json",
                                         "batches/B0005/front/x.jpg", "results/B0009/work/lock",
                                         "models/B0001/.hidden", "imported/a/b.desktop"));

TEST_F(MergedFiles, NoneReplacesAFileThatACatalogueDoesNotKnow) {
  const std::string path = "batches/B0001/front/more.jpg";
  put(project_->folder() / path, "of A");
  nameInB(path, "of B", "B0001");
  const std::string before = contentIn(*project_);
  const Result<MergeReport> report = tried(*project_, b_, {});
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().where, testing::HasSubstr(path));
  EXPECT_EQ(contentIn(*project_), before);
  EXPECT_EQ(bytesOf(project_->folder() / path), "of A");
  put(project_->folder() / path, "of B");
  EXPECT_TRUE(merged(*project_, b_).entered) << "the same bytes are the same file";
  everyFileIsThere();
}

TEST_F(MergedFiles, AJournalOfAStrangerMovesNothingFromOrToElsewhere) {
  put(folder_.path() / "mine.txt", "mine");
  fs::create_directories(folder_.path() / "elsewhere");
  fs::create_directory_symlink(folder_.path() / "elsewhere", project_->folder() / "batches/B0009");
  for (const auto& [to, name] :
       {std::pair("batches/B0008/mine.txt", "../../mine.txt"),
        std::pair("batches/B0009/mine.txt", "1"), std::pair("backups/mine.txt", "1")}) {
    put(project_->folder() / "merge.partial/1", "theirs");
    noteWaiting(to, name);
    EXPECT_FALSE(tried(*project_, b_, {})) << to;
    const auto again = upkeep::Project::open(project_->folder());
    EXPECT_EQ(again.has_value(), std::string_view(to).starts_with("batches/B0009/")) << to;
    if (again) {
      EXPECT_THAT(again->keptFiles(), testing::ElementsAre(to));
    }
    EXPECT_FALSE(fs::exists(project_->folder() / to)) << to;
  }
  EXPECT_EQ(bytesOf(folder_.path() / "mine.txt"), "mine");
}

TEST_F(MergedFiles, ABatchThatOnlyBComputedGetsItsResults) {
  upkeep::Project& a = *project_;
  records::BatchRecord record;
  record.number = "B0007";
  const store::BatchRow row = valueIn(Batches(a.catalogue()).add(record, anna));
  upkeep::Project cluster = copied("cluster");
  const ResultFolder two(cluster.resultsFolder("B0007"), 2);
  ASSERT_TRUE(intake::enterResults(cluster.catalogue(), cluster.folder(), row,
                                   cluster.resultsFolder("B0007"), {}, quiet, {}));
  const MergeReport report = merged(a, cluster);
  EXPECT_TRUE(report.entered);
  EXPECT_EQ(sherds::Sherds(a.catalogue()).rows(row)->size(), 2u);
  EXPECT_EQ(Batches(a.catalogue()).get(row)->state, Batches(cluster.catalogue()).get(row)->state);
  EXPECT_TRUE(fs::exists(a.resultsFolder("B0007") / "pairs.json"));
  everyFileIsThere();
}

}  // namespace
}  // namespace ostraka::merge
