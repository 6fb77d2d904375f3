// Tables that are entered in portions: what is stopped, and who writes meanwhile.
#include "tables/portions.h"

#include <gmock/gmock.h>

#include <atomic>
#include <functional>
#include <thread>
#include <utility>

#include "catalogue/settings.h"
#include "tests/core/tables/import_fixture.h"

namespace ostraka::tables {
namespace {

using namespace catalogue;

TEST_F(Import, CanBeStoppedAndThenEntersNothing) {
  std::stop_source stop;
  stop.request_stop();
  const Result<ImportReport> report =
      importTable(catalogue(), kTwo, "t.csv", {ImportMode::Enter, UnknownPlaces::Refuse}, anna,
                  quiet, stop.get_token());
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, ErrorCode::Cancelled);
  EXPECT_FALSE(*sherds::Sherds(catalogue()).byNumber("ARM1-T3-0012-0001"));
}

std::string manyRows(int count) {
  std::string text = "number,site,trench,context,ware\r\n";
  for (int i = 1; i <= count; ++i)
    text += "ARM1-T3-0012-" + std::to_string(10'000 + i) + ",ARM1,T3,0012,grey\r\n";
  return text;
}

// Calls for something as soon as so many rows were read.
class At final : public Progress {
 public:
  At(std::int64_t row, std::function<void()> provenance)
      : row_(row), provenance_(std::move(provenance)) {}
  void report(std::int64_t done, std::int64_t) override {
    if (done >= row_ && provenance_) std::exchange(provenance_, nullptr)();
  }
  void note(NoteLevel, const Message&) override {}

 private:
  std::int64_t row_;
  std::function<void()> provenance_;
};

TEST_F(Import, ThatIsStoppedKeepsWholeRowsSaysSoAndGoesOn) {
  std::stop_source stop;
  At progress(64, [&] { stop.request_stop(); });
  const Result<ImportReport> part =
      importTable(catalogue(), manyRows(200), "bags.csv",
                  {ImportMode::Enter, UnknownPlaces::Refuse}, anna, progress, stop.get_token());
  ASSERT_TRUE(part) << part.error().sentence();
  EXPECT_GE(part->fresh, 64);
  EXPECT_EQ(part->not_reached, 200 - part->fresh);
  EXPECT_EQ(sherds::Sherds(catalogue()).rows({}, {})->size(),
            static_cast<std::size_t>(part->fresh));
  const auto left = unfinishedImports(catalogue());
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].source, "bags.csv");
  EXPECT_EQ(left[0].entered, part->fresh);
  EXPECT_EQ(left[0].of, 200);

  import(kTwo);
  EXPECT_EQ(unfinishedImports(catalogue()).size(), 1u) << "of another table nothing is known";
  const ImportReport rest =
      import(manyRows(200), ImportMode::Enter, UnknownPlaces::Refuse, "bags.csv");
  EXPECT_EQ(rest.same, part->fresh);
  EXPECT_EQ(rest.fresh, part->not_reached);
  EXPECT_TRUE(unfinishedImports(catalogue()).empty());
  EXPECT_TRUE(catalogue().checkIntegrity());
}

TEST_F(Import, OfTwoTablesThatBrokeOffKeepsBothInMind) {
  for (const char* file : {"a.csv", "b.csv"}) {
    std::stop_source stop;
    At progress(64, [&] { stop.request_stop(); });
    ASSERT_TRUE(importTable(catalogue(), manyRows(200), file,
                            {ImportMode::Enter, UnknownPlaces::Refuse}, anna, progress,
                            stop.get_token()));
  }
  ASSERT_EQ(unfinishedImports(catalogue()).size(), 2u);
  import(manyRows(200), ImportMode::Enter, UnknownPlaces::Refuse, "b.csv");
  ASSERT_EQ(unfinishedImports(catalogue()).size(), 1u);
  EXPECT_EQ(unfinishedImports(catalogue())[0].source, "a.csv");
  ASSERT_TRUE(forgetUnfinishedImports(catalogue()));
  EXPECT_TRUE(unfinishedImports(catalogue()).empty());
}

std::string manyContexts(int count) {
  std::string text = "site,trench,context,bag\r\n";
  for (int i = 1; i <= count; ++i) text += "ARM1,T9," + std::to_string(i) + ",1\r\n";
  return text;
}

TEST_F(Import, OfContextsThatIsStoppedKeepsWholeRowsSaysSoAndGoesOn) {
  std::stop_source stop;
  At progress(64, [&] { stop.request_stop(); });
  const Result<ImportReport> part =
      importTable(catalogue(), manyContexts(200), "contexts.csv",
                  {ImportMode::Enter, UnknownPlaces::Refuse}, anna, progress, stop.get_token());
  ASSERT_TRUE(part) << part.error().sentence();
  EXPECT_GE(part->fresh, 64);
  EXPECT_EQ(part->not_reached, 200 - part->fresh);
  ASSERT_EQ(unfinishedImports(catalogue()).size(), 1u);
  EXPECT_EQ(unfinishedImports(catalogue())[0].entered, part->fresh);

  const ImportReport rest =
      import(manyContexts(200), ImportMode::Enter, UnknownPlaces::Refuse, "contexts.csv");
  EXPECT_EQ(rest.same, part->fresh);
  EXPECT_EQ(rest.fresh, part->not_reached);
  EXPECT_TRUE(unfinishedImports(catalogue()).empty());
}

// Somebody else's decision is written while the table is entered, not after it.
bool othersWriteDuring(const std::filesystem::path& project,
                       const std::function<void(Progress&)>& work) {
  std::atomic<bool> over = false, began = false, meanwhile = false;
  std::thread other([&] {
    while (!began) std::this_thread::yield();
    Result<Catalogue> second = upkeep::Project::connect(project);
    const bool written = second && Settings(*second).setValue("a.window", "decides");
    meanwhile = written && !over;
  });
  At progress(64, [&] { began = true; });
  work(progress);
  over = true;
  began = true;
  other.join();
  return meanwhile;
}

TEST_F(Import, LetsOthersWriteMeanwhile) {
  for (const std::string& table : {manyRows(2000), manyContexts(1000)})
    EXPECT_TRUE(othersWriteDuring(project_->folder(), [&](Progress& progress) {
      const auto report =
          importTable(catalogue(), table, "t.csv", {ImportMode::Enter, UnknownPlaces::Refuse}, anna,
                      progress, {});
      ASSERT_TRUE(report);
      EXPECT_GE(report->fresh, 1000);
    }));
}

}  // namespace
}  // namespace ostraka::tables
