#include "tables/damaged_number.h"

#include <gtest/gtest.h>

namespace ostraka::tables {
namespace {

TEST(DamagedNumber, ReadsAsWhatASpreadsheetMakesOfAnother) {
  for (const char* damaged :
       {"1E+05", "1.23E+05", "1,2e+11", "01-Mar", "2-Jan", "Mar-01", "12/03/2021", "31.12.1999",
        "1. Mrz", "Mrz 01", "02-janv.", "01-mars", "02-ene", "05-Αυγ", "02.Oca", "03.Şub", "01-մրտ",
        "2-Jan-21", "03/25/2021"})
    EXPECT_TRUE(isDamagedNumber(damaged)) << damaged;
}

TEST(DamagedNumber, IsNoneThatPeopleWrite) {
  for (const char* number :
       {"",         "-",          "1",         "1.0",        "12E05",     "E+05",
        "2-E+05",   "MAR-01",     "KAS 12",    "Mar",        "Mar-A1",    "A-01-Mar-02",
        "12/03/21", "2021-03-12", "2021/7/12", "13/13/2021", "32/1/2021", "12/03/2150",
        "Jan-Feb",  "Mär-12345",  "A 3"})
    EXPECT_FALSE(isDamagedNumber(number)) << number;
}

}  // namespace
}  // namespace ostraka::tables
