#include "records/shown_decimals.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::records {
namespace {

TEST(DecimalsShown, AreTenthsOfLengthsAndWeightsAndNoneOfAreasVolumesAndShares) {
  EXPECT_EQ(decimalsShown("mm"), 1);
  EXPECT_EQ(decimalsShown("g"), 1);
  for (const char* whole : {"mm2", "mm3", "pct"}) EXPECT_EQ(decimalsShown(whole), 0) << whole;
}

TEST(DecimalsShown, AUnitIsThatOfAKindAndOfAField) {
  EXPECT_EQ(unitOfMeasure("length"), "mm");
  EXPECT_EQ(unitOfMeasure("thickness_mean_mm"), "mm");
  EXPECT_EQ(unitOfMeasure("area_mm2"), "mm2");
  EXPECT_EQ(unitOfMeasure("rim_pct"), "pct");
  EXPECT_EQ(unitOfMeasure("note"), "");
}

TEST(DecimalsShown, HalvesAreRoundedAwayFromZeroAndNothingIsMinusZero) {
  EXPECT_EQ(shownValue(6.25, "mm"), 6.3);
  EXPECT_EQ(shownValue(-6.25, "mm"), -6.3);
  EXPECT_EQ(shownValue(11403.739, "mm3"), 11404);
  EXPECT_FALSE(std::signbit(shownValue(-0.04, "mm")));
}

TEST(DecimalsShown, AnUncertaintyIsNeverReadAsNone) {
  EXPECT_EQ(shownUncertainty(0.012, "mm"), 0.1);
  EXPECT_EQ(shownUncertainty(0.44, "mm"), 0.4);
  EXPECT_EQ(shownUncertainty(0.2, "mm3"), 1);
}

TEST(DecimalsShown, WhatCanBeEditedStaysAsItWasTyped) {
  EXPECT_EQ(decimalsEdited(78, "mm"), 1);
  EXPECT_EQ(decimalsEdited(6.25, "mm"), 2);
  EXPECT_EQ(decimalsEdited(15201.5, "mm2"), 1);
  EXPECT_EQ(decimalsEdited(53.929898797564384, "mm"), 1);
}

}  // namespace
}  // namespace ostraka::records
