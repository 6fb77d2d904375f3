// Rows that a repair collects: two sherds that bear one number, and a row that is there twice.
#include <gmock/gmock.h>

#include "catalogue/history.h"
#include "store/page_checksums.h"
#include "tests/core/catalogue/flipped_bits.h"
#include "tests/core/catalogue/small_project.h"
#include "upkeep/repair.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

class RepairNumbers : public catalogue::SmallProject {
 protected:
  void SetUp() override {
    first_ = numbered(context12);
    second_ = numbered(context12);
    for (const store::SherdRow sherd : {first_, second_}) {
      ASSERT_TRUE(set(sherd, "ware", "grey"));
      ASSERT_TRUE(set(sherd, "weight_g", "12.5"));
    }
    ASSERT_TRUE(project_->backUp());
    newer_ = numbered(context13);
  }
  fs::path folder() const { return folder_.path() / "project"; }
  fs::path file() const { return folder() / "catalogue.sqlite"; }
  // The number of the first is the second's, as the catalogue says whose it is.
  void giveTheFirstNumberToTheSecond() {
    catalogue().database().run("UPDATE sherd SET number = ? WHERE row = ?", kFirst, second_);
    catalogue().database().run("UPDATE given_number SET sherd = ? WHERE sherd = ?", second_,
                               first_);
  }
  // The words of the rows; the project is open again.
  std::vector<std::string> repaired() {
    project_.reset();
    EXPECT_FALSE(catalogue::contentOf(folder()));
    QuietProgress quiet;
    const RepairReport report =
        catalogue::valueIn(repairCatalogue(folder(), quiet, {}, [this] { return now_ms += 1; }));
    EXPECT_EQ(report.pages_lost, 0);
    EXPECT_FALSE(report.all_from_backup);
    const Result<std::string> content = catalogue::contentOf(folder());
    EXPECT_TRUE(content) << content.error().sentence();
    project_ = std::make_unique<Project>(*Project::open(folder()));
    EXPECT_EQ(sherd(newer_).number, "ARM1-T3-0013-0001") << "newer than the backup";
    std::vector<std::string> words;
    for (const RepairedRow& row : report.rows) words.push_back(row.words("").english());
    return words;
  }
  records::SherdRecord sherd(store::SherdRow row) { return *sherds::Sherds(catalogue()).get(row); }

  static constexpr const char* kFirst = "ARM1-T3-0012-0001";
  store::SherdRow first_, second_, newer_;
};

TEST_F(RepairNumbers, TheSherdToWhichANumberWasGivenKeepsItAndTheOtherLosesNothingElse) {
  const std::string id = sherd(first_).id;
  giveTheFirstNumberToTheSecond();
  EXPECT_THAT(repaired(), ElementsAre("sherd 1 (ARM1-T3-0012-0001), number: not restored; it "
                                      "belongs to sherd 2 (ARM1-T3-0012-0001)"));
  EXPECT_EQ(sherd(second_).number, kFirst);
  EXPECT_EQ(sherds::Sherds(catalogue()).byNumber(kFirst)->value, second_.value);
  EXPECT_EQ(sherd(first_).number, "");
  EXPECT_EQ(sherd(first_).state, records::SherdState::Draft);
  EXPECT_EQ(sherd(first_).id, id);
  EXPECT_EQ(valueOf(first_, "context"), "0012");
  EXPECT_EQ(valueOf(first_, "ware"), "grey");
  EXPECT_EQ(valueOf(first_, "weight_g"), "12.5");
  const records::HistoryEntry loss = catalogue::History(catalogue()).of(first_)->front();
  EXPECT_EQ(loss.field, "number");
  EXPECT_EQ(loss.old_value, kFirst);
  EXPECT_EQ(loss.new_value, "");
}

TEST_F(RepairNumbers, NoBackupIsNeededWhereEachRowCanBeRead) {
  fs::remove_all(folder() / "backups");
  giveTheFirstNumberToTheSecond();
  EXPECT_EQ(repaired().size(), 1u);
  EXPECT_EQ(sherd(first_).number, "");
  EXPECT_EQ(valueOf(first_, "ware"), "grey");
}

TEST_F(RepairNumbers, AVoidSherdThatLosesItsNumberStaysVoid) {
  ASSERT_TRUE(sherds::Sherds(catalogue()).voidSherd(first_, "a tile", anna));
  giveTheFirstNumberToTheSecond();
  EXPECT_EQ(repaired().size(), 1u);
  EXPECT_EQ(sherd(first_).number, "");
  EXPECT_EQ(sherd(first_).state, records::SherdState::Void);
  EXPECT_EQ(sherd(first_).void_reason, "a tile");
}

// The tables say it twice, and their indexes do not: what SQLite refuses was written.
TEST_F(RepairNumbers, OfARowThatADamagedIndexLetInBothAreReadAndTheFirstKeepsItsNumber) {
  project_.reset();
  constexpr char kTableLeaf = 13;
  std::string bytes = catalogue::bytesOf(file());
  for (std::size_t at = 0; at < bytes.size(); at += store::kPageBytes) {
    if (bytes[at] != kTableLeaf) continue;
    for (const std::string number : {"ARM1-T3-0012-0002", "arm1-t3-0012-0002"})
      for (std::size_t found = bytes.find(number, at); found < at + store::kPageBytes;
           found = bytes.find(number, found))
        bytes[found + number.size() - 1] = '1';
    store::storeChecksum(reinterpret_cast<unsigned char*>(&bytes[at]),
                         static_cast<std::uint32_t>(at / store::kPageBytes) + 1);
  }
  catalogue::writeBytes(file(), bytes);
  EXPECT_THAT(repaired(), UnorderedElementsAre("given_number 2: not restored",
                                               "sherd 2 (ARM1-T3-0012-0001), number: not "
                                               "restored; it belongs to sherd 1 "
                                               "(ARM1-T3-0012-0001)"));
  EXPECT_EQ(sherd(first_).number, kFirst);
  EXPECT_EQ(sherd(second_).number, "");
  EXPECT_EQ(valueOf(second_, "ware"), "grey");
  EXPECT_EQ(valueOf(second_, "weight_g"), "12.5");
}

}  // namespace
}  // namespace ostraka::upkeep
