#include "drawing/view.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

namespace ostraka::drawing {
namespace {

// 40 x 40 mm across the line of sight, of four vertices.
TriangleMesh tile() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0, 40, 0}, {0, 40, 40}, {0, 0, 40}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// Dark at the left, light at the right, there with a dark line of 2.5 mm from 30 mm on.
texture::TexturedMesh paintedTile() {
  texture::TexturedMesh painted{tile(), {}, {}, 40 / 64.0};
  for (const Eigen::Vector3f& v : painted.mesh.vertices)
    painted.uv.emplace_back(v.y() / 40, 1 - v.z() / 40);
  painted.texture.picture = cv::Mat3b(64, 64, cv::Vec3b(255, 255, 255));
  painted.texture.picture.colRange(0, 32) = cv::Scalar(0, 0, 0);
  painted.texture.picture.colRange(48, 52) = cv::Scalar(0, 0, 0);
  return painted;
}

cv::Mat1b drawn(const texture::TexturedMesh* photographs, Surface surface) {
  ViewOptions options;
  options.surface = surface;
  options.photographs = photographs;
  const SherdView view = drawView(tile(), Eigen::Isometry3d::Identity(), options);
  const std::string& jpeg = std::get<Picture>(view.sheet.items[0]).jpeg;
  return cv::imdecode(std::vector<char>(jpeg.begin(), jpeg.end()), cv::IMREAD_GRAYSCALE);
}

// The tile's level so many mm from its left edge; the picture has a mm around it.
int levelOf(const cv::Mat1b& picture, double from_left_mm) {
  return picture(picture.rows / 2, cvRound((from_left_mm + 1) * picture.cols / 42.0));
}

TEST(View, ThePaintIsAsFineAsThePhotographsNotAsTheVertices) {
  const texture::TexturedMesh painted = paintedTile();
  const cv::Mat1b picture = drawn(&painted, Surface::Painted);
  EXPECT_LT(levelOf(picture, 10), 80);
  EXPECT_GT(levelOf(picture, 25), 230);
  EXPECT_LT(levelOf(picture, 31.25), 80) << "the line lies between vertices";
  EXPECT_GT(levelOf(picture, 36), 230);
}

TEST(View, ReliefAndModelsWithoutPhotographsHaveNoPaint) {
  const texture::TexturedMesh painted = paintedTile();
  const cv::Mat1b relief = drawn(&painted, Surface::Relief);
  EXPECT_NEAR(levelOf(relief, 10), levelOf(relief, 36), 2);
  EXPECT_EQ(cv::norm(relief, drawn(nullptr, Surface::Painted), cv::NORM_INF), 0);
}

ViewOptions asOrthophoto(const texture::TexturedMesh* photographs) {
  ViewOptions options;
  options.surface = Surface::Orthophoto;
  options.photographs = photographs;
  return options;
}

// Blue, green, red so many mm from the tile's left edge.
cv::Vec3b colourOf(const ViewPicture& picture, double from_left_mm) {
  const cv::Mat3b pixels = picture.pixels;
  const double mm = from_left_mm - picture.corner.x();
  return pixels(pixels.rows / 2, static_cast<int>(mm * picture.dpi / 25.4));
}

TEST(View, AnOrthophotoHasTheColoursOfThePhotographsWithoutLightOfItsOwn) {
  texture::TexturedMesh painted = paintedTile();
  const cv::Vec3b clay(60, 110, 170);
  painted.texture.picture.colRange(0, 32) = cv::Scalar(clay);
  const ViewPicture picture =
      pictureOf(tile(), Eigen::Isometry3d::Identity(), asOrthophoto(&painted));
  EXPECT_EQ(colourOf(picture, 10), clay);
  EXPECT_EQ(colourOf(picture, 25), cv::Vec3b::all(255));
  EXPECT_EQ(colourOf(picture, 31.25), cv::Vec3b::all(0));
  EXPECT_EQ(colourOf(picture, -0.5), cv::Vec3b::all(255)) << "paper around";
  const SherdView view = drawView(tile(), Eigen::Isometry3d::Identity(), asOrthophoto(&painted));
  ASSERT_EQ(view.sheet.items.size(), 1u) << "no outline";
  EXPECT_EQ(std::get<Picture>(view.sheet.items[0]).ink, Ink::Colours);
  EXPECT_NEAR(view.box.sizes().x(), 40, 0.1);
}

TEST(View, AnOrthophotoHasNoPerspective) {
  texture::TexturedMesh painted = paintedTile();
  for (Eigen::Vector3f& v : painted.mesh.vertices) v.x() = v.y();  // 40 mm nearer at the right
  const ViewPicture picture =
      pictureOf(painted.mesh, Eigen::Isometry3d::Identity(), asOrthophoto(&painted));
  EXPECT_EQ(colourOf(picture, 19), cv::Vec3b::all(0));
  EXPECT_EQ(colourOf(picture, 21), cv::Vec3b::all(255));
  EXPECT_EQ(colourOf(picture, 31.25), cv::Vec3b::all(0));
}

TEST(View, AnOrthophotoWithoutPhotographsShowsTheColoursOfTheVertices) {
  TriangleMesh mesh = tile();
  mesh.colors = {{200, 100, 0}, {0, 100, 200}, {0, 100, 200}, {200, 100, 0}};
  const ViewPicture picture = pictureOf(mesh, Eigen::Isometry3d::Identity(), asOrthophoto(nullptr));
  EXPECT_LE(cv::norm(colourOf(picture, 20), cv::Vec3b(100, 100, 100), cv::NORM_INF), 2);
}

TEST(View, HasTheDotsOfItsResolution) {
  for (const Dpi dpi : {Dpi::Usual, Dpi::Fine}) {
    ViewOptions options;
    options.dpi = dpi;
    const ViewPicture picture = pictureOf(tile(), Eigen::Isometry3d::Identity(), options);
    EXPECT_EQ(picture.dpi, static_cast<int>(dpi));
    EXPECT_NEAR(picture.pixels.cols, 42 * picture.dpi / 25.4, 1);
    EXPECT_NEAR(picture.size_mm().x(), 42, 25.4 / picture.dpi);
  }
}

TEST(View, OfAVeryLongOneHasFewerWholeDots) {
  TriangleMesh mesh = tile();
  for (Eigen::Vector3f& v : mesh.vertices) v = {0, 75 * v.y(), v.z() / 100};
  ViewOptions options;
  options.dpi = Dpi::Fine;
  const ViewPicture picture = pictureOf(mesh, Eigen::Isometry3d::Identity(), options);
  EXPECT_GT(picture.dpi, 300);
  EXPECT_LT(picture.dpi, 600);
  EXPECT_NEAR(picture.size_mm().x(), 3002, 25.4 / picture.dpi);
}

}  // namespace
}  // namespace ostraka::drawing
