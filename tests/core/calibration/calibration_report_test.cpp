#include "calibration/calibration_report.h"

#include <gtest/gtest.h>

namespace ostraka::calibration {
namespace {

TEST(CalibrateFolder, RefusesWhatIsNoFolder) {
  QuietProgress quiet;
  const auto report = calibrateFolder("/nonexistent", {}, quiet, {});
  ASSERT_FALSE(report.has_value());
  EXPECT_EQ(report.error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::calibration
