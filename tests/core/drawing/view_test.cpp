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

}  // namespace
}  // namespace ostraka::drawing
