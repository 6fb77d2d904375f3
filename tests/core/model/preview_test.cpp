#include "model/preview.h"

#include <gtest/gtest.h>

#include "model/model.h"
#include "shapes.h"

namespace ostraka::model {
namespace {

const PreviewOptions kSmall{.width_px = 60, .height_px = 40};

TEST(Preview, ABoxFillsThePictureUpToTheMargin) {
  TriangleMesh box = boxMesh({30, 20, 5});
  const cv::Mat picture = renderView(box, Eigen::Matrix3d::Identity(), kSmall);
  const cv::Vec3b white(255, 255, 255);
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 0), white);
  EXPECT_NE(picture.at<cv::Vec3b>(20, 30), white);
  EXPECT_NE(picture.at<cv::Vec3b>(20, 6), white);  // 30 mm over 88 % of 60 pixels: from 3.6 on
  EXPECT_EQ(picture.at<cv::Vec3b>(20, 2), white);
}

TEST(Preview, FilledPlacesShowInTheirColour) {
  TriangleMesh box = boxMesh({30, 20, 5});
  const cv::Vec3b seen = renderView(box, Eigen::Matrix3d::Identity(), kSmall).at<cv::Vec3b>(20, 30);
  box.seen.assign(8, 0);
  const cv::Vec3b filled =
      renderView(box, Eigen::Matrix3d::Identity(), kSmall).at<cv::Vec3b>(20, 30);
  EXPECT_GT(filled[2] - filled[0], 60 + seen[2] - seen[0]);  // orange
}

TEST(Preview, APictureOnTheSurfaceIsShownWithinItsTriangles) {
  TriangleMesh box = boxMesh({30, 20, 5});
  box.colors.assign(box.vertices.size(), {90, 90, 90});
  PreviewOptions painted = kSmall;
  painted.color_at = [&](const std::array<int, 3>& t, const std::array<double, 3>& w) {
    double x = 0, left = 0;
    for (std::size_t k = 0; k < 3; ++k) x += w[k] * box.vertices[t[k]].x();
    for (const Eigen::Vector3f& v : box.vertices) left += v.x() / 8.0;
    return std::abs(x - left) < 3 ? Eigen::Vector3d(200, 0, 0) : Eigen::Vector3d(0, 0, 200);
  };
  const cv::Mat picture = renderView(box, Eigen::Matrix3d::Identity(), painted);
  const auto middle = picture.at<cv::Vec3b>(20, 30), beside = picture.at<cv::Vec3b>(20, 15);
  EXPECT_GT(middle[2], 100);
  EXPECT_LT(middle[0], 5);
  EXPECT_GT(beside[0], 100);
  EXPECT_LT(beside[2], 5);
}

TEST(Preview, ThreeViewsSideBySideAreTheSameEachTime) {
  TriangleMesh box = boxMesh({30, 20, 5});
  box.normals = vertexNormals(box);
  const cv::Mat once = renderPreview(box, kSmall), again = renderPreview(box, kSmall);
  ASSERT_EQ(once.cols, 180);
  ASSERT_EQ(once.rows, 40);
  EXPECT_TRUE(std::equal(once.datastart, once.dataend, again.datastart));
  // The edge view shows the box's 5 mm only: nothing a quarter of the height above the middle.
  EXPECT_EQ(once.at<cv::Vec4b>(10, 150)[3], 0);
  EXPECT_EQ(once.at<cv::Vec4b>(20, 150)[3], 255);
}

// In a chosen row, in the dark theme and on paper the same file is shown.
TEST(Preview, HasNoGroundAndTheSherdsOwnColoursUpToItsEdge) {
  const TriangleMesh box = boxMesh({30, 20, 5});
  const cv::Mat cut = renderPreview(box, kSmall);
  int clear = 0, half = 0;
  for (int y = 0; y < cut.rows; ++y)
    for (int x = 0; x < 60; ++x) {
      const cv::Vec4b pixel = cut.at<cv::Vec4b>(y, x);
      clear += pixel[3] == 0 ? 1 : 0;
      if (pixel[3] == 0 || pixel[3] == 255) continue;
      ++half;  // of the edge: neither white nor black is mixed in
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(pixel[k], cut.at<cv::Vec4b>(20, 30)[k], 3);
    }
  EXPECT_GT(clear, 60 * 40 / 8);
  EXPECT_GT(half, 20);
}

}  // namespace
}  // namespace ostraka::model
