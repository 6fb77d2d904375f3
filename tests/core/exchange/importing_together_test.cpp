// Two programs that import into one project at the same time, and files that it has lost.
#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "exported_project.h"
#include "records/records.h"
#include "upkeep/file_check.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using catalogue::valueIn;
using testing::Contains, testing::Each, testing::ElementsAre, testing::EndsWith, testing::HasSubstr,
    testing::Not;

class OnReport final : public Progress {
 public:
  explicit OnReport(std::function<void()> called) : called_(std::move(called)) {}
  void report(std::int64_t, std::int64_t) override { called_(); }
  void note(NoteLevel, const Message& text) override { notes.emplace_back(text.english()); }
  std::vector<std::string> notes;

 private:
  std::function<void()> called_;
};

class ImportingTogether : public ExportedProject {
 protected:
  ImportingTogether() {
    EXPECT_TRUE(exportTo("out", all));
    records::ProjectRecord record;
    record.code = "ARM";
    EXPECT_TRUE(upkeep::Project::create(at("other"), record));
  }
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  // As another program does it, with a connection of its own.
  Result<tables::ImportReport> importOnce(Progress& progress, std::stop_token stop = {}) {
    Result<upkeep::Project> into = upkeep::Project::open(at("other"));
    if (!into) return into.error();
    return readBack(*into, at("out"), tables::ImportMode::Enter, {}, progress, std::move(stop));
  }
  std::vector<upkeep::DamagedFile> damaged() {
    const upkeep::Project other = valueIn(upkeep::Project::open(at("other")));
    return valueIn(upkeep::checkFiles(other.catalogue(), other.folder(),
                                      upkeep::CheckDepth::NamesAndSizes, quiet, {}))
        .damaged;
  }
};

TEST_F(ImportingTogether, TheSecondWaitsAndFindsWhatTheFirstEntered) {
  std::atomic<bool> ended = false;
  std::optional<Result<tables::ImportReport>> second;
  std::thread other;
  OnReport waiting([] {});
  OnReport copying([&] {
    if (other.joinable() || !fs::exists(at("other/imported/out"))) return;
    other = std::thread([&] {
      second = importOnce(waiting);
      ended = true;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(500));  // longer than it takes alone
    EXPECT_FALSE(ended);
  });
  const Result<tables::ImportReport> first = importOnce(copying);
  ASSERT_TRUE(other.joinable()) << "files were copied";
  other.join();
  ASSERT_TRUE(first) << first.error().sentence();
  ASSERT_TRUE(*second) << second->error().sentence();
  EXPECT_EQ(first->fresh, 3);
  EXPECT_EQ((*second)->fresh, 0);
  EXPECT_EQ((*second)->same, 3);
  EXPECT_THAT(waiting.notes, ElementsAre(HasSubstr("Another import")));
  EXPECT_TRUE(copying.notes.empty());
  EXPECT_TRUE(damaged().empty());
}

TEST_F(ImportingTogether, OneThatIsStoppedLeavesWhatTheCatalogueNamesMeanwhile) {
  upkeep::Project elsewhere = valueIn(upkeep::Project::open(at("other")));
  const fs::path photograph = at("other/batches/B0001/front/cam0_pos00.jpg");
  std::stop_source stop;
  OnReport naming([&] {
    if (stop.stop_requested() || !fs::exists(photograph)) return;
    records::FileRecord file;
    file.path = "batches/B0001/front/cam0_pos00.jpg";
    file.sha256 = sha256("JPEG");
    file.bytes = 4;
    file.media_type = "image/jpeg";
    file.role = "photo";
    file.batch = valueIn(catalogue::Batches(elsewhere.catalogue()).add({}, {}));
    EXPECT_TRUE(catalogue::Files(elsewhere.catalogue()).save(file, {}));
    stop.request_stop();
  });
  const Result<tables::ImportReport> stopped = importOnce(naming, stop.get_token());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  EXPECT_TRUE(fs::exists(photograph));
  EXPECT_FALSE(fs::exists(at("other/imported/out")));
}

TEST_F(ImportingTogether, AnotherImportPutsBackWhatTheProjectHasLost) {
  const Result<tables::ImportReport> first = importOnce(quiet);
  ASSERT_TRUE(first) << first.error().sentence();
  EXPECT_THAT(first->warnings, Each(Not(HasSubstr("restored"))));
  ASSERT_TRUE(damaged().empty());
  fs::remove_all(at("other/imported/out"));
  fs::remove(at("other/batches/B0001/front/cam0_pos00.jpg"));
  const std::size_t missing = damaged().size();
  ASSERT_GT(missing, 1u);
  const Result<tables::ImportReport> again = importOnce(quiet);
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(again->same, 3);
  EXPECT_THAT(again->warnings, Contains(EndsWith("restored: " + std::to_string(missing) + ".")));
  EXPECT_TRUE(damaged().empty());
}

TEST_F(ImportingTogether, TakesNothingForLostThatLiesBehindALink) {
  ASSERT_TRUE(importOnce(quiet));
  const fs::path linked = at("other/batches/B0001");
  fs::rename(linked, at("another_disk"));
  fs::create_directory_symlink(at("another_disk"), linked);
  const Result<tables::ImportReport> again = importOnce(quiet);
  ASSERT_TRUE(again) << again.error().sentence();
  EXPECT_EQ(again->same, 3);
}

TEST_F(ImportingTogether, AnExportMayBeNamedAsTheLock) {
  fs::rename(at("out"), at("lock"));
  upkeep::Project into = valueIn(upkeep::Project::open(at("other")));
  const Result<tables::ImportReport> imported =
      readBack(into, at("lock"), tables::ImportMode::Enter, {}, quiet, {});
  ASSERT_TRUE(imported) << imported.error().sentence();
  EXPECT_EQ(imported->fresh, 3);
  EXPECT_TRUE(fs::is_directory(at("other/imported/lock")));
  EXPECT_TRUE(damaged().empty());
}

}  // namespace
}  // namespace ostraka::exchange
