#include "calibration/board_folder.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include "files/files.h"

namespace ostraka::calibration {
namespace {

namespace fs = std::filesystem;

// Markers that touch have no corner that could be found, and the gap is divided by.
TEST(BoardFolder, RefusesAGridWithoutGaps) {
  const fs::path folder = fs::temp_directory_path() / (std::to_string(::getpid()) + "-grid");
  ASSERT_TRUE(writeFileAtomically(folder / "board.json",
                                  R"({"type":"aruco_grid","dictionary":"DICT_4X4_50","markers_x":5,
                                  "markers_y":7,"marker_length":20,"marker_separation":0})")
                  .has_value());
  QuietProgress quiet;
  const auto read = readBoardFolder(folder, 1, quiet, {});
  fs::remove_all(folder);
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(read.error().sentence(), testing::HasSubstr("marker_separation"));
  EXPECT_THAT(read.error().sentence(), testing::HasSubstr("board.json"));
}

}  // namespace
}  // namespace ostraka::calibration
