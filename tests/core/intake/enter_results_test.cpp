#include "intake/enter_results.h"

#include <gmock/gmock.h>

#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/numbers.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "tests/core/catalogue/result_folder.h"
#include "tests/core/catalogue/small_project.h"
#include "tests/core/intake/entering.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;

// Front 3 was cut into 3 and 4, back 3 into 3 and 4; back 2 was joined to back 1.
TEST_F(Entering, TakesThePiecesThatAPersonCutAndJoined) {
  enter();
  out.places_mm.push_back({160, 0});
  out.write();
  const fs::path work = project_->resultsFolder("B0001") / "work";
  nlohmann::json candidates = {{"back_scale", 1},
                               {"has_scale", true},
                               {"supports", {{"front", nullptr}, {"back", nullptr}}},
                               {"candidates", {}}};
  const auto piece = [&](const std::string& side, const std::string& name) {
    const std::string file = "pieces_" + side + "/" + name + ".ply";
    fs::create_directories(work / ("pieces_" + side));
    fs::copy_file(work / ("scans_" + side) / (name + ".ply"), work / file);
    fs::copy_file(work / ("scans_" + side) / "stage.json", work / ("pieces_" + side) / "stage.json",
                  fs::copy_options::skip_existing);
    const double x_mm = 40.0 * (name.back() - '0');
    candidates[side + "s"].push_back({{"id", name}, {"file", file}, {"place_mm", {x_mm, 0}}});
  };
  for (const char* name : {"f001", "f002", "f003", "f004"}) piece("front", name);
  for (const char* name : {"b001", "b003", "b004"}) piece("back", name);
  fs::create_directories(work / "pairs");
  ASSERT_TRUE(writeFileAtomically(work / "pairs/candidates.json", candidates.dump()));
  out.pairs() = {{1, 1, false}, {3, 3, false}, {4, 4, false}};
  out.write();
  const EnteredResults entered = enter();
  EXPECT_EQ(entered.scans, 7);
  EXPECT_EQ(entered.models, 3);
  EXPECT_EQ(entered.open, 1) << "front 2 alone; back 2 is a part of back 1";
  ASSERT_TRUE(scanNamed("f004"));
  for (const records::ScanRecord& scan :
       catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch))) {
    const char* folder = scan.isThere() ? "work/pieces_" : "work/scans_back/";
    EXPECT_THAT(scan.path, testing::HasSubstr(folder));
  }
}

TEST_F(Entering, MakesScansDecisionsSherdsMeasurementsAndFiles) {
  const EnteredResults entered = enter();
  EXPECT_EQ(entered.scans, 6);
  EXPECT_EQ(entered.decisions, 3);
  EXPECT_EQ(entered.new_sherds, 3);
  EXPECT_EQ(entered.models, 3);
  EXPECT_EQ(entered.measurements, 24);  // 7 measures and the filled share, of 3 sherds
  EXPECT_EQ(entered.files, 18);         // 6 scans, 3 files of 3 sherds, 3 reports
  EXPECT_EQ(entered.open, 0);
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Done);
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->reprojection_px, 0.31);
  const records::SherdRecord sherd = sherds().front();
  EXPECT_EQ(sherd.context, context12);
  EXPECT_THAT(sherd.model_path, testing::MatchesRegex("models/B0001/[0-9a-f]{16}/model.ply"));
  EXPECT_EQ(fs::path(sherd.preview_path).parent_path(), fs::path(sherd.model_path).parent_path());
  EXPECT_EQ(*readFile(project_->folder() / sherd.model_path), "model of f001b001model.ply");
  EXPECT_EQ(sherd.measures.at("length"), 51);
  EXPECT_NEAR(sherd.measures.at("filled_pct"), 0.7, 1e-12);
  EXPECT_EQ(catalogue::Files(catalogue()).of(sherd.row)->size(), 3u);
  const records::ScanRecord scan = catalogue::Batches(catalogue()).scans(batch)->front();
  EXPECT_EQ(scan.points, 3);
  EXPECT_EQ(scan.plate_x_mm, 40);
  EXPECT_EQ(scan.plate_y_mm, 0);
  EXPECT_TRUE(catalogue().checkIntegrity());
}

// While a batch is computed again its results are replaced one by one, and it may stop half-way.
TEST_F(Entering, KeepsTheModelsThatWereEnteredUntilOthersAre) {
  enter();
  const records::SherdRecord before = sherds().front();
  const fs::path model = project_->folder() / before.model_path;
  out.pairs() = {{2, 2, false}, {1, 1, false}, {3, 3, false}};  // sherds/01 is another one's now
  out.length_mm = 60;
  out.write();
  EXPECT_EQ(*readFile(model), "model of f001b001model.ply");
  EXPECT_EQ(sherds::Sherds(catalogue()).get(before.row)->model_path, before.model_path);
  enter();
  const records::SherdRecord after = *sherds::Sherds(catalogue()).get(before.row);
  EXPECT_EQ(after.measures.at("length"), 61);
  EXPECT_EQ(*readFile(project_->folder() / after.model_path), "model of f001b001model.ply");
  EXPECT_EQ(after.model_path, before.model_path) << "the same bytes";
}

TEST_F(Entering, DropsModelsThatNobodyShowsAtTheNextEntering) {
  enter();
  const records::SherdRecord before = sherds().front();
  const fs::path folder = project_->resultsFolder("B0001") / "sherds/01";
  ASSERT_TRUE(writeFileAtomically(folder / "model.ply", "a better one"));
  out.noteModel(project_->resultsFolder("B0001"), "01");
  enter();
  const records::SherdRecord after = *sherds::Sherds(catalogue()).get(before.row);
  EXPECT_EQ(*readFile(project_->folder() / after.model_path), "a better one");
  EXPECT_TRUE(fs::exists(project_->folder() / before.model_path)) << "somebody may look at it";
  EXPECT_EQ(catalogue::Files(catalogue()).of(before.row)->size(), 3u) << "but they are no sherd's";
  enter();
  EXPECT_FALSE(fs::exists(project_->folder() / before.model_path));
  EXPECT_EQ(catalogue::Files(catalogue()).of(before.row)->size(), 3u);
  EXPECT_EQ(catalogue::Files(catalogue()).of(batch)->size(), 18u);
  const auto files = catalogue::Files(catalogue()).of(before.row);
  for (const records::FileRecord& file : *files)
    EXPECT_EQ(sha256(*readFile(project_->folder() / file.path)), file.sha256);
}

TEST_F(Entering, MendsAModelThatWasDamagedSince) {
  enter();
  const fs::path model = project_->folder() / sherds().front().model_path;
  ASSERT_TRUE(writeFileAtomically(model, "damaged"));
  enter();
  EXPECT_EQ(*readFile(project_->folder() / sherds().front().model_path),
            "model of f001b001model.ply");
}

TEST_F(Entering, TwiceChangesNothing) {
  enter();
  const int history = count("history"), decisions = count("pair_decision"),
            measurements = count("measurement"), files = count("file");
  const EnteredResults again = enter();
  EXPECT_EQ(again.decisions, 0);
  EXPECT_EQ(again.new_sherds, 0);
  EXPECT_EQ(count("history"), history);
  EXPECT_EQ(count("pair_decision"), decisions);
  EXPECT_EQ(count("measurement"), measurements);
  EXPECT_EQ(count("file"), files);
  EXPECT_EQ(sherds().size(), 3u);
}

TEST_F(Entering, CountsNoSherdAsNewWhosePairWasComputedAnew) {
  enter();
  for (const bool ambiguous : {true, false}) {
    for (auto& pair : out.pairs()) pair.ambiguous = ambiguous;
    out.write();
    const EnteredResults again = enter();
    EXPECT_EQ(again.decisions, 3);
    EXPECT_EQ(again.new_sherds, 0);
  }
}

TEST_F(Entering, AScaleInDoubtMarksTheProgramsMeasuresUntilItIsSettled) {
  out.scale_doubts = {"The scale is wrong: 50.00 mm measure 49.51 mm."};
  out.scale = "Scale: markers of 18 mm, as typed at the import.";
  out.write();
  enter();
  const records::BatchRecord held = *catalogue::Batches(catalogue()).get(batch);
  EXPECT_EQ(held.state, records::BatchState::Review)
      << "no pair is open, but the scale wants a person";
  EXPECT_EQ(held.scale, out.scale);
  EXPECT_EQ(linesOf(held.scale_doubts), out.scale_doubts.front());
  EXPECT_EQ(held.scale_error_pct, -0.98) << "the length that is off most";
  const store::SherdRow row = sherds().front().row;
  ASSERT_TRUE(sherds::Measurements(catalogue())
                  .add({row, "length", {}, 52.1, {}, "calliper", {}, {}}, anna));
  const records::SherdRecord sherd = *sherds::Sherds(catalogue()).get(row);
  EXPECT_TRUE(sherd.doubtful.contains("width"));
  EXPECT_TRUE(sherd.doubtful.contains("volume"));
  EXPECT_FALSE(sherd.doubtful.contains("length")) << "a calliper knows nothing of the plate";
  EXPECT_FALSE(sherd.doubtful.contains("filled_pct")) << "a share has no scale";
  EXPECT_EQ(sherds::textOf(sherd, "scale"), "doubtful");
  const store::SherdRow elsewhere = numbered(context12);
  EXPECT_EQ(found("scale:doubtful").size(), 3u);
  EXPECT_EQ(found("-scale:doubtful").size(), 1u);
  EXPECT_EQ(found("scale:*").size(), 3u);
  EXPECT_EQ(found("scale:\"\"").size(), 1u);
  EXPECT_TRUE(sherds::Sherds(catalogue()).get(elsewhere)->doubtful.empty());

  out.scale_doubts.clear();
  out.write();
  enter();
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Done);
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->scale_error_pct, -0.05);
  EXPECT_TRUE(sherds::Sherds(catalogue()).get(row)->doubtful.empty());
  EXPECT_EQ(valueOf(row, "scale"), "");
}

TEST_F(Entering, ADraftIsHeldAndItsMeasuresAreMarkedUntilItIsComputedAgain) {
  out.draft = true;
  out.write();
  enter();
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review)
      << "no pair is open";
  EXPECT_NE(linesOf(catalogue::Batches(catalogue()).get(batch)->scale_doubts).find("draft"),
            std::string::npos);
  const store::SherdRow row = sherds().front().row;
  EXPECT_TRUE(sherds::Sherds(catalogue()).get(row)->doubtful.contains("width"));
  out.draft = false;
  out.write();
  enter();
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Done);
  EXPECT_TRUE(sherds::Sherds(catalogue()).get(row)->doubtful.empty());
}

TEST_F(Entering, KeepsWhatAPersonDecided) {
  enter();
  records::PairDecision swap;
  swap.batch = batch;
  for (const auto& [front, back] : {std::pair{"f001", "b002"}, std::pair{"f002", "b001"}}) {
    swap.front = scanNamed(front);
    swap.back = scanNamed(back);
    ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(swap, anna));
  }
  const EnteredResults entered = enter();
  EXPECT_EQ(entered.kept_decisions, 2);
  EXPECT_EQ(entered.models, 1) << "the models of the other two are of pairs that do not count";
  std::vector<records::SherdRecord> all = sherds();
  EXPECT_EQ(all[0].back, scanNamed("b002"));
  EXPECT_TRUE(all[0].measures.empty());
  EXPECT_EQ(all[0].model_path, "");
  EXPECT_TRUE(catalogue::Files(catalogue()).of(all[0].row)->empty());
  // The program computes the pairs that the person chose.
  out.pairs() = {{1, 2, false}, {2, 1, false}, {3, 3, false}};
  out.write();
  EXPECT_EQ(enter().models, 3);
  all = sherds();
  EXPECT_EQ(all[0].measures.at("length"), 51);
  EXPECT_EQ(catalogue::Files(catalogue()).of(all[0].row)->size(), 3u);
}

TEST_F(Entering, ModelsComeBackWithThePairThatTheyAreOf) {
  enter();
  const auto lost = [this] { return enterLostModels(project_->folder(), "B0001", quiet, {}); };
  EXPECT_FALSE(catalogue::valueIn(lost())) << "none is";
  records::PairDecision wrong;
  wrong.batch = batch;
  wrong.front = scanNamed("f001");
  wrong.back = scanNamed("b002");
  const Result<store::DecisionRow> row = sherds::PairDecisions(catalogue()).add(wrong, anna);
  ASSERT_TRUE(row);
  records::PairDecision back = wrong;
  back.verdict = records::Verdict::Withdraw;
  back.replaces = *row;
  ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(back, anna));
  EXPECT_EQ(sherds()[0].back, scanNamed("b001"));
  EXPECT_EQ(sherds()[0].model_path, "");
  EXPECT_TRUE(catalogue::valueIn(lost()));
  for (const records::SherdRecord& sherd : sherds()) {
    EXPECT_NE(sherd.model_path, "") << sherd.front.value;
    EXPECT_FALSE(sherd.measures.empty());
  }
  EXPECT_FALSE(catalogue::valueIn(lost()));
}

TEST_F(Entering, FollowsTheProgramWhereNobodyDecided) {
  enter();
  out.pairs() = {{1, 2, false}, {2, 1, false}};
  out.write();
  const EnteredResults entered = enter();
  EXPECT_EQ(entered.decisions, 2);
  EXPECT_EQ(entered.open, 2) << "front 3 and back 3 have no partner any more";
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
  EXPECT_EQ(sherds().size(), 2u);
}

TEST_F(Entering, CountsADoubtfulPairAsOneQuestion) {
  out.pairs()[1].ambiguous = true;
  out.write();
  EXPECT_EQ(enter().open, 1);
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
  EXPECT_EQ(sherds::PairDecisions(catalogue()).current(batch)->at(1).note, "two look alike");
}

TEST_F(Entering, KeepsTheNumbersAndTheWeighing) {
  enter();
  const store::SherdRow sherd = sherds().front().row;
  ASSERT_TRUE(sherds::Numbers(catalogue()).assign(std::span(&sherd, 1), anna));
  ASSERT_TRUE(set(sherd, "weight_g", "23.4"));
  ASSERT_TRUE(set(sherd, "length_mm", "52"));
  out.length_mm = 50.01;
  out.write();
  enter();
  EXPECT_EQ(valueOf(sherd, "number"), "ARM1-T3-0012-0001");
  EXPECT_EQ(valueOf(sherd, "weight_g"), "23.4");
  EXPECT_EQ(valueOf(sherd, "length_mm"), "52") << "measured by hand: it stays";
  EXPECT_EQ(valueOf(sherds()[1].row, "length_mm"), "52.01");
}

// A mended mask brings a piece to light that comes before the others: all are numbered anew, and
// each keeps its own words, weight and number.
TEST_F(Entering, WhatWasSaidAboutAPieceStaysWithItHoweverItIsNumbered) {
  enter();
  const std::vector<records::SherdRecord> before = sherds();
  const std::vector<records::FieldChange> said = {{before[0].row, "number", "A-1"},
                                                  {before[0].row, "note", "at 40 mm"},
                                                  {before[2].row, "number", "A-3"},
                                                  {before[2].row, "note", "at 120 mm"}};
  ASSERT_TRUE(sherds::SherdChanges(catalogue()).apply(said, anna));
  records::PairDecision person;
  person.batch = batch;
  person.front = before[1].front;
  person.back = before[1].back;
  person.verdict = records::Verdict::Accept;
  ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(person, anna));

  out.places_mm = {{0, -50}, {41, 1}, {79, 0}, {120, 2}};
  out.pairs() = {{1, 1, false}, {2, 2, false}, {3, 3, false}, {4, 4, false}};
  out.write();
  enter();
  const auto noteAt = [&](double x) -> std::string {
    for (const records::ScanRecord& scan :
         catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch)))
      if (scan.side == batch::Side::Front && std::abs(*scan.plate_x_mm - x) < 5)
        for (const records::SherdRecord& sherd : sherds())
          if (sherd.front == scan.row)
            return sherd.number + ", " + sherd.note + ", " + std::to_string(scan.index);
    return "nobody";
  };
  EXPECT_EQ(noteAt(40), "A-1, at 40 mm, 2");
  EXPECT_EQ(noteAt(80), ", , 3");
  EXPECT_EQ(noteAt(120), "A-3, at 120 mm, 4");
  EXPECT_EQ(noteAt(0), ", , 1");
  EXPECT_EQ(sherds().size(), 4U);
  for (const records::PairDecision& d :
       catalogue::valueIn(sherds::PairDecisions(catalogue()).current(batch)))
    EXPECT_EQ(static_cast<bool>(d.by), d.front == before[1].front);
  const int history = count("history");
  enter();
  EXPECT_EQ(count("history"), history);

  // The piece at 40 mm is lost: its sherd keeps its number, and no other takes its place.
  out.places_mm = {{0, -50}, {79, 0}, {120, 2}};
  out.pairs() = {{1, 1, false}, {2, 2, false}, {3, 3, false}};
  out.write();
  enter();
  EXPECT_EQ(noteAt(120), "A-3, at 120 mm, 3");
  EXPECT_EQ(noteAt(40).substr(0, 14), "A-1, at 40 mm,");
  EXPECT_EQ(sherds().front().back, store::ScanRow{});
  out.places_mm = {{0, -50}, {41, 1}, {79, 0}, {120, 2}};
  out.pairs() = {{1, 1, false}, {2, 2, false}, {3, 3, false}, {4, 4, false}};
  out.write();
  enter();
  EXPECT_EQ(noteAt(40), "A-1, at 40 mm, 2");
  EXPECT_TRUE(sherds().front().back);
}

// The pieces at 40 and 70 mm are fragments of one sherd, whose mean lies 15 mm from either.
TEST_F(Entering, AJoinedPieceKeepsItsRowAndNumberAlsoWhenTheJoinIsTakenBack) {
  const auto apart = [&] {
    out.places_mm = {{40, 0}, {70, 0}, {120, 0}};
    out.pairs() = {{1, 1, false}, {2, 2, false}, {3, 3, false}};
    out.gone.clear();
    out.write();
    enter();
  };
  out.photographs = "first";
  apart();
  const records::SherdRecord before = sherds().front();
  ASSERT_TRUE(set(before.row, "number", "A-1"));
  decisions::PairDecision pair;
  pair.by = "AP";
  pair.scans = {{batch::Side::Front, "f001", {40, 0}, "first"},
                {batch::Side::Back, "b001", {40, 0}, "first"}};
  ASSERT_TRUE(decisions::appendDecision(project_->resultsFolder("B0001"), pair));
  EXPECT_EQ(enter().kept_decisions, 1);
  decisions::PairDecision join;
  join.by = "AP";
  join.kind = decisions::DecisionKind::Join;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const std::string c = side == batch::Side::Front ? "f" : "b";
    join.scans = {{side, c + "001", {40, 0}, "first"}, {side, c + "002", {70, 0}, "first"}};
    ASSERT_TRUE(decisions::appendDecision(project_->resultsFolder("B0001"), join));
  }
  out.places_mm[0] = {55, 0};
  out.gone = {2};
  out.pairs() = {{1, 1, false}, {3, 3, false}};
  out.write();
  const EnteredResults entered = enter();
  EXPECT_EQ(entered.new_sherds, 0);
  EXPECT_EQ(entered.kept_decisions, 0) << "the person's word was about the fragments";
  const records::SherdRecord joined = sherds().front();
  EXPECT_EQ(joined.number, "A-1");
  EXPECT_EQ(joined.front, before.front);
  EXPECT_EQ(joined.back, before.back);
  EXPECT_FALSE(joined.model_path.empty());
  EXPECT_EQ(sherds().size(), 2U) << "that of the other fragment was a draft";
  for (const records::ScanRecord& scan :
       catalogue::valueIn(catalogue::Batches(catalogue()).scans(batch)))
    if (scan.row == before.front) {
      EXPECT_EQ(scan.plate_x_mm, 55);
    }

  const decisions::Decisions taken =
      catalogue::valueIn(decisions::readDecisions(project_->resultsFolder("B0001")));
  for (const std::size_t i : {1, 2}) {
    decisions::PairDecision back;
    back.by = "AP";
    back.kind = decisions::DecisionKind::Withdraw;
    back.replaces = {taken.at(i).id};
    ASSERT_TRUE(decisions::appendDecision(project_->resultsFolder("B0001"), back));
  }
  apart();
  EXPECT_EQ(sherds().front().number, "A-1");
  EXPECT_EQ(sherds().front().front, before.front);
  EXPECT_TRUE(sherds().front().back);
  EXPECT_EQ(sherds().size(), 3U);
}

TEST_F(Entering, WhatWasDecidedWhileItWasComputedWantsAPerson) {
  out.photographs = "first";
  out.write();
  EXPECT_FALSE(enter().decided_meanwhile);
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Done);
  decisions::PairDecision pair;
  pair.by = "AP";
  pair.scans = {{batch::Side::Front, "f001", {40, 0}, "first"},
                {batch::Side::Back, "b002", {80, 0}, "first"}};
  ASSERT_TRUE(decisions::appendDecision(project_->resultsFolder("B0001"), pair));
  EXPECT_TRUE(enter().decided_meanwhile);
  EXPECT_EQ(catalogue::Batches(catalogue()).get(batch)->state, records::BatchState::Review);
}

TEST_F(Entering, WithoutAScaleNoLengthIsKnown) {
  out.has_scale = false;
  out.write();
  enter();
  EXPECT_TRUE(sherds().front().measures.empty());
}

TEST_F(Entering, WhatIsNotWholeEntersNothing) {
  fs::remove(project_->resultsFolder("B0001") / "report.json");
  EXPECT_FALSE(enterResults(catalogue(), project_->folder(), batch,
                            project_->resultsFolder("B0001"), {}, quiet, {}));
  out.pairs().push_back({9, 9, false});  // names a scan that is not there
  out.write();
  const Result<EnteredResults> unknown = enterResults(
      catalogue(), project_->folder(), batch, project_->resultsFolder("B0001"), {}, quiet, {});
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().what.english().find("f009"), std::string::npos);
  EXPECT_EQ(count("scan"), 0);
  EXPECT_EQ(count("sherd"), 0);
}

TEST_F(Entering, CanBeStopped) {
  std::stop_source stop;
  stop.request_stop();
  const Result<EnteredResults> stopped =
      enterResults(catalogue(), project_->folder(), batch, project_->resultsFolder("B0001"), {},
                   quiet, stop.get_token());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(count("scan"), 0);
}

// Taken back, it is nobody's word: the model that was made of it is no sherd's.
TEST_F(Entering, OfAPairThatAPersonDecidedKeepsNothingWhenItIsTakenBack) {
  enter();
  records::PairDecision decided;
  decided.batch = batch;
  decided.front = scanNamed("f001");
  decided.back = scanNamed("b002");
  const store::DecisionRow row =
      catalogue::valueIn(sherds::PairDecisions(catalogue()).add(decided, anna));
  out.pairs() = {{1, 2, false, "AP"}, {3, 3, false}};
  out.write();
  enter();
  const auto sherd = [&] {
    for (const records::SherdRecord& one : sherds())
      if (one.front == scanNamed("f001")) return one;
    return records::SherdRecord();
  };
  EXPECT_EQ(sherd().back, scanNamed("b002"));
  EXPECT_FALSE(sherd().model_path.empty());
  records::PairDecision back;
  back.batch = batch;
  back.verdict = records::Verdict::Withdraw;
  back.replaces = row;
  ASSERT_TRUE(sherds::PairDecisions(catalogue()).add(back, anna));
  EXPECT_NE(sherd().back, scanNamed("b002"));
  EXPECT_TRUE(sherd().model_path.empty());
  EXPECT_FALSE(sherd().measures.contains("length"));
  enter();  // the same results once more
  EXPECT_NE(sherd().back, scanNamed("b002"));
}

}  // namespace
}  // namespace ostraka::intake
