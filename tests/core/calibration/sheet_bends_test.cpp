#include "calibration/sheet_bends.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "files/scratch_folder.h"

namespace ostraka::calibration {
namespace {

TEST(SheetBends, ComeBackFromTheirFileBySide) {
  const ScratchFolder folder = std::move(*ScratchFolder::make("bends"));
  std::array<rig::SheetBend, 2> bends;
  bends[0].reach_mm = 182;
  bends[0].coefficients_mm[3] = -0.25;
  bends[1].reach_mm = 181;
  const auto file = folder.path() / "sheet.json";
  ASSERT_TRUE(writeBends(file, bends).has_value());
  const auto read = readBends(file);
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  for (const std::size_t side : {0U, 1U}) {
    EXPECT_EQ((*read)[side].reach_mm, bends[side].reach_mm);
    EXPECT_EQ((*read)[side].coefficients_mm, bends[side].coefficients_mm);
  }
}

TEST(SheetBends, AFileThatDescribesNoneIsNamed) {
  const ScratchFolder folder = std::move(*ScratchFolder::make("bends"));
  const auto file = folder.path() / "sheet.json";
  for (const char* text : {"{}", "[]", "3", R"({"front":{"reach":1,"coefficients":[0]}})"}) {
    ASSERT_TRUE(writeFileAtomically(file, text).has_value());
    const auto read = readBends(file);
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_EQ(read.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(read.error().sentence().english().find("sheet.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace ostraka::calibration
