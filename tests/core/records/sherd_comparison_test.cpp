#include "records/sherd_comparison.h"

#include <gtest/gtest.h>

namespace ostraka::records {
namespace {

Measurement measured(double value, std::optional<double> uncertainty = {}) {
  Measurement m;
  m.kind = "length";
  m.unit = "mm";
  m.value = value;
  m.uncertainty = uncertainty;
  return m;
}

TEST(SherdComparison, TheOrderOfTermsSaysNothing) {
  EXPECT_EQ(compareTexts(FieldKind::Terms, "rim; neck", "neck; rim"), Agreement::Same);
  EXPECT_EQ(compareTexts(FieldKind::Joins, "A-2; A-1", "A-1; A-2"), Agreement::Same);
  EXPECT_EQ(compareTexts(FieldKind::Terms, "rim; neck", "rim"), Agreement::Differs);
  EXPECT_EQ(compareTexts(FieldKind::Text, "rim; neck", "neck; rim"), Agreement::Differs)
      << "a sentence with a semicolon is no list";
}

TEST(SherdComparison, WhatNobodyEnteredIsNoDifference) {
  EXPECT_EQ(compareTexts(FieldKind::Text, "", "grey"), Agreement::OneBlank);
  EXPECT_EQ(compareTexts(FieldKind::Text, "", ""), Agreement::Same);
}

TEST(SherdComparison, MeasurementsDifferBeyondBothUncertaintiesTogether) {
  // hypot(0.3, 0.4) = 0.5
  EXPECT_EQ(compareMeasurements(measured(50, 0.3), measured(50.49, 0.4)),
            Agreement::WithinUncertainty);
  EXPECT_EQ(compareMeasurements(measured(50.51, 0.3), measured(50, 0.4)), Agreement::Differs);
  EXPECT_EQ(compareMeasurements(measured(50, 0.3), measured(50.31)), Agreement::Differs);
}

TEST(SherdComparison, LessThanAHundredthIsTheSame) {
  EXPECT_EQ(compareMeasurements(measured(53.929898797), measured(53.9381)), Agreement::Same);
  EXPECT_EQ(compareMeasurements(measured(53.92), measured(53.94)), Agreement::Differs);
}

}  // namespace
}  // namespace ostraka::records
