#include "drawing/drawing_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "files/checksum.h"
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
  EXPECT_FALSE(drawnAs(folder_ / "plates.pdf.txt").has_value());
  EXPECT_EQ(drawnAs(folder_ / "plates.Pdf").value(), DrawnAs::Sheets);
  EXPECT_EQ(drawnAs(folder_ / "sherd.PNG").value(), DrawnAs::Pictures);
  EXPECT_FALSE(write("sherd.png", 1).has_value());
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

std::size_t numberAt(const std::string& bytes, std::size_t at, int length, bool big_endian) {
  std::size_t number = 0;
  for (int k = 0; k < length; ++k) {
    const int from = big_endian ? k : length - 1 - k;
    number =
        number << 8 | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(from)));
  }
  return number;
}

// A short or rational value of the first directory; 0 where it is not there.
double tiffValue(const std::string& tiff, std::size_t tag) {
  const std::size_t directory = numberAt(tiff, 4, 4, false);
  for (std::size_t i = 0; i < numberAt(tiff, directory, 2, false); ++i) {
    const std::size_t entry = directory + 2 + 12 * i, kShort = 3;
    if (numberAt(tiff, entry, 2, false) != tag) continue;
    if (numberAt(tiff, entry + 2, 2, false) == kShort)
      return static_cast<double>(numberAt(tiff, entry + 8, 2, false));
    const std::size_t at = numberAt(tiff, entry + 8, 4, false);
    return static_cast<double>(numberAt(tiff, at, 4, false)) /
           static_cast<double>(numberAt(tiff, at + 4, 4, false));
  }
  return 0;
}

ViewPicture smallPicture(int dpi) {
  cv::Mat3b pixels(20, 30, cv::Vec3b(255, 255, 255));
  pixels.colRange(10, 20) = cv::Scalar(60, 110, 170);
  return {pixels, {0, 0}, dpi};
}

TEST(PictureFiles, APngStatesItsResolution) {
  for (const auto& [dpi, per_metre] : {std::pair(300, 11811u), {600, 23622u}}) {
    const ViewPicture picture = smallPicture(dpi);
    const std::string png = formatPicture(picture, "sherd.png");
    const std::size_t at = png.find("pHYs");
    ASSERT_LT(at, png.find("IDAT"));
    EXPECT_EQ(numberAt(png, at - 4, 4, true), 9u);
    EXPECT_EQ(numberAt(png, at + 4, 4, true), per_metre);
    EXPECT_EQ(numberAt(png, at + 8, 4, true), per_metre);
    EXPECT_EQ(png.at(at + 12), 1) << "per metre";
    EXPECT_EQ(numberAt(png, at + 13, 4, true), crc32(png.substr(at, 13)));
    const cv::Mat read =
        cv::imdecode(std::vector<char>(png.begin(), png.end()), cv::IMREAD_UNCHANGED);
    EXPECT_EQ(cv::norm(read, picture.pixels, cv::NORM_INF), 0);
  }
}

TEST(PictureFiles, ATiffStatesItsResolution) {
  constexpr std::size_t kXResolution = 282, kYResolution = 283, kUnit = 296;
  for (const int dpi : {300, 600}) {
    const ViewPicture picture = smallPicture(dpi);
    const std::string tiff = formatPicture(picture, "sherd.TIF");
    ASSERT_EQ(tiff.substr(0, 2), "II");
    EXPECT_EQ(tiffValue(tiff, kXResolution), dpi);
    EXPECT_EQ(tiffValue(tiff, kYResolution), dpi);
    EXPECT_EQ(tiffValue(tiff, kUnit), 2) << "inches";
    const cv::Mat read =
        cv::imdecode(std::vector<char>(tiff.begin(), tiff.end()), cv::IMREAD_UNCHANGED);
    EXPECT_EQ(cv::norm(read, picture.pixels, cv::NORM_INF), 0);
  }
}

TEST_F(Sheets, OfPicturesAreAFileForEachSherd) {
  const auto files = writePictures(folder_ / "sherd.tif", {"one", "two"});
  ASSERT_TRUE(files.has_value()) << files.error().sentence();
  EXPECT_THAT(*files, ::testing::ElementsAre(folder_ / "sherd.tif", folder_ / "sherd-2.tif"));
  EXPECT_EQ(textOf("sherd-2.tif"), "two");
  EXPECT_FALSE(writePictures(folder_ / "sherd.tif", {"one", "two"}).has_value());
  EXPECT_FALSE(writePictures(folder_ / "sherd.pdf", {"one"}).has_value());
}

}  // namespace
}  // namespace ostraka::drawing
