#include "upkeep/backups.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "catalogue/history.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

using Backups = catalogue::SmallProject;

TEST_F(Backups, AreReadBackAndHoldEverything) {
  numbered(context12);
  const Result<fs::path> file = project_->backUp();
  ASSERT_TRUE(file) << file.error().sentence();
  EXPECT_FALSE(fs::exists(file->string() + ".partial"));
  fs::create_directories(folder_.path() / "restored");
  fs::copy_file(*file, folder_.path() / "restored" / "catalogue.sqlite");
  Result<Project> restored = Project::open(folder_.path() / "restored");
  ASSERT_TRUE(restored) << restored.error().sentence();
  EXPECT_TRUE(restored->catalogue().checkIntegrity());
  const store::SherdRow row = *sherds::Sherds(restored->catalogue()).byNumber("ARM1-T3-0012-0001");
  EXPECT_TRUE(row);
  EXPECT_EQ(catalogue::History(restored->catalogue()).of(row)->size(),
            catalogue::History(catalogue()).of(row)->size());
}

TEST_F(Backups, OldOnesMakeRoomForNewOnes) {
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(project_->backUp(3));
  ASSERT_EQ(project_->backups().size(), 3u);
  EXPECT_GT(project_->backups()[0], project_->backups()[1]) << "the newest first";
}

// The newer copies were made while the clock stood years ago.
TEST_F(Backups, ThoseWithTheShortestHistoryMakeRoomWhateverTheClockSaid) {
  const fs::path folder = project_->folder() / "backups";
  const fs::path first = *project_->backUp(3, 0);
  std::vector<fs::path> kept;
  for (int i = 0; i < 2; ++i) {
    numbered(context12);
    kept.push_back(folder / ("catalogue-20200101-00000" + std::to_string(i) + "-000.sqlite"));
    fs::rename(*project_->backUp(3, 0), kept.back());
  }
  numbered(context12);
  kept.push_back(*project_->backUp(3, 0));
  EXPECT_FALSE(fs::exists(first)) << "all that it contains is in each of the others";
  for (const fs::path& file : kept) EXPECT_TRUE(fs::exists(file)) << file;
}

TEST_F(Backups, ThoseWithChangesThatTheCatalogueLacksStay) {
  const fs::path early = *project_->backUp();
  numbered(context12);
  const fs::path late = *project_->backUp();
  const fs::path folder = project_->folder();
  project_.reset();
  for (const char* part : {"", "-wal", "-shm"})
    fs::remove(folder / (std::string("catalogue.sqlite") + part));
  fs::copy_file(early, folder / "catalogue.sqlite");
  project_ = std::make_unique<Project>(
      catalogue::valueIn(Project::open(folder, [this] { return now_ms += 1; })));
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(project_->backUp(1, 0));
  EXPECT_TRUE(fs::exists(late));
  EXPECT_EQ(project_->backups().size(), 2u);
}

TEST_F(Backups, TheLastOfEachDayStays) {
  constexpr std::int64_t kDay_ms = 24 * 3600 * 1000;
  std::vector<fs::path> last_of_day;
  for (int day = 0; day < 4; ++day) {
    for (int i = 0; i < 3; ++i) last_of_day.resize(1 + day, *project_->backUp(2, 3));
    last_of_day.back() = project_->backups().front();
    now_ms += kDay_ms;
  }
  const std::vector<fs::path> left = project_->backups();  // two of today, one of two days before
  ASSERT_EQ(left.size(), 4u);
  EXPECT_EQ(left[0], last_of_day[3]);
  EXPECT_EQ(left[2], last_of_day[2]);
  EXPECT_EQ(left[3], last_of_day[1]);
}

TEST_F(Backups, AreMadeOnceAnHourOfWhatWasChanged) {
  using namespace std::chrono_literals;
  EXPECT_EQ(*project_->backUpIfChanged(1h), true) << "never before";
  EXPECT_EQ(*project_->backUpIfChanged(0h), false) << "nothing changed since";
  numbered(context12);
  EXPECT_EQ(*project_->backUpIfChanged(1h), false) << "too soon";
  now_ms += 2 * 3600 * 1000;
  EXPECT_EQ(*project_->backUpIfChanged(1h), true);
  EXPECT_EQ(*project_->backUpIfChanged(0h), false);
  EXPECT_EQ(project_->backups().size(), 2u);
}

TEST_F(Backups, AreMadeOfWhatWasChangedWhileTheClockWasBehind) {
  using namespace std::chrono_literals;
  constexpr std::int64_t kHour_ms = 3600 * 1000;
  ASSERT_EQ(*project_->backUpIfChanged(1h), true);
  now_ms -= 3 * kHour_ms;
  numbered(context12);
  now_ms += 6 * kHour_ms;
  EXPECT_EQ(*project_->backUpIfChanged(1h), true);
  now_ms += 2 * kHour_ms;
  EXPECT_EQ(*project_->backUpIfChanged(1h), false) << "nothing changed since";
}

// Of a day on which the clock ran ahead, or planted.
TEST_F(Backups, ThoseOfLaterTakeNoPlaceAndComeLast) {
  const fs::path folder = project_->folder() / "backups";
  for (int day = 10; day < 30; ++day)
    fs::copy_file(project_->folder() / "catalogue.sqlite",
                  folder / ("catalogue-209901" + std::to_string(day) + "-100000-000.sqlite"));
  std::vector<fs::path> own;
  for (int i = 0; i < 3; ++i) own.push_back(*project_->backUp(3));
  const std::vector<fs::path> all = project_->backups();
  ASSERT_EQ(all.size(), 23u);
  EXPECT_EQ(std::vector<fs::path>(all.begin(), all.begin() + 3),
            std::vector<fs::path>(own.rbegin(), own.rend()));
}

// 21 November 2026, 18:15:57.123 UTC, and the first moment of 1970.
TEST(TimeStamp, SortsAsTheClockRuns) {
  EXPECT_EQ(timeStamp(1'795'284'957'123), "20261121-181557-123");
  EXPECT_EQ(timeStamp(0), "19700101-000000-000");
  EXPECT_LT(timeStamp(1'795'284'957'009), timeStamp(1'795'284'957'010));
}

}  // namespace
}  // namespace ostraka::upkeep
