// What a GRBL controller says, and what that means for a person.
#include <gmock/gmock.h>

#include "turntables/grbl.h"

namespace ostraka::turntables {
namespace {

TEST(ParseGrblReport, ReadsWhatControllersWrite) {
  const auto report = parseGrblReport("<Hold:0|WPos:12.500,0.000,0.000|Bf:15,128|Ov:100,100,100>");
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->state, "Hold:0");
  EXPECT_EQ(report->work, 12.5);
  EXPECT_FALSE(report->machine.has_value());
  for (const char* bad : {"", "<", "<Idle", "<Idle|MPos:x>", "<I#le|MPos:1>", "Idle|MPos:1>",
                          "<Idle|MPos:1.0.0>", "<Idle|MPos:1<Idle|MPos:1>", "<Idle|MPos:nan>"})
    EXPECT_FALSE(parseGrblReport(bad).has_value()) << bad;
}

TEST(GrblTrouble, SaysWhatToDo) {
  EXPECT_THAT(*grblTrouble("ALARM:1"), testing::HasSubstr("align the zero mark"));
  EXPECT_THAT(*grblTrouble("error:9"), testing::HasSubstr("home it or unlock it"));
  EXPECT_THAT(*grblTrouble("error:33"), testing::HasSubstr("(error:33)"));
  EXPECT_FALSE(grblTrouble("error:x").has_value());
  EXPECT_FALSE(grblTrouble("ok").has_value());
}

}  // namespace
}  // namespace ostraka::turntables
