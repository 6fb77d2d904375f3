#include "tables/column_meanings.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace ostraka::tables {
namespace {

TEST(ColumnMeanings, NumbersHaveThreeDecimalsAtMostAndNoExponent) {
  for (const auto& [value, text] :
       {std::pair(32.833193793898516, "32.833"),
        std::pair(21.0625, "21.063"),  // a tie, exact in binary
        std::pair(-21.0625, "-21.063"), std::pair(15201.000499, "15201"), std::pair(0.1, "0.1"),
        std::pair(-0.0004, "0"), std::pair(0.0005, "0.001"), std::pair(200000.0, "200000"),
        std::pair(1234567.8912, "1234567.891")})
    EXPECT_EQ(tableNumber(value), text) << value;
}

TEST(ColumnMeanings, ATypedNumberShowsTheValueWithinHalfOfTheLastDecimal) {
  EXPECT_TRUE(showsInTable("32.833", 32.833193793898516));
  EXPECT_TRUE(showsInTable("32.8332", 32.833193793898516));
  EXPECT_TRUE(showsInTable("21.063", 21.0625));
  EXPECT_TRUE(showsInTable("21.062", 21.0625)) << "a spreadsheet rounds ties its own way";
  EXPECT_FALSE(showsInTable("32.834", 32.833193793898516));
  EXPECT_FALSE(showsInTable("32.8", 32.833193793898516)) << "somebody measured it again";
  for (const char* no_number : {"", "abc", "32.833 mm"})
    EXPECT_FALSE(showsInTable(no_number, 32.833)) << no_number;
}

// Whoever reads the export takes the unit from either.
TEST(ColumnMeanings, EachColumnIsThereOnceAndItsNameTellsItsUnit) {
  std::set<std::string_view> columns;
  for (const ColumnMeaning& one : columnMeanings()) {
    const std::string_view column = one.column;
    EXPECT_TRUE(columns.insert(column).second) << column;
    EXPECT_FALSE(std::string_view(one.meaning).empty()) << column;
    const char* unit = "";
    for (const auto& [end, of_end] :
         {std::pair("_mm", "mm"), std::pair("_mm2", "mm2"), std::pair("_mm3", "mm3"),
          std::pair("_pct", "%"), std::pair("_g", "g")})
      if (column.ends_with(end)) unit = of_end;
    EXPECT_STREQ(one.unit, unit) << column;
  }
}

}  // namespace
}  // namespace ostraka::tables
