#include "drawing/drawing_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::drawing {
namespace {

namespace fs = std::filesystem;

class Sheets : public ::testing::Test {
 protected:
  Result<std::vector<fs::path>> write(const char* name, std::size_t pages) const {
    return writeSheets(folder_ / name, std::vector<Page>(pages, Page{210, 297, {}}));
  }
  std::string textOf(const char* name) const {
    const auto bytes = readFile(folder_ / name);
    return bytes ? *bytes : "none";
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "sheets";
};

TEST_F(Sheets, AreAFileEachInSvgAndOneInPdf) {
  const auto svg = write("plates.svg", 3);
  ASSERT_TRUE(svg.has_value()) << svg.error().what;
  EXPECT_THAT(*svg, ::testing::ElementsAre(folder_ / "plates.svg", folder_ / "plates-2.svg",
                                           folder_ / "plates-3.svg"));
  const auto pdf = write("plates.pdf", 3);
  ASSERT_TRUE(pdf.has_value());
  EXPECT_THAT(*pdf, ::testing::ElementsAre(folder_ / "plates.pdf"));
  EXPECT_TRUE(write("plates.pdf", 1).has_value());
}

TEST_F(Sheets, TakeTheNameOfNoOtherFile) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "model.ply", "a model").has_value());
  const auto refused = write("model.ply", 1);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(refused.error().where, (folder_ / "model.ply").string());
  EXPECT_EQ(textOf("model.ply"), "a model");
  EXPECT_FALSE(checkSheetsFile(folder_ / "plates.pdf.txt").has_value());
  EXPECT_TRUE(checkSheetsFile(folder_ / "plates.Pdf").has_value());
}

// Who was asked, was asked for plates.svg alone.
TEST_F(Sheets, OverwriteNoFurtherSheetAndLeaveNoneOfALongerRun) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "plates-2.svg", "another's").has_value());
  for (const std::size_t pages : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
    const auto refused = write("plates.svg", pages);
    ASSERT_FALSE(refused.has_value()) << pages;
    EXPECT_EQ(refused.error().where, (folder_ / "plates-2.svg").string());
  }
  EXPECT_EQ(textOf("plates-2.svg"), "another's");
  EXPECT_FALSE(fs::exists(folder_ / "plates.svg"));
  fs::rename(folder_ / "plates-2.svg", folder_ / "plates-3.svg");
  EXPECT_FALSE(write("plates.svg", 2).has_value());
  EXPECT_FALSE(fs::exists(folder_ / "plates-2.svg"));
  EXPECT_TRUE(write("plates.svg", 1).has_value());
  EXPECT_TRUE(write("plates.svg", 1).has_value());  // asked for by its name
}

// The name of the tenth is too long.
TEST_F(Sheets, ThatCannotAllBeWrittenLeaveNoneInTheWayOfTheNextTry) {
  std::string stem(250, 'x');
  while (!write((stem + ".svg").c_str(), 2)) stem.pop_back();
  fs::remove_all(folder_);
  ASSERT_FALSE(write((stem + ".svg").c_str(), 10).has_value());
  EXPECT_FALSE(fs::exists(folder_ / (stem + "-2.svg")));
  EXPECT_FALSE(fs::exists(folder_ / (stem + "-9.svg")));
  EXPECT_TRUE(write((stem + ".svg").c_str(), 9).has_value());
}

}  // namespace
}  // namespace ostraka::drawing
