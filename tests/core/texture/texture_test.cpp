#include "texture/texture.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "block.h"
#include "files/files.h"
#include "images/jpeg_image.h"
#include "images/png_image.h"

namespace ostraka::texture {
namespace {

TEST(Texture, NeedsAPhotograph) {
  QuietProgress quiet;
  const auto made = textured(block({40, 30, 6}, 2), {}, {}, 1, quiet, {});
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
  EXPECT_EQ(textured(tile, {*view}, {}, 1, quiet, {}).error().code, ErrorCode::NotEnough)
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
  const auto made = textured(tile, views, {}, 1, quiet, {});
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->texel_mm, (150 - 3) / 1000.0, 0.002);
  EXPECT_EQ(made->uv.size(), made->mesh.vertices.size());
  const std::string png = images::encodedPng(made->texture.seen);
  const cv::Mat seen =
      cv::imdecode(std::vector<char>(png.begin(), png.end()), cv::IMREAD_GRAYSCALE);
  EXPECT_EQ(cv::norm(seen, made->texture.seen, cv::NORM_INF), 0);
  const std::string jpeg = images::encodedJpeg(made->texture.picture);
  const cv::Mat3b picture =
      cv::imdecode(std::vector<char>(jpeg.begin(), jpeg.end()), cv::IMREAD_COLOR);
  EXPECT_NEAR(picture(picture.rows / 2, picture.cols / 2)[2], 150, 2);
}

TexturedModel painted(const cv::Mat3b& picture, const std::string& seen) {
  TexturedModel model;
  model.mesh = block({40, 30, 6}, 2);
  model.texture.uv.assign(model.mesh.vertices.size(), {0.5f, 0.5f});
  model.texture.jpeg = images::encodedPng(picture);
  model.texture.seen_png = seen;
  return model;
}

TEST(Texture, IsOpenedWithItsMask) {
  cv::Mat3b picture(2, 4, cv::Vec3b(0, 0, 0));
  picture(1, 3) = {10, 20, 200};
  cv::Mat1b seen(2, 4, uchar{255});
  seen(0, 0) = 0;
  const auto made = opened(painted(picture, images::encodedPng(seen)), "a");
  ASSERT_TRUE(made) << made.error().sentence();
  EXPECT_EQ(cv::norm(made->texture.picture, picture, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(made->texture.seen, seen, cv::NORM_INF), 0);
  EXPECT_EQ(levelAt(made->texture.picture, {0.875f, 0.75f}), cv::Vec3f(10, 20, 200))
      << "a texel's middle";
  EXPECT_EQ(levelAt(made->texture.picture, {0.75f, 0.75f}), cv::Vec3f(5, 10, 100));
  EXPECT_EQ(levelAt(made->texture.picture, {9, 9}), cv::Vec3f(10, 20, 200));
}

TEST(Texture, IsFoundBesideItsModel) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "texture_beside";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto none = openedBeside(folder / "model.ply");
  ASSERT_TRUE(none) << none.error().sentence();
  EXPECT_FALSE(*none);
  const TexturedModel model = painted(cv::Mat3b(4, 4, cv::Vec3b(10, 20, 200)), {});
  ASSERT_TRUE(writeGlb(folder / "model.glb", formatGlb(model.mesh, model.texture, {})));
  const auto made = openedBeside(folder / "model.ply");
  ASSERT_TRUE(made) << made.error().sentence();
  ASSERT_TRUE(*made);
  const std::vector<Color> colours = vertexColours(**made);
  ASSERT_EQ(colours.size(), (*made)->mesh.vertices.size());
  EXPECT_EQ(colours.front(), (Color{200, 20, 10}));
  ASSERT_TRUE(writeFileAtomically(folder / "model.glb", "no model"));
  EXPECT_FALSE(openedBeside(folder / "model.ply")) << "it is there and cannot be read";
}

// Two sherds of a batch, or one before and after it was processed again.
TEST(Texture, BesideAModelOfAnotherShapeIsAnotherModels) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "texture_of_another";
  std::filesystem::create_directories(folder);
  const TexturedModel model = painted(cv::Mat3b(4, 4, cv::Vec3b(10, 20, 200)), {});
  ASSERT_TRUE(writeGlb(folder / "model.glb", formatGlb(model.mesh, model.texture, {})));
  const auto opens = [&](const TriangleMesh& shape) {
    const auto made = openedBeside(folder / "model.ply", shape);
    return made && *made;
  };
  EXPECT_TRUE(opens(block({40, 30, 6}, 2)));
  EXPECT_TRUE(opens(block({40.1f, 30, 6.1f}, 1))) << "as simplifying moves its corners";
  EXPECT_FALSE(opens(block({44, 30, 6}, 2)));
  TriangleMesh elsewhere = block({40, 30, 6}, 2);
  for (Eigen::Vector3f& vertex : elsewhere.vertices) vertex.x() += 60;
  EXPECT_FALSE(opens(elsewhere)) << "of one size, but where another sherd lay";
  EXPECT_FALSE(opens({}));
}

TEST(Texture, ThatNoPageHoldsIsRefusedBeforeItIsDecoded) {
  std::string huge = images::encodedPng(cv::Mat3b(2, 4, cv::Vec3b(0, 0, 0)));
  huge[18] = '\x40';  // the width's third byte: 16,388
  huge[22] = '\x40';
  const auto made = opened(painted(cv::Mat3b(1, 1, cv::Vec3b(1, 2, 3)), {}), "a");
  EXPECT_TRUE(made);
  TexturedModel model = painted(cv::Mat3b(1, 1, cv::Vec3b(1, 2, 3)), {});
  model.texture.jpeg = huge;
  ASSERT_FALSE(opened(model, "a"));
  EXPECT_NE(opened(model, "a").error().what.english().find("67,108,864"), std::string::npos);
  model.texture.jpeg = "no picture";
  EXPECT_FALSE(opened(model, "a"));
}

}  // namespace
}  // namespace ostraka::texture
