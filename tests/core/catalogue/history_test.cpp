#include "catalogue/history.h"

#include <gmock/gmock.h>

#include "small_project.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

using HistoryOf = SmallProject;

TEST_F(HistoryOf, ARowIsToldNewestFirstAndWithoutWhatDidNotChange) {
  const std::int64_t before = History(catalogue()).length();
  const records::Provenance why{anna.person, "typed", "read again"};
  remember(catalogue(), why, "bag", bag4.value, "weight", "", "5");
  remember(catalogue(), why, "bag", bag4.value, "weight", "5", "5");
  remember(catalogue(), why, "bag", bag4.value, "weight", "5", "6");
  remember(catalogue(), why, "bag", bag5.value, "weight", "", "7");
  EXPECT_EQ(History(catalogue()).length(), before + 3);
  const std::vector<records::HistoryEntry> all = *History(catalogue()).of("bag", bag4.value);
  ASSERT_EQ(all.size(), 3u) << "it was begun, and weighed twice";
  EXPECT_EQ(all[0].old_value, "5");
  EXPECT_EQ(all[0].new_value, "6");
  EXPECT_EQ(all[0].source, "typed");
  EXPECT_EQ(all[0].why, "read again");
  EXPECT_EQ(all[0].by, anna.person);
  EXPECT_EQ(all[0].row, bag4.value);
  EXPECT_EQ(all[1].old_value, "");
  EXPECT_LT(all[1].at_ms, all[0].at_ms);
}

// Rows of the database tell a person nothing.
TEST_F(HistoryOf, ASherdNamesItsBatchesAndScans) {
  const store::SherdRow sherd = draft(context12);
  newBatch({bag4});
  const store::BatchRow batch = newBatch({bag4});
  const store::ScanRow front = scan(batch, batch::Side::Front, 7);
  const std::string scan_row = std::to_string(front.value), row = std::to_string(batch.value);
  remember(catalogue(), anna, "sherd", sherd.value, "front", "", scan_row);
  remember(catalogue(), anna, "sherd", sherd.value, "batch", row, "");
  remember(catalogue(), anna, "sherd", sherd.value, "note", "", row);
  remember(catalogue(), anna, "sherd", sherd.value, "back", scan_row, "4711");
  const std::vector<records::HistoryEntry> all = *History(catalogue()).of(sherd);
  ASSERT_GE(all.size(), 4u);
  EXPECT_EQ(all[0].old_value, "B0002 f007");
  EXPECT_EQ(all[0].new_value, "4711") << "a scan that is gone stays a row";
  EXPECT_EQ(all[1].new_value, row) << "a note is what it says";
  EXPECT_EQ(all[2].old_value, "B0002");
  EXPECT_EQ(all[2].new_value, "");
  EXPECT_EQ(all[3].new_value, "B0002 f007");
}

TEST(OptionalText, WritesNumbersInFullAndNothingForNone) {
  EXPECT_EQ(optionalText(std::optional<double>()), "");
  EXPECT_EQ(optionalText(std::optional(0.1)), "0.1");
  EXPECT_EQ(optionalText(std::optional(-12)), "-12");
}

}  // namespace
}  // namespace ostraka::catalogue
