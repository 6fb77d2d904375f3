#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "cloud/ply.h"
#include "decisions/candidate_table.h"
#include "decisions/decisions.h"
#include "decisions/scan_folder.h"
#include "files/files.h"
#include "files/json.h"
#include "pipeline/process_batch.h"
#include "review/live_pairs.h"
#include "synthetic_out.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;

// A bar that falls back tells nobody when to come again.
class NeverBack final : public Progress {
 public:
  void begin(std::string_view, double) override { before_ = 0; }
  void report(std::int64_t done, std::int64_t total) override {
    const double now = static_cast<double>(done) / static_cast<double>(total);
    EXPECT_GE(now, before_);
    EXPECT_LE(now, 1);
    before_ = now;
  }
  void note(NoteLevel, const Message&) override {}

 private:
  double before_ = 0;
};

// Three sherds whose true pairs are known, as another scanner's files.
class ProcessScans : public testing::Test {
 protected:
  ProcessScans() {
    std::string pattern = (fs::temp_directory_path() / "ostraka_scans_XXXXXX").string();
    folder = ::mkdtemp(pattern.data());
    SyntheticOptions options;
    options.sherds = 3;
    options.swapped_look_alikes = false;
    truth = writeSyntheticOut(folder / "truth", options);
    fs::create_directories(folder / "scans");
    fs::copy(truth.output / "work/scans_front", folder / "scans/front");
    fs::copy(truth.output / "work/scans_back", folder / "scans/back");
  }
  ~ProcessScans() override { fs::remove_all(folder); }

  Result<ProcessSummary> process(const std::string& out, int threads = 2) {
    ProcessOptions options;
    options.batch = folder / "scans";
    options.output = folder / out;
    options.threads = threads;
    return processScans(options, progress, {});
  }

  fs::path folder;
  SyntheticOut truth;
  NeverBack progress;
};

TEST_F(ProcessScans, LeavesModelsPairsAndWhatTheReviewOpens) {
  const Result<ProcessSummary> summary = process("out");
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->sherds.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const SherdSummary& sherd = summary->sherds[i];
    EXPECT_EQ(sherd.front.substr(1), sherd.back.substr(1)) << "front i belongs to back i";
    EXPECT_TRUE(sherd.has_model) << sherd.remark;
    EXPECT_TRUE(fs::exists(folder / "out/sherds" / sherd.number / "model.ply"));
  }
  const auto report = readJson(folder / "out/report.json");
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->at("sherds").size(), 3u);
  EXPECT_EQ(report->at("stages").at(0).at("figures").at("files").at("f001"), "f001.ply");
  const auto live = review::LivePairs::open(folder / "out");
  ASSERT_TRUE(live.has_value()) << live.error().sentence();
  const auto picture = (*live)->picture(batch::Side::Front, 0, 0.2);
  ASSERT_TRUE(picture.has_value()) << picture.error().sentence();
  std::size_t drawn = 0;
  for (std::size_t i = 3; i < picture->rgba.size(); i += 4) drawn += picture->rgba[i] != 0;
  // A round sherd of 20 to 30 mm on its own frame covers about half of it.
  EXPECT_GT(drawn, picture->rgba.size() / 4 / 3);
  const auto view = (*live)->view(0, 0, truth.front_from_back[0]);
  ASSERT_TRUE(view.has_value());
  EXPECT_FALSE(view->front.rgba.empty());
  EXPECT_FALSE(view->back.rgba.empty());
}

// A gloss that no camera saw through leaves a hole in a face; what closes it is not measured.
TEST_F(ProcessScans, NamesAModelOfWhichMuchIsFilledIn) {
  const fs::path file = folder / "scans/front/f002.ply";
  const Result<PointCloud> whole = readPlyCloud(file);
  ASSERT_TRUE(whole.has_value());
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& p : whole->points) middle += p / static_cast<float>(whole->size());
  std::vector<int> kept;
  for (std::size_t i = 0; i < whole->size(); ++i)
    if ((whole->points[i] - middle).head<2>().norm() > 6) kept.push_back(static_cast<int>(i));
  ASSERT_LT(kept.size(), whole->size());
  ASSERT_TRUE(writePly(file, subset(*whole, kept), "plate_front").has_value());
  const Result<ProcessSummary> summary = process("out");
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->sherds.size(), 3u);
  for (const SherdSummary& sherd : summary->sherds) {
    EXPECT_TRUE(sherd.has_model) << sherd.remark;
    const bool named = sherd.remark.find("unseen by any camera") != std::string::npos;
    EXPECT_EQ(named, sherd.front == "f002") << sherd.front << ": " << sherd.remark;
  }
}

TEST_F(ProcessScans, GoesOnFromWholeStagesAndKnowsItsOwnOutput) {
  ASSERT_TRUE(process("out", 1).has_value());
  const auto first = readFile(folder / "out/pairs.json");
  ASSERT_TRUE(process("out", 3).has_value());
  EXPECT_EQ(*readFile(folder / "out/pairs.json"), *first) << "the same for any number of threads";
  const std::string log = *readFile(folder / "out/log.txt");
  EXPECT_NE(log.find("scans_front: reused from an earlier run"), std::string::npos);
  fs::create_directories(folder / "taken");
  ASSERT_TRUE(writeFileAtomically(folder / "taken/thesis.txt", "text").has_value());
  EXPECT_FALSE(process("taken").has_value());
}

// Does something when a stage begins, or at the first step within it.
class ActsAt final : public Progress {
 public:
  enum class Moment { Begin, Within };
  ActsAt(std::string stage, Moment moment, std::function<void()> act)
      : stage_(std::move(stage)), moment_(moment), act_(std::move(act)) {}
  void begin(std::string_view stage, double) override {
    current_ = stage;
    if (moment_ == Moment::Begin) step();
  }
  void report(std::int64_t, std::int64_t) override { step(); }
  void note(NoteLevel, const Message&) override {}

 private:
  void step() {
    if (current_ == stage_ && act_) std::exchange(act_, {})();
  }
  std::string stage_, current_;
  Moment moment_;
  std::function<void()> act_;
};

TEST_F(ProcessScans, SaysThatItsOutputFolderIsGoneAndIsStartedAgainFromNothing) {
  ASSERT_TRUE(process("whole").has_value());
  const std::string pairs = *readFile(folder / "whole/pairs.json");
  using Moment = ActsAt::Moment;
  const std::pair<const char*, Moment> cases[] = {{"scans of the back side", Moment::Begin},
                                                  {"pairs", Moment::Begin},
                                                  {"pairs", Moment::Within},
                                                  {"models", Moment::Within},
                                                  {"report", Moment::Begin}};
  for (const auto& [stage, moment] : cases) {
    ProcessOptions options;
    options.batch = folder / "scans";
    options.output = folder / "out";
    options.threads = 2;
    ActsAt deleting(stage, moment, [&] { fs::remove_all(options.output); });
    const Result<ProcessSummary> gone = processScans(options, deleting, {});
    ASSERT_FALSE(gone.has_value()) << stage;
    EXPECT_EQ(gone.error().code, ErrorCode::CannotWrite) << gone.error().sentence();
    EXPECT_NE(gone.error().what.english().find("The output folder is gone"), std::string::npos)
        << stage;
    EXPECT_EQ(gone.error().where, options.output.string());
    EXPECT_FALSE(fs::exists(options.output)) << stage;
  }
  ASSERT_TRUE(process("out").has_value());
  EXPECT_EQ(*readFile(folder / "out/pairs.json"), pairs);
}

TEST_F(ProcessScans, AnOutputFolderThatWasMovedGoesOnWhereItIsNow) {
  ProcessOptions options;
  options.batch = folder / "scans";
  options.output = folder / "out";
  options.threads = 2;
  ActsAt moving("models", ActsAt::Moment::Within,
                [&] { fs::rename(options.output, folder / "moved"); });
  ASSERT_FALSE(processScans(options, moving, {}).has_value());
  EXPECT_FALSE(fs::exists(options.output));
  ASSERT_TRUE(process("moved").has_value());
  const std::string log = *readFile(folder / "moved/log.txt");
  EXPECT_NE(log.find("pairs: reused from an earlier run"), std::string::npos);
}

// A hand scanner knows no plate: each scan lies anyhow in its own frame.
TEST_F(ProcessScans, ScansThatStandOnNoPlateAreTurnedFaceUp) {
  int turn = 0;
  for (const char* side : {"front", "back"})
    for (const auto& entry : fs::directory_iterator(folder / "scans" / side)) {
      PointCloud cloud = *readPlyCloud(entry.path());
      Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
      moved.rotate(
          Eigen::AngleAxisd(0.7 + 0.5 * ++turn, Eigen::Vector3d(1, 0.3, 0.2).normalized()));
      moved.translate(Eigen::Vector3d(10, 300, -50));
      ASSERT_TRUE(writePly(entry.path(), transformed(cloud, moved), "scanner").has_value());
    }
  const Result<ProcessSummary> summary = process("out");
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->sherds.size(), 3u);
  const auto laid = decisions::readScanFolder(folder / "out" / "work" / "scans_front", 1);
  ASSERT_TRUE(laid.has_value());
  std::vector<decisions::ScanRef> places;
  for (const scan::Scan& scan : laid->scans) {
    EXPECT_GT(scan.up.z(), 0.95) << scan.id;
    const decisions::ScanRef place = decisions::refOf(scan, batch::Side::Front);
    EXPECT_EQ(decisions::resolved(place, places), -1) << "a decision would take it for another";
    places.push_back(place);
  }
}

// The same chain for photographs and scans: what a person said about a side that was scanned again
// waits, and the words about the other side do not change that.
TEST_F(ProcessScans, ADecisionAboutASideThatWasTakenAgainIsNotApplied) {
  ASSERT_TRUE(process("out").has_value());
  const auto table =
      decisions::readCandidates(folder / "out" / "work" / "pairs" / "candidates.json");
  ASSERT_TRUE(table.has_value()) << table.error().sentence();
  ASSERT_EQ(table->fronts[0].photographs.size(), 64u) << "a SHA-256";
  EXPECT_NE(table->fronts[0].photographs, table->backs[0].photographs);
  decisions::PairDecision swapped;
  swapped.kind = decisions::DecisionKind::Pair;
  swapped.by = "AP";
  swapped.scans = {table->fronts[0], table->backs[1]};
  ASSERT_TRUE(decisions::appendDecision(folder / "out", swapped).has_value());
  const auto decided = process("out");
  ASSERT_TRUE(decided.has_value()) << decided.error().sentence();
  EXPECT_EQ(decided->sherds.at(0).back, table->backs[1].id);

  const fs::path back = folder / "scans/back" / "b001.ply";
  PointCloud cloud = *readPlyCloud(back);
  cloud.points.front().z() += 0.01f;
  ASSERT_TRUE(writePly(back, cloud, "plate_back").has_value());
  const auto again = process("out");
  ASSERT_TRUE(again.has_value()) << again.error().sentence();
  EXPECT_EQ(again->sherds.at(0).back, table->backs[0].id) << "the program's own";
  ASSERT_FALSE(again->warnings.empty());
  EXPECT_NE(again->warnings.front().english().find("decide again"), std::string::npos)
      << again->warnings.front();
}

TEST_F(ProcessScans, AFolderWithoutScansSaysSo) {
  fs::remove_all(folder / "scans/back");
  fs::create_directories(folder / "scans/back");
  const Result<ProcessSummary> summary = process("out");
  ASSERT_FALSE(summary.has_value());
  EXPECT_NE(summary.error().what.english().find("no PLY file"), std::string::npos);
}

}  // namespace
}  // namespace ostraka::pipeline
