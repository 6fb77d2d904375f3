#include "texture/texture.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "block.h"

namespace ostraka::texture {
namespace {

TEST(Texture, NeedsAPhotograph) {
  QuietProgress quiet;
  const auto made = textured(block({40, 30, 6}, 2), {}, 1, quiet, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::NotEnough);
}

TEST(Texture, IsNoneWhereTheMasksShowAnotherPlace) {
  const TriangleMesh tile = block({40, 30, 6}, 2);
  cv::Mat1b mask(600, 800, uchar{0});
  mask.colRange(0, 245) = 255;
  const auto view =
      cutOut(cv::Mat3b(600, 800, cv::Vec3b(50, 100, 150)), mask, lookingAt({0, 0, 150}, {0, 0, 0}),
             Eigen::Isometry3d::Identity(), tile.vertices);
  QuietProgress quiet;
  EXPECT_EQ(textured(tile, {*view}, 1, quiet, {}).error().code, ErrorCode::NotEnough)
      << "a black picture is no texture";
}

TEST(Texture, HasTexelsOfTheNearestPhotographsPixels) {
  const TriangleMesh tile = block({40, 30, 6}, 2);
  std::vector<View> views;
  for (const double height : {150.0, 300.0})
    views.push_back(*cutOut(cv::Mat3b(600, 800, cv::Vec3b(50, 100, 150)),
                            cv::Mat1b(600, 800, uchar{255}), lookingAt({0, 0, height}, {0, 0, 0}),
                            Eigen::Isometry3d::Identity(), tile.vertices));
  QuietProgress quiet;
  const auto made = textured(tile, views, 1, quiet, {});
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->texel_mm, (150 - 3) / 1000.0, 0.002);
  EXPECT_EQ(made->uv.size(), made->mesh.vertices.size());
  const std::string png = asPng(made->texture.seen);
  const cv::Mat seen =
      cv::imdecode(std::vector<char>(png.begin(), png.end()), cv::IMREAD_GRAYSCALE);
  EXPECT_EQ(cv::norm(seen, made->texture.seen, cv::NORM_INF), 0);
  const std::string jpeg = asJpeg(made->texture.picture);
  const cv::Mat3b picture =
      cv::imdecode(std::vector<char>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
  EXPECT_NEAR(picture(picture.rows / 2, picture.cols / 2)[2], 150, 2);
}

}  // namespace
}  // namespace ostraka::texture
