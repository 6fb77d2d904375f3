#include "batch/photograph.h"

#include <gmock/gmock.h>

#include <new>
#include <opencv2/core.hpp>

#include "batch_folder.h"

namespace ostraka::batch {
namespace {

TEST(ReadPhotograph, GivesColoursAsStored) {
  const BatchFolder folder;
  folder.image("a.png", 5, 4);
  const auto image = readPhotograph(folder.path() / "a.png");
  ASSERT_TRUE(image.has_value());
  EXPECT_EQ(image->cols, 5);
  EXPECT_EQ(image->at<cv::Vec3b>(3, 4), cv::Vec3b(10, 20, 30));
}

TEST(ReadPhotograph, DoesNotTurnAPictureByItsExifOrientation) {
  const BatchFolder folder;
  folder.image("a.jpg", 30, 20);
  std::string bytes = folder.read("a.jpg");
  // An APP1 segment that says "turn by 90 degrees" (orientation 6), after the start marker.
  const std::string exif(
      "\xFF\xE1\0\x22"
      "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
      36);
  bytes.insert(2, exif);
  folder.write("a.jpg", bytes);
  const auto image = readPhotograph(folder.path() / "a.jpg");
  ASSERT_TRUE(image.has_value()) << image.error().sentence();
  EXPECT_EQ(image->cols, 30);
  EXPECT_EQ(image->rows, 20);
}

// 257 * v is the 16-bit value that means the same as v of 8 bits.
TEST(ReadPhotograph, TakesSixteenBitsAsEight) {
  const BatchFolder folder;
  for (const char* name : {"a.tif", "a.png"}) {
    cv::imwrite((folder.path() / name).string(),
                cv::Mat(4, 5, CV_16UC3, cv::Scalar(257 * 10, 257 * 20, 257 * 200)));
    const auto image = readPhotograph(folder.path() / name);
    ASSERT_TRUE(image.has_value()) << image.error().sentence();
    EXPECT_EQ(image->type(), CV_8UC3);
    EXPECT_EQ(image->at<cv::Vec3b>(3, 4), cv::Vec3b(10, 20, 200));
  }
}

TEST(ReadPhotograph, RefusesACutOffPicture) {
  const BatchFolder folder;
  folder.image("a.jpg", 64, 64);
  const std::string bytes = folder.read("a.jpg");
  folder.write("a.jpg", bytes.substr(0, bytes.size() * 2 / 3));
  const auto image = readPhotograph(folder.path() / "a.jpg");
  ASSERT_FALSE(image.has_value());
  EXPECT_EQ(image.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(image.error().sentence(), testing::HasSubstr("a.jpg"));
}

TEST(MakeOpenCvThrowBadAlloc, ChangesWhatIsThrownForALackOfMemoryAlone) {
  makeOpenCvThrowBadAlloc();
  EXPECT_THROW(cv::error(cv::Error::StsNoMem, "none left", "f", "a.cpp", 1), std::bad_alloc);
  EXPECT_THROW(cv::error(cv::Error::StsBadArg, "bad", "f", "a.cpp", 1), cv::Exception);
  cv::redirectError(nullptr);
}

TEST(ReadMask, KeepsLabels) {
  const BatchFolder folder;
  cv::imwrite((folder.path() / "m.png").string(), cv::Mat(3, 3, CV_8U, cv::Scalar(7)));
  const auto mask = readMask(folder.path() / "m.png");
  ASSERT_TRUE(mask.has_value());
  EXPECT_EQ(mask->type(), CV_8U);
  EXPECT_EQ(mask->at<unsigned char>(1, 1), 7);
}

TEST(HasPhotographEnding, KnowsTheFormsThatAreReadInCapitalsToo) {
  EXPECT_TRUE(hasPhotographEnding("front/CAM0_POS00.JPG"));
  EXPECT_TRUE(hasPhotographEnding("a.tiff"));
  EXPECT_TRUE(hasPhotographEnding("IMG_1234.HEIC"));
  EXPECT_FALSE(hasPhotographEnding("a.jpg.part"));
  EXPECT_FALSE(hasPhotographEnding("jpg"));
}

TEST(DecodePhotograph, RefusesWhatIsNoPictureAndNamesIt) {
  const auto image = decodePhotograph("no picture", "here.jpg");
  ASSERT_FALSE(image.has_value());
  EXPECT_EQ(image.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(image.error().sentence(), testing::HasSubstr("here.jpg"));
}

TEST(LinearLight, IsTheInverseOfTheSrgbCurve) {
  EXPECT_EQ(linearLight()[0], 0);
  EXPECT_DOUBLE_EQ(linearLight()[255], 1);
  EXPECT_NEAR(linearLight()[188], 0.5029, 1e-4);  // half the light is shown as 188
  for (std::size_t i = 1; i < 256; ++i) EXPECT_GT(linearLight()[i], linearLight()[i - 1]);
}

TEST(ReducedTo, AveragesAreasAndLeavesWhatIsSmallEnough) {
  cv::Mat1b picture = (cv::Mat1b(2, 4) << 10, 20, 0, 100, 30, 40, 0, 100);
  const cv::Mat1b small = reducedTo(picture, 2, 1);
  ASSERT_EQ(small.size(), cv::Size(2, 1));
  EXPECT_EQ(small(0, 0), 25);
  EXPECT_EQ(small(0, 1), 50);
  EXPECT_EQ(reducedTo(picture, 4, 2).data, picture.data);
  EXPECT_EQ(reducedTo(picture, 8, 4).data, picture.data);
}

}  // namespace
}  // namespace ostraka::batch
