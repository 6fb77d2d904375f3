#include "review/orthophoto.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace ostraka::review {
namespace {

// A camera 400 mm above the plate that looks straight down: f = 1000 px, so that 1 mm on the plate
// is 2.5 px and 1 mm on a plane 80 mm above it 3.125 px. +x of the plate is +x of the picture, +y
// goes up in both; the plate's origin shows at (200, 150).
class StraightDown : public testing::Test {
 protected:
  StraightDown() {
    image.intrinsics.width = 400;
    image.intrinsics.height = 300;
    image.intrinsics.fx = image.intrinsics.fy = 1000;
    image.intrinsics.cx = 200;
    image.intrinsics.cy = 150;
    image.camera_from_plate.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
    image.camera_from_plate.translation() = Eigen::Vector3d(0, 0, 400);
    photograph.create(300, 400, CV_8UC3);
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 400; ++x)
        photograph.at<cv::Vec3b>(y, x) = {static_cast<std::uint8_t>(x / 2),
                                          static_cast<std::uint8_t>(y / 2), 77};
  }
  // A square of this half width around the origin, a point each half millimetre.
  static std::vector<Eigen::Vector3f> square(float half_mm, float height_mm) {
    std::vector<Eigen::Vector3f> points;
    for (float x = -half_mm; x <= half_mm; x += 0.5F)
      for (float y = -half_mm; y <= half_mm; y += 0.5F) points.emplace_back(x, y, height_mm);
    return points;
  }
  // Where a pixel of the picture shows the photograph, by its colours: to a pixel or two.
  static Eigen::Vector2d shownAt(const Picture& picture, int column, int row) {
    const std::uint8_t* rgba =
        &picture.rgba[4 * (static_cast<std::size_t>(row) * picture.width + column)];
    return {2.0 * rgba[2], 2.0 * rgba[1]};
  }
  static int alphaAt(const Picture& picture, int column, int row) {
    return picture.rgba[4 * (static_cast<std::size_t>(row) * picture.width + column) + 3];
  }
  Picture made(const std::vector<Eigen::Vector3f>& points, Facing facing = Facing::Up,
               const cv::Mat1b& mask = {}) const {
    return orthophoto(photograph, mask, image, points, Eigen::Isometry3d::Identity(), facing,
                      frame);
  }
  rig::PosedImage image;
  cv::Mat photograph;
  const PictureFrame frame{{-30, -20}, 0.5, 120, 80};  // 60 x 40 mm around the origin
};

TEST_F(StraightDown, TakesEachPixelFromWhereTheScanIsThere) {
  for (const float height : {0.0F, 80.0F}) {
    const double px_per_mm = 1000 / (400 - height);
    const Picture picture = made(square(25, height));
    ASSERT_EQ(picture.width, 120);
    ASSERT_EQ(picture.height, 80);
    ASSERT_EQ(picture.rgba.size(), 4U * 120 * 80);
    for (const auto& [column, row] : {std::pair(60, 40), {20, 40}, {99, 10}, {35, 70}}) {
      const Eigen::Vector2d mm = frame.at(column, row);
      const Eigen::Vector2d expected(200 + px_per_mm * mm.x(), 150 - px_per_mm * mm.y());
      EXPECT_LT((shownAt(picture, column, row) - expected).cwiseAbs().maxCoeff(), 2.1)
          << height << " mm, " << column << ", " << row;
      EXPECT_EQ(alphaAt(picture, column, row), 255);
    }
  }
}

TEST_F(StraightDown, KeepsRedAndBlueApart) {
  const Picture picture = made(square(25, 0));
  EXPECT_EQ(picture.rgba[4 * (40 * 120 + 60)], 77);
}

TEST_F(StraightDown, IsTransparentBesideTheScanAndWhereTheMaskSaysBackground) {
  const Picture picture = made(square(10, 0));
  EXPECT_EQ(alphaAt(picture, 60, 40), 255);
  EXPECT_EQ(alphaAt(picture, 60 + 2 * 15, 40), 0);  // 15 mm from the middle
  EXPECT_EQ(alphaAt(picture, 60, 5), 0);
  cv::Mat1b mask(300, 400, std::uint8_t{255});
  mask.colRange(200, 400) = std::uint8_t{0};
  const Picture cut = made(square(10, 0), Facing::Up, mask);
  EXPECT_EQ(alphaAt(cut, 60 - 10, 40), 255);
  EXPECT_EQ(alphaAt(cut, 60 + 10, 40), 0);
  const Picture other_size = made(square(10, 0), Facing::Up, cv::Mat1b(10, 10, std::uint8_t{0}));
  EXPECT_EQ(alphaAt(other_size, 60, 40), 255) << "a mask of another photograph cuts nothing";
}

// Of a wall 80 mm thick the upper face is seen from above, the lower from below.
TEST_F(StraightDown, LooksUpTheFaceThatIsAskedFor) {
  std::vector<Eigen::Vector3f> wall = square(25, 80);
  const std::vector<Eigen::Vector3f> lower = square(25, 0);
  wall.insert(wall.end(), lower.begin(), lower.end());
  EXPECT_NEAR(shownAt(made(wall), 100, 40).x(), 200 + 3.125 * 20.25, 2.1);
  EXPECT_NEAR(shownAt(made(wall, Facing::Down), 100, 40).x(), 200 + 2.5 * 20.25, 2.1);
}

TEST_F(StraightDown, IsNoPictureOfNothing) {
  EXPECT_TRUE(made({}).rgba.empty());
  EXPECT_TRUE(
      orthophoto({}, {}, image, square(5, 0), Eigen::Isometry3d::Identity(), Facing::Up, frame)
          .rgba.empty());
  EXPECT_TRUE(
      orthophoto(photograph, {}, image, square(5, 0), Eigen::Isometry3d::Identity(), Facing::Up, {})
          .rgba.empty());
}

TEST(FrameAround, HoldsThePointsAndTheMarginInWholePixels) {
  const std::vector<Eigen::Vector3f> points = {{1, 2, 9}, {11, 5, -9}, {4, 3.1F, 0}};
  const PictureFrame frame = frameAround(points, 0.4, 3);
  EXPECT_TRUE(frame.low_mm.isApprox(Eigen::Vector2d(-2, -1), 1e-9));
  EXPECT_EQ(frame.width, 40);   // 16 mm
  EXPECT_EQ(frame.height, 23);  // 9 mm: 22.5
  EXPECT_TRUE(frame.at(0, 22).isApprox(Eigen::Vector2d(-1.8, -0.8), 1e-9)) << "low left";
  EXPECT_TRUE(frame.at(39, 0).isApprox(Eigen::Vector2d(13.8, 8.0), 1e-9)) << "high right";
}

TEST(FrameAround, OfAnOutlierFarAwayIsAMetreAtMost) {
  const std::vector<Eigen::Vector3f> points = {{0, 0, 0}, {1e7F, 10, 0}};
  const PictureFrame frame = frameAround(points, 0.5, 1);
  EXPECT_EQ(frame.width, 2000);
  EXPECT_EQ(frame.height, 24);
  EXPECT_EQ(frameAround({}, 0.5, 1).width, 0);
}

class PointsOnly : public testing::Test {
 protected:
  PointsOnly() {
    // Four millimetres apart, the lower red and facing down, the upper green and facing up.
    cloud.points = {{5, 5, 0}, {5, 5, 4}};
    cloud.normals = {{0, 0, -1}, {0, 0, 1}};
    cloud.colors = {{200, 0, 0}, {0, 100, 0}};
  }
  std::array<int, 4> at(const Picture& picture, int column, int row) const {
    const std::size_t k = 4 * (static_cast<std::size_t>(row) * picture.width + column);
    return {picture.rgba[k], picture.rgba[k + 1], picture.rgba[k + 2], picture.rgba[k + 3]};
  }
  Picture made(Facing facing) const {
    return pointPicture(cloud, Eigen::Isometry3d::Identity(), facing, frame);
  }
  PointCloud cloud;
  const PictureFrame frame{{0, 0}, 0.25, 40, 40};
};

TEST_F(PointsOnly, ShowTheFaceThatIsTurnedToTheViewer) {
  // Pixel (20, 19) begins at 5 mm, 5 mm.
  EXPECT_EQ(at(made(Facing::Up), 20, 19), (std::array<int, 4>{0, 100, 0, 255}));
  EXPECT_EQ(at(made(Facing::Down), 20, 19), (std::array<int, 4>{200, 0, 0, 255}));
  EXPECT_EQ(at(made(Facing::Up), 21, 20)[3], 255) << "a point fills the gap to its neighbours";
  EXPECT_EQ(at(made(Facing::Up), 23, 19)[3], 0);
}

TEST_F(PointsOnly, OfTwoThatFaceTheViewerTheNearerIsSeen) {
  cloud.normals = {{0, 0, 1}, {0, 0, 1}};
  EXPECT_EQ(at(made(Facing::Up), 20, 19)[1], 100);
  cloud.normals = {{0, 0, -1}, {0, 0, -1}};
  EXPECT_EQ(at(made(Facing::Down), 20, 19)[0], 200);
}

TEST_F(PointsOnly, AreDarkerTheMoreTheyTurnAway) {
  const float half = 0.5F, root = std::sqrt(0.75F);
  cloud.normals = {{0, 0, -1}, {root, 0, half}};
  EXPECT_EQ(at(made(Facing::Up), 20, 19)[1], 67);  // 100 * (0.35 + 0.65 / 2) = 67.5
  cloud.colors.clear();
  EXPECT_EQ(at(made(Facing::Up), 20, 19)[0], 118);  // 176 * 0.675 = 118.8
}

TEST_F(PointsOnly, AtTheEdgeAndBeyondItCostNothing) {
  cloud.points = {{0, 0, 0}, {1e6F, -1e6F, 0}};
  cloud.normals.clear();
  const Picture picture = made(Facing::Up);
  EXPECT_EQ(at(picture, 0, 39), (std::array<int, 4>{200, 0, 0, 255}));
  EXPECT_EQ(at(picture, 39, 0)[3], 0);
}

}  // namespace
}  // namespace ostraka::review
