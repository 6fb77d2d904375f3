#include "capture/label_code.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::capture {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

// Labels lie turned and a little blurred on grey felt, as a camera over the plate sees them.
std::string photographOf(const std::vector<std::string>& texts, int module_px) {
  cv::Mat1b picture(1000, 1600, uchar{110});
  int x = 250;
  for (const std::string& text : texts) {
    cv::Mat code, label;
    cv::QRCodeEncoder::create()->encode(text, code);
    cv::resize(code, label, {}, module_px, module_px, cv::INTER_NEAREST);
    cv::copyMakeBorder(label, label, 4 * module_px, 4 * module_px, 4 * module_px, 4 * module_px,
                       cv::BORDER_CONSTANT, 255);
    label.copyTo(picture(cv::Rect(x, 400, label.cols, label.rows)));
    x += 2 * label.cols;
  }
  cv::Mat turned;
  cv::warpAffine(picture, turned, cv::getRotationMatrix2D({800, 500}, 23, 1), picture.size(),
                 cv::INTER_LINEAR, cv::BORDER_CONSTANT, 110);
  cv::GaussianBlur(turned, turned, {}, 0.7);
  std::vector<uchar> bytes;
  cv::imencode(".jpg", turned, bytes);
  return {bytes.begin(), bytes.end()};
}

TEST(LabelCode, OfABagIsReadInAnyDirection) {
  const std::string text = "OST1:B:ARM1-T3-0012-4:7F3K9Q2M";
  for (const int module_px : {3, 4, 6}) {
    const auto codes = codesIn(photographOf({text}, module_px));
    ASSERT_TRUE(codes) << codes.error().sentence();
    EXPECT_THAT(*codes, ElementsAre(text)) << module_px;
  }
}

TEST(LabelCode, SeveralAreReadEachOnce) {
  const auto codes = codesIn(photographOf({"OST1:B:A-1-2-3:1", "OST1:B:A-1-2-4:2"}, 5));
  ASSERT_TRUE(codes);
  EXPECT_THAT(*codes, UnorderedElementsAre("OST1:B:A-1-2-3:1", "OST1:B:A-1-2-4:2"));
}

TEST(LabelCode, APictureWithoutOneHasNone) {
  const auto codes = codesIn(photographOf({}, 4));
  ASSERT_TRUE(codes);
  EXPECT_THAT(*codes, IsEmpty());
  EXPECT_FALSE(codesIn("no picture"));
}

// Every photograph of a long series would take too long, and its neighbours show the same.
TEST(LabelCode, OfASeriesThoseThatAreSpreadOverItAreLookedAt) {
  TemporaryFolder dir;
  std::vector<std::filesystem::path> series;
  for (int k = 0; k < 9; ++k) {
    series.push_back(dir.path() / ("IMG_" + std::to_string(k) + ".jpg"));
    if (k == 8) continue;  // it cannot be read
    const std::string picture = photographOf({"OST1:B:A-1-2-" + std::to_string(k) + ":1"}, 5);
    ASSERT_TRUE(writeFileAtomically(series.back(), picture));
  }
  const auto seen = codesInSome(series, 3, {});
  ASSERT_TRUE(seen);
  ASSERT_EQ(seen->size(), 3u);
  EXPECT_EQ((*seen)[0].file, series[0]);
  EXPECT_THAT((*seen)[0].texts, ElementsAre("OST1:B:A-1-2-0:1"));
  EXPECT_EQ((*seen)[1].file, series[4]);
  EXPECT_THAT((*seen)[1].texts, ElementsAre("OST1:B:A-1-2-4:1"));
  EXPECT_EQ((*seen)[2].file, series[8]);
  EXPECT_THAT((*seen)[2].texts, IsEmpty());
  const auto one = codesInSome({series[2]}, 3, {});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->size(), 1u);
  EXPECT_TRUE(codesInSome({}, 3, {})->empty());
  std::stop_source stopped;
  stopped.request_stop();
  const auto none = codesInSome(series, 3, stopped.get_token());
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace ostraka::capture
