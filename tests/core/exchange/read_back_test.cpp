#include "exchange/read_back.h"

#include <gmock/gmock.h>

#include "archive/archive.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "exported_project.h"
#include "intake/piece_decisions.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/names.h"
#include "whole_tables.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;

class ReadingBack : public ExportedProject {
 protected:
  upkeep::Project empty(const std::string& name) {
    records::ProjectRecord record;
    record.code = "ARM";
    return std::move(*upkeep::Project::create(folder_.path() / name, record));
  }
  tables::ImportReport read(upkeep::Project& into, const std::string& name) {
    return valueIn(readBack(into, folder_.path() / name, tables::ImportMode::Enter, {}, quiet, {}));
  }
  std::string joinsOf(std::size_t i) {
    return sherds::textOf(*sherds::Sherds(catalogue()).get(rows[i]), "joins");
  }
};

TEST_F(ReadingBack, GivesAnEmptyProjectTheSameRecordsAndFiles) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  const tables::ImportReport report = read(other, "out");
  EXPECT_EQ(report.fresh, 3);
  EXPECT_EQ(report.refused, 0) << (report.refusals.empty() ? "" : report.refusals[0].reason);
  for (const store::SherdRow row : rows) {
    const records::SherdRecord was = *sherds::Sherds(catalogue()).get(row);
    const store::SherdRow now_row = *sherds::Sherds(other.catalogue()).byId(was.id);
    ASSERT_TRUE(now_row) << was.number;
    const records::SherdRecord now = *sherds::Sherds(other.catalogue()).get(now_row);
    for (const records::SherdField& field : sherds::sherdFields())
      EXPECT_EQ(sherds::textOf(now, field.name), sherds::textOf(was, field.name))
          << was.number << field.name;
    EXPECT_EQ(sherds::textOf(now, "extra.drawer"), sherds::textOf(was, "extra.drawer"));
    const auto measured = *sherds::Measurements(other.catalogue()).of(now_row);
    const auto before = *sherds::Measurements(catalogue()).of(row);
    ASSERT_EQ(measured.size(), before.size());
    for (const records::Measurement& m : before)
      EXPECT_TRUE(std::any_of(measured.begin(), measured.end(), [&](const records::Measurement& n) {
        return n.kind == m.kind && n.value == m.value && n.method == m.method &&
               n.model_sha256 == m.model_sha256;
      })) << m.kind;
    EXPECT_TRUE(fs::exists(other.folder() / now.model_path));
    EXPECT_TRUE(fs::exists(other.folder() / now.preview_path));
    for (const records::FileRecord& file : valueIn(Files(other.catalogue()).of(now_row)))
      EXPECT_EQ(sha256(*readFile(other.folder() / file.path)), file.sha256) << file.path;
  }
  EXPECT_EQ(Places(other.catalogue()).contexts()->front().id,
            Places(catalogue()).context(context12)->id);
  EXPECT_EQ(Batches(other.catalogue()).byNumber("B0001")->id, Batches(catalogue()).get(batch)->id);
  EXPECT_TRUE(other.catalogue().checkIntegrity());
  // Its own export is the same again.
  ExportOptions options;
  options.target = folder_.path() / "again";
  options.forms = {Form::Json};
  options.program = "ostraka 1.0.0";
  ASSERT_TRUE(exportFolder(other.catalogue(), other.folder(),
                           *sherds::Sherds(other.catalogue()).rows(sherds::Filter{}, {}), options,
                           quiet, {}));
}

TEST_F(ReadingBack, KeepsBothVersionsOfASherdThatTwoLaptopsChanged) {
  ASSERT_TRUE(set(rows[0], "ware", "grey"));
  ASSERT_TRUE(exportTo("laptop b", all));
  ASSERT_TRUE(set(rows[0], "ware", "cooking"));
  ASSERT_TRUE(set(rows[0], "note", "mine alone"));
  const auto merge = [&] {
    return readBack(*project_, folder_.path() / "laptop b", tables::ImportMode::Enter, anna, quiet,
                    {});
  };
  const Result<tables::ImportReport> report = merge();
  ASSERT_TRUE(report) << report.error().sentence();
  EXPECT_EQ(report->same, 2);
  ASSERT_EQ(report->refusals.size(), 1u);
  EXPECT_THAT(report->refusals[0].reason, testing::HasSubstr("_in_laptop"));
  const std::string from = "_in_" + store::slug("laptop b");
  const records::SherdRecord both = *sherds::Sherds(catalogue()).get(rows[0]);
  EXPECT_EQ(both.ware, "cooking");
  EXPECT_EQ(both.note, "mine alone");
  EXPECT_EQ(sherds::textOf(both, "extra.ware" + from), "grey");
  EXPECT_FALSE(sherds::textOf(both, "extra.note" + from).empty());
  // Once more changes nothing, and it can be taken back.
  const std::int64_t history = History(catalogue()).length();
  ASSERT_TRUE(merge());
  EXPECT_EQ(History(catalogue()).length(), history);
  ASSERT_TRUE(sherds::SherdChanges(catalogue()).apply(report->undo, anna));
  EXPECT_EQ(sherds::textOf(*sherds::Sherds(catalogue()).get(rows[0]), "extra.ware" + from), "");
  ASSERT_TRUE(sherds::SherdChanges(catalogue()).apply(report->changes, anna)) << "and done again";
  EXPECT_EQ(sherds::textOf(*sherds::Sherds(catalogue()).get(rows[0]), "extra.ware" + from), "grey");
}

TEST_F(ReadingBack, KeepsBothVersionsOfFieldsOfOnesOwn) {
  ASSERT_TRUE(set(rows[1], "extra.drawn_by", "LT"));
  ASSERT_TRUE(exportTo("b", all));
  ASSERT_TRUE(set(rows[0], "extra.drawer", "8"));
  ASSERT_TRUE(set(rows[1], "extra.drawn_by", ""));
  ASSERT_TRUE(set(rows[2], "extra.shelf", "3"));
  const tables::ImportReport report = read(*project_, "b");
  EXPECT_EQ(report.same, 1) << "a field that only the project has is no difference";
  EXPECT_EQ(report.refused, 2);
  EXPECT_EQ(sherds::textOf(*sherds::Sherds(catalogue()).get(rows[0]), "extra.drawer"), "8");
  EXPECT_EQ(sherds::textOf(*sherds::Sherds(catalogue()).get(rows[0]), "extra.drawer_in_b"), "7");
  EXPECT_EQ(sherds::textOf(*sherds::Sherds(catalogue()).get(rows[1]), "extra.drawn_by_in_b"), "LT");
  const std::int64_t history = History(catalogue()).length();
  read(*project_, "b");
  EXPECT_EQ(History(catalogue()).length(), history);
}

TEST_F(ReadingBack, WhatAnotherProjectKeptOfThisOneIsNoVersionOfItsOwn) {
  ASSERT_TRUE(set(rows[0], "extra.ware_in_a", "grey"));
  ASSERT_TRUE(set(rows[0], "extra.vessel_in_a", "-"));
  ASSERT_TRUE(set(rows[0], "extra.note_in_german", "grau"));
  ASSERT_TRUE(exportTo("b", all));
  for (const char* field : {"extra.ware_in_a", "extra.vessel_in_a", "extra.note_in_german"})
    ASSERT_TRUE(set(rows[0], field, ""));
  ASSERT_TRUE(set(rows[0], "ware", "grey"));
  read(*project_, "b");
  const auto now = [&](const char* field) {
    return sherds::textOf(*sherds::Sherds(catalogue()).get(rows[0]), field);
  };
  EXPECT_EQ(now("extra.ware_in_a_in_b"), "");
  EXPECT_EQ(now("extra.vessel_in_a_in_b"), "");
  EXPECT_EQ(now("extra.note_in_german_in_b"), "grau") << "a field that only looks like one";
}

TEST_F(ReadingBack, LeavesTheJoinsOfSherdsThatStay) {
  ASSERT_TRUE(exportTo("out", {Form::Json}));
  ASSERT_TRUE(set(rows[0], "joins", "ARM1-T3-0012-0002; ARM1-T3-0012-0003"));
  read(*project_, "out");
  EXPECT_EQ(joinsOf(0), "ARM1-T3-0012-0002; ARM1-T3-0012-0003");
  EXPECT_EQ(joinsOf(2), "ARM1-T3-0012-0001");
  ASSERT_TRUE(set(rows[0], "joins", ""));
  read(*project_, "out");
  EXPECT_EQ(joinsOf(0) + joinsOf(1), "") << "what was taken away does not come back";
}

TEST_F(ReadingBack, JoinsOnlyWithTheSherdThatTheExportMeans) {
  ASSERT_TRUE(exportTo("out", {Form::Json}));
  rows = {rows[1]};
  ASSERT_TRUE(exportTo("alone", {Form::Json}));
  for (const char* name : {"out", "alone"}) {
    upkeep::Project other = empty(std::string("reads ") + name);
    ASSERT_TRUE(tables::importTable(
        other.catalogue(), "number,site,trench,context\nARM1-T3-0012-0001,ARM1,T3,0012\n", "t.csv",
        {tables::ImportMode::Enter, tables::UnknownPlaces::Make}, {}, quiet, {}));
    const tables::ImportReport report = read(other, name);
    const store::SherdRow own = *sherds::Sherds(other.catalogue()).byNumber("ARM1-T3-0012-0001");
    EXPECT_TRUE(sherds::Sherds(other.catalogue()).get(own)->joins.empty()) << name;
    ASSERT_EQ(report.warnings.size(), 1u);
    EXPECT_THAT(report.warnings[0],
                testing::HasSubstr("ARM1-T3-0012-0002 – ARM1-T3-0012-0001; enter them by hand."));
  }
}

// Two laptops with the same batch found its fourth pair, each for itself.
TEST_F(ReadingBack, ASherdOfABatchThatIsHereTakesNoScanOfIt) {
  ASSERT_TRUE(archive::archiveProject(*project_, {folder_.path() / "archive"}, quiet, {}));
  ASSERT_TRUE(
      archive::restoreProject(folder_.path() / "archive", folder_.path() / "laptop", quiet, {}));
  upkeep::Project laptop = valueIn(upkeep::Project::open(folder_.path() / "laptop"));
  for (upkeep::Project* project : {&laptop, &*project_}) {
    const ResultFolder four(project->resultsFolder("B0001"), 4);
    ASSERT_TRUE(intake::enterResults(project->catalogue(), project->folder(), batch,
                                     project->resultsFolder("B0001"), {}, quiet, {}));
    ASSERT_EQ(sherds::Sherds(project->catalogue()).rows(batch)->size(), 4u);
  }
  ExportOptions options;
  options.target = folder_.path() / "out";
  options.forms = {Form::Json};
  const std::vector<store::SherdRow> theirs = *sherds::Sherds(laptop.catalogue()).rows(batch);
  ASSERT_TRUE(exportFolder(laptop.catalogue(), laptop.folder(), theirs, options, quiet, {}));
  EXPECT_EQ(read(*project_, "out").fresh, 1);
  const auto fourth =
      sherds::Sherds(catalogue()).byId(sherds::Sherds(laptop.catalogue()).get(theirs[3])->id);
  const records::SherdRecord entered = *sherds::Sherds(catalogue()).get(*fourth);
  EXPECT_EQ(entered.batch, batch);
  EXPECT_FALSE(entered.front);
  EXPECT_TRUE(catalogue().checkIntegrity());
}

TEST_F(ReadingBack, KeepsFilesUnderTheNameOfTheExportWithASlashAtItsEndToo) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  ASSERT_TRUE(
      readBack(other, folder_.path() / "out" / "", tables::ImportMode::Enter, {}, quiet, {}));
  const store::SherdRow row =
      *sherds::Sherds(other.catalogue()).byId(sherds::Sherds(catalogue()).get(rows[0])->id);
  EXPECT_THAT(sherds::Sherds(other.catalogue()).get(row)->model_path,
              testing::StartsWith("imported/out/"));
}

TEST_F(ReadingBack, NeverTakesAnotherFileForOneOfTheExport) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  const fs::path photograph = other.folder() / "batches/B0001/front/cam0_pos00.jpg";
  put(photograph, "another JPEG");
  const auto read =
      readBack(other, folder_.path() / "out", tables::ImportMode::Enter, {}, quiet, {});
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().where, photograph);
  EXPECT_EQ(*readFile(photograph), "another JPEG");
  EXPECT_FALSE(
      *sherds::Sherds(other.catalogue()).byId(sherds::Sherds(catalogue()).get(rows[0])->id))
      << "nothing entered";
  put(photograph, "JPEG");
  EXPECT_TRUE(readBack(other, folder_.path() / "out", tables::ImportMode::Enter, {}, quiet, {}))
      << "the same file is no other one";
}

TEST_F(ReadingBack, GivesEveryTableTheSameRows) {
  // Photographs, a decision of a person that was taken back, one that stays, a lone front.
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    records::PhotographRecord p;
    p.batch = batch;
    p.side = side;
    p.camera = 'B';
    p.stop = 3;
    p.path = side == batch::Side::Front ? "batches/B0001/front/cam0_pos00.jpg"
                                        : "batches/B0001/back/cam1_pos03.jpg";
    p.serial = "12345";
    p.exif_json = R"({"iso":100})";
    p.angle_deg = 135.25;
    p.sharpness = 0.8;
    p.used = side == batch::Side::Front;
    p.reason = p.used ? "" : "blurred";
    ASSERT_TRUE(Batches(catalogue()).save(p, anna));
  }
  const auto scans = valueIn(Batches(catalogue()).scans(batch));
  records::PairDecision d;
  d.batch = batch;
  d.front = scans[0].row;
  d.back = scans[3].row;
  d.verdict = records::Verdict::Reject;
  const auto rejected = sherds::PairDecisions(catalogue()).add(d, anna);
  ASSERT_TRUE(rejected) << rejected.error().sentence();
  records::PairDecision taken_back = d;
  taken_back.verdict = records::Verdict::Withdraw;
  taken_back.replaces = *rejected;
  ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(taken_back, anna));
  d.verdict = records::Verdict::Accept;
  d.decision = "0190a0b0-0000-7000-8000-000000000001";
  d.note = "the same paint";
  ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(d, anna));
  intake::PieceDecision joined;
  joined.batch = batch;
  joined.decision = "0190a0b0-0000-7000-8000-000000000002";
  joined.pieces = {{"f001", {10, 20}}, {"f002", {30, 40}}};
  const auto join = intake::decidePieces(catalogue(), joined, anna);
  ASSERT_TRUE(join) << join.error().sentence();
  intake::PieceDecision parted;
  parted.batch = batch;
  parted.verdict = intake::PieceVerdict::Withdraw;
  parted.replaces = *join;
  ASSERT_TRUE(intake::decidePieces(catalogue(), parted, anna));
  records::BatchRecord record = *Batches(catalogue()).get(batch);
  record.operator_ = anna.person;
  record.counted = 3;
  record.scale_error_pct = 0.62;
  record.scale = "Scale: markers of 18 mm, as typed at the import.";
  record.scale_doubts = {"The scale is wrong: a length of 50 mm measures 49.69 mm."};
  ASSERT_TRUE(Batches(catalogue()).save(record, anna));
  const std::string sheet = "batches/B0001/plate.json";
  put(project_->folder() / sheet, "{}");
  ASSERT_TRUE(
      Files(catalogue())
          .save({{}, {}, sheet, sha256("{}"), "application/json", "scale", 2, {}, {}, batch},
                anna));
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  const tables::ImportReport report = read(other, "out");
  EXPECT_EQ(*readFile(other.folder() / sheet), "{}") << "what makes the scale goes along";
  for (const auto& [table, query] : kWholeTables) {
    const std::vector<std::string> before = rowsOf(catalogue(), query);
    EXPECT_FALSE(before.empty()) << table;
    EXPECT_EQ(rowsOf(other.catalogue(), query), before) << table;
  }
  EXPECT_EQ(*readFile(other.folder() / "batches/B0001/front/cam0_pos00.jpg"), "JPEG");
  EXPECT_TRUE(other.catalogue().checkIntegrity());
  // What counts is the same, too, and goes on from there.
  const auto was = *sherds::PairDecisions(catalogue()).current(batch);
  const store::BatchRow there = Batches(other.catalogue()).byNumber("B0001")->row;
  ASSERT_EQ(sherds::PairDecisions(other.catalogue()).current(there)->size(), was.size());
  read(other, "out");
  EXPECT_EQ(rowsOf(other.catalogue(), kWholeTables.at("pair_decision")),
            rowsOf(catalogue(), kWholeTables.at("pair_decision")));
}

TEST_F(ReadingBack, APersonOfTheSameInitialsStaysWhoTheyAre) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  const store::PersonRow known =
      *People(other.catalogue())
           .save(records::PersonRecord{{}, {}, "Anna Petrosyan", "AP", {}}, {});
  const tables::ImportReport report = read(other, "out");
  ASSERT_EQ(People(other.catalogue()).all()->size(), 1u);
  EXPECT_EQ(People(other.catalogue()).all()->front().row, known);
}

TEST_F(ReadingBack, APlaceOfTheSameNameIsTheSamePlace) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  records::SiteRecord own;
  own.code = "arm1";
  own.name = "The hill";
  const store::SiteRow known = *Places(other.catalogue()).save(own, {});
  const tables::ImportReport report = read(other, "out");
  EXPECT_EQ(report.fresh, 3);
  ASSERT_EQ(Places(other.catalogue()).sites()->size(), 1u);
  EXPECT_EQ(Places(other.catalogue()).contexts()->front().site, known);
}

TEST_F(ReadingBack, TwiceGivesOnceAndADifferenceStaysAsItIs) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  read(other, "out");
  const store::SherdRow row = *sherds::Sherds(other.catalogue()).byNumber("ARM1-T3-0012-0001");
  const records::FieldChange change{row, "ware", "red"};
  ASSERT_TRUE(sherds::SherdChanges(other.catalogue()).apply(std::span(&change, 1), {}));
  const tables::ImportReport again = read(other, "out");
  EXPECT_EQ(again.fresh, 0);
  EXPECT_EQ(again.same, 2);
  EXPECT_EQ(again.refused, 1);
  EXPECT_EQ(again.refusals[0].value, "ARM1-T3-0012-0001");
  EXPECT_EQ(sherds::Sherds(other.catalogue()).get(row)->ware, "red");
  EXPECT_GE(other.backups().size(), 2u) << "backed up before";
}

// Each laptop begins with B0001.
TEST_F(ReadingBack, ABatchWhoseNumberIsTakenGetsTheNextOne) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  const store::BatchRow own = *Batches(other.catalogue()).add({}, {});
  put(other.folder() / "batches/B0001/front/cam0_pos00.jpg", "of its own");
  for (int time = 0; time < 2; ++time) {
    const tables::ImportReport report = read(other, "out");
    EXPECT_EQ(report.fresh, time == 0 ? 3 : 0);
    EXPECT_EQ(report.same, time == 0 ? 0 : 3);
  }
  const std::string id = Batches(catalogue()).get(batch)->id;
  EXPECT_EQ(Batches(other.catalogue()).all()->size(), 2u);
  EXPECT_EQ(Batches(other.catalogue()).get(own)->number, "B0001");
  const records::BatchRecord entered = **Batches(other.catalogue()).byId(id);
  EXPECT_EQ(entered.number, "B0002");
  EXPECT_EQ(entered.note, "Was B0001 where it was made.");
  EXPECT_EQ(*readFile(other.folder() / "batches/B0001/front/cam0_pos00.jpg"), "of its own");
  EXPECT_EQ(*readFile(other.folder() / "batches/B0002/front/cam0_pos00.jpg"), "JPEG");
  for (const records::ScanRecord& scan : valueIn(Batches(other.catalogue()).scans(entered.row)))
    EXPECT_TRUE(scan.path.starts_with("results/B0002/")) << scan.path;
  for (const store::SherdRow row : rows) {
    const store::SherdRow there =
        *sherds::Sherds(other.catalogue()).byId(sherds::Sherds(catalogue()).get(row)->id);
    EXPECT_EQ(sherds::Sherds(other.catalogue()).get(there)->batch_number, "B0002");
    EXPECT_TRUE(
        fs::exists(other.folder() / sherds::Sherds(other.catalogue()).get(there)->model_path));
  }
  EXPECT_TRUE(other.catalogue().checkIntegrity());
}

// The same photographs were taken in on both laptops.
TEST_F(ReadingBack, ABatchWithPhotographsOfAnotherEntersOnlyWhereBothAreKept) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  ASSERT_TRUE(Batches(other.catalogue()).add({}, {}));
  put(other.folder() / "batches/B0001/front/another_name.jpg", "JPEG");
  const auto readAs = [&](tables::ImportMode mode, SamePhotographs same) {
    return readBack(other, folder_.path() / "out", mode, {}, quiet, {}, same);
  };
  const auto preview = readAs(tables::ImportMode::Preview, SamePhotographs::Refuse);
  ASSERT_TRUE(preview) << preview.error().sentence();
  ASSERT_EQ(preview->warnings.size(), 1u);
  EXPECT_THAT(preview->warnings[0], testing::HasSubstr("1 of the 1 photographs of B0002"));
  EXPECT_THAT(preview->warnings[0], testing::HasSubstr("belong to B0001, too"));
  const auto refused = readAs(tables::ImportMode::Enter, SamePhotographs::Refuse);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(Batches(other.catalogue()).all()->size(), 1u);
  EXPECT_FALSE(fs::exists(other.folder() / "batches/B0002"));
  const auto kept = readAs(tables::ImportMode::Enter, SamePhotographs::KeepBoth);
  ASSERT_TRUE(kept) << kept.error().sentence();
  EXPECT_EQ(kept->fresh, 3);
}

TEST_F(ReadingBack, ABatchWithPhotographsOfOneThatWasSetAsideEnters) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  const store::BatchRow aside = *Batches(other.catalogue()).add({}, {});
  put(other.folder() / "batches/B0001/front/another_name.jpg", "JPEG");
  ASSERT_TRUE(Batches(other.catalogue()).setState(aside, records::BatchState::Failed, {}));
  const auto entered = readBack(other, folder_.path() / "out", tables::ImportMode::Enter, {}, quiet,
                                {}, SamePhotographs::Refuse);
  EXPECT_EQ(entered->fresh, 3);
}

class Looking : public Progress {
 public:
  explicit Looking(std::function<void()> looked) : looked_(std::move(looked)) {}
  void report(std::int64_t, std::int64_t) override { looked_(); }
  void note(NoteLevel, const Message&) override {}

 private:
  std::function<void()> looked_;
};

// The next batch that is photographed gets this number, and would find photographs in its folder.
TEST_F(ReadingBack, ThatIsStoppedLeavesNoFileOfABatch) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  const fs::path photograph = other.folder() / "batches/B0001/front/cam0_pos00.jpg";
  std::stop_source stop;
  Looking stopping([&] {
    if (fs::exists(photograph)) stop.request_stop();
  });
  const Result<tables::ImportReport> report = readBack(
      other, folder_.path() / "out", tables::ImportMode::Enter, {}, stopping, stop.get_token());
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::Cancelled);
  EXPECT_FALSE(fs::exists(other.folder() / "batches/B0001"));
  EXPECT_EQ(read(other, "out").fresh, 3);
}

// Files are copied without a lock, and another window begins a batch.
TEST_F(ReadingBack, FilesLieUnderTheNumberThatIsEnteredThoughABatchIsBegunMeanwhile) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  ASSERT_TRUE(Batches(other.catalogue()).add({}, {}));
  const auto photograph = [&](const char* number) {
    return other.folder() / "batches" / number / "front" / "cam0_pos00.jpg";
  };
  Looking beginning([&] {
    if (!fs::exists(photograph("B0002")) || Batches(other.catalogue()).all()->size() != 1) return;
    EXPECT_EQ(*Batches(other.catalogue()).nextNumber(), "B0003");
    EXPECT_TRUE(Batches(other.catalogue()).add({}, {}));
  });
  const Result<tables::ImportReport> report =
      readBack(other, folder_.path() / "out", tables::ImportMode::Enter, {}, beginning, {});
  ASSERT_TRUE(report) << report.error().sentence();
  EXPECT_EQ(report->fresh, 3);
  const records::BatchRecord entered =
      **Batches(other.catalogue()).byId(Batches(catalogue()).get(batch)->id);
  EXPECT_EQ(entered.number, "B0002");
  EXPECT_EQ(*readFile(photograph("B0002")), "JPEG");
  EXPECT_FALSE(fs::exists(other.folder() / "batches/B0003")) << "it is another batch's folder";
  for (const store::SherdRow row : rows) {
    const store::SherdRow there =
        *sherds::Sherds(other.catalogue()).byId(sherds::Sherds(catalogue()).get(row)->id);
    EXPECT_TRUE(
        fs::exists(other.folder() / sherds::Sherds(other.catalogue()).get(there)->model_path));
  }
  EXPECT_TRUE(other.catalogue().checkIntegrity());
}

TEST_F(ReadingBack, APreviewChangesNothing) {
  ASSERT_TRUE(exportTo("out", all));
  upkeep::Project other = empty("other");
  const Result<tables::ImportReport> preview =
      readBack(other, folder_.path() / "out", tables::ImportMode::Preview, {}, quiet, {});
  ASSERT_TRUE(preview) << preview.error().sentence();
  EXPECT_EQ(preview->fresh, 3);
  EXPECT_TRUE(Places(other.catalogue()).contexts()->empty());
  EXPECT_FALSE(fs::exists(other.folder() / "imported"));
}

TEST_F(ReadingBack, NothingEntersWhenAFileWasChanged) {
  ASSERT_TRUE(exportTo("out", all));
  put(folder_.path() / "out/data/models/ARM1-T3-0012-0002.ply", "changed");
  upkeep::Project other = empty("other");
  const Result<tables::ImportReport> report =
      readBack(other, folder_.path() / "out", tables::ImportMode::Enter, {}, quiet, {});
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().sentence().english().find("changed since the export"),
            std::string::npos);
  EXPECT_TRUE(sherds::Sherds(other.catalogue()).rows(sherds::Filter{}, {})->empty());
}

}  // namespace
}  // namespace ostraka::exchange
