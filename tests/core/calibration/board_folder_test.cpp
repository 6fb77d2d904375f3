#include "calibration/board_folder.h"

#include <gmock/gmock.h>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::calibration {
namespace {

namespace fs = std::filesystem;

// Markers that touch have no corner that could be found, and the gap is divided by.
TEST(BoardFolder, RefusesAGridWithoutGaps) {
  const TemporaryFolder board;
  const fs::path folder = board.path();
  ASSERT_TRUE(writeFileAtomically(folder / "board.json",
                                  R"({"type":"aruco_grid","dictionary":"DICT_4X4_50","markers_x":5,
                                  "markers_y":7,"marker_length":20,"marker_separation":0})")
                  .has_value());
  QuietProgress quiet;
  const auto read = readBoardFolder(folder, 1, quiet, {});
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(read.error().sentence(), testing::HasSubstr("marker_separation"));
  EXPECT_THAT(read.error().sentence(), testing::HasSubstr("board.json"));
}

// A card that a Mac wrote holds a hidden file beside each picture, which is none.
TEST(BoardFolder, ReadsThePicturesInTheOrderOfTheirNumbersAndNoHiddenFiles) {
  const TemporaryFolder board;
  const fs::path folder = board.path();
  ASSERT_TRUE(writeFileAtomically(folder / "board.json",
                                  R"({"type":"aruco_grid","dictionary":"DICT_4X4_50","markers_x":5,
                                  "markers_y":7,"marker_length":20,"marker_separation":5})")
                  .has_value());
  for (const char* name : {"p10.jpg", "p9.jpg", "._p9.jpg", "notes.txt"})
    ASSERT_TRUE(writeFileAtomically(folder / "calib" / name, "no picture").has_value());
  QuietProgress quiet;
  const auto read = readBoardFolder(folder, 1, quiet, {});
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  const std::vector<Message>& set_aside = read->at(0).set_aside;
  ASSERT_EQ(set_aside.size(), 2U);
  EXPECT_THAT(set_aside[0].english(), testing::HasSubstr("p9.jpg"));
  EXPECT_THAT(set_aside[1].english(), testing::HasSubstr("p10.jpg"));
}

}  // namespace
}  // namespace ostraka::calibration
