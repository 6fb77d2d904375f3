// Files of plates, boards and sheets, and what they may replace.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <map>

#include "files/files.h"
#include "rig/plate_print.h"
#include "rig/printed_sheet.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::rig {
namespace {

namespace fs = std::filesystem;

class PlateFiles : public testing::Test {
 protected:
  // Everything in the folder, with its content.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_))
      all[entry.path().filename()] = *readFile(entry.path());
    return all;
  }
  void expectRefused(const PlatePrintOptions& options, const std::string& named) const {
    const auto before = files();
    const auto print = writePlatePrint(folder_ / "plate.pdf", options);
    ASSERT_FALSE(print.has_value());
    EXPECT_EQ(print.error().code, ErrorCode::UnusableInput);
    EXPECT_THAT(print.error().sentence(), testing::HasSubstr(named));
    EXPECT_EQ(files(), before);
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(PlateFiles, AreReadBackAsWritten) {
  const auto print = printPlate({});
  ASSERT_TRUE(print.has_value());
  ASSERT_TRUE(writePlate(folder_ / "plate.json", print->plate));
  ASSERT_TRUE(writeBoard(folder_ / "board.json", print->board));
  const auto plate = batch::readPlate(folder_ / "plate.json");
  ASSERT_TRUE(plate.has_value()) << plate.error().sentence();
  ASSERT_EQ(plate->markers.size(), 24U);
  EXPECT_EQ(plate->markers[7].corners[2], print->plate.markers[7].corners[2]);
  EXPECT_EQ(batch::readBoard(folder_ / "board.json")->square_mm, 22);
}

TEST_F(PlateFiles, TheSamePlateIsWrittenOnce) {
  ASSERT_TRUE(writePlatePrint(folder_ / "plate.pdf", {}).has_value());
  const auto before = files();
  EXPECT_EQ(before.size(), 3U);
  const auto written = fs::last_write_time(folder_ / "plate.json");
  const auto printed = fs::last_write_time(folder_ / "plate.pdf");
  ASSERT_TRUE(writePlatePrint(folder_ / "plate.pdf", {}).has_value());
  EXPECT_EQ(files(), before);
  EXPECT_EQ(fs::last_write_time(folder_ / "plate.json"), written);
  EXPECT_EQ(fs::last_write_time(folder_ / "plate.pdf"), printed);
}

TEST_F(PlateFiles, AMeasuredRulerIsTakenOverButNeverLost) {
  PlatePrintOptions measured;
  ASSERT_TRUE(writePlatePrint(folder_ / "plate.pdf", measured).has_value());
  const double ruler_mm = printPlate({})->ruler_mm;
  measured.ruler_measured_mm = 0.98 * ruler_mm;
  const auto print = writePlatePrint(folder_ / "plate.pdf", measured);
  ASSERT_TRUE(print.has_value()) << print.error().sentence();
  const auto plate = batch::readPlate(folder_ / "plate.json");
  EXPECT_EQ(plate->markers[7].corners[2], print->plate.markers[7].corners[2]);
  EXPECT_NEAR(batch::readBoard(folder_ / "board.json")->square_mm, 0.98 * 22, 1e-9);
  expectRefused({}, "plate.json");
  measured.ruler_measured_mm = 0.97 * ruler_mm;
  expectRefused(measured, "plate.json");
}

TEST_F(PlateFiles, WhatDescribesAnotherPlateOrBoardStays) {
  PlatePrintOptions other;
  other.diameter_mm = 250;
  ASSERT_TRUE(writePlatePrint(folder_ / "other.pdf", other).has_value());
  expectRefused({}, "plate.json");
  fs::remove(folder_ / "plate.json");
  batch::Board board = standardBoard();
  board.square_mm = 30;
  ASSERT_TRUE(writeBoard(folder_ / "board.json", board));
  expectRefused({}, "board.json");
  ASSERT_TRUE(writeFileAtomically(folder_ / "plate.json", "not a plate"));
  expectRefused({}, "plate.json");
}

TEST_F(PlateFiles, AFolderOfPhotographsGetsNoNewDescription) {
  for (const char* name : {"IMG_1.JPG", "a.tif", "a.nef"}) {
    ASSERT_TRUE(writeFileAtomically(folder_ / name, "x"));
    expectRefused({}, folder_.string());
    fs::remove(folder_ / name);
  }
  ASSERT_TRUE(writePlatePrint(folder_ / "plate.pdf", {}).has_value());
  ASSERT_TRUE(writeFileAtomically(folder_ / "a.jpg", "x"));
  EXPECT_TRUE(writePlatePrint(folder_ / "again.pdf", {}).has_value()) << "the same plate";
}

TEST_F(PlateFiles, AFullDiskLeavesNoDescriptionWithoutItsPdf) {
  PlatePrintOptions measured;
  ASSERT_TRUE(writePlatePrint(folder_ / "plate.pdf", measured).has_value());
  fs::remove(folder_ / "plate.pdf");
  const auto before = files();
  measured.ruler_measured_mm = 0.98 * printPlate({})->ruler_mm;
  struct rlimit was {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &was), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  // Room for plate.json and board.json, not for the PDF.
  struct rlimit little = was;
  little.rlim_cur = before.at("plate.json").size() + 1000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &little), 0);
  const auto full = writePlatePrint(folder_ / "plate.pdf", measured);
  const auto first = writePlatePrint(folder_ / "new" / "plate.pdf", {});
  setrlimit(RLIMIT_FSIZE, &was);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(full.has_value());
  EXPECT_EQ(full.error().code, ErrorCode::CannotWrite);
  ASSERT_FALSE(first.has_value());
  EXPECT_TRUE(fs::is_empty(folder_ / "new"));
  fs::remove(folder_ / "new");
  EXPECT_EQ(files(), before);
}

TEST_F(PlateFiles, OfASheetFollowItsMeasuredBar) {
  const fs::path pdf = folder_ / "sheet.pdf";
  ASSERT_TRUE(writeSheetPrint(pdf, {}).has_value());
  EXPECT_TRUE(readFile(pdf)->starts_with("%PDF"));
  const auto drawn = batch::readPlate(folder_ / "plate.json");
  ASSERT_TRUE(drawn.has_value());
  EXPECT_EQ(drawn->markers.size(), sheetPlate(SheetSize::A4).markers.size());
  ASSERT_TRUE(writeSheetPrint(pdf, {SheetSize::A4, 198}).has_value());
  const auto measured = batch::readPlate(folder_ / "plate.json");
  const auto side = [](const batch::Plate& plate) {
    return (plate.markers[0].corners[1] - plate.markers[0].corners[0]).norm();
  };
  EXPECT_NEAR(side(*measured), 0.99 * side(*drawn), 1e-3);
  EXPECT_NEAR(measured->sheet->sizes().x(), 0.99 * 297, 1e-9);
  // Another sheet's file is not replaced, and a bar of another unit is not believed.
  EXPECT_FALSE(writeSheetPrint(pdf, {SheetSize::A3}).has_value());
  EXPECT_FALSE(printSheet({SheetSize::A4, 20}).has_value());
}

}  // namespace
}  // namespace ostraka::rig
