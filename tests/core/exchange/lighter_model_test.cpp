#include "exchange/lighter_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloud/glb.h"
#include "cloud/surface.h"
#include "images/jpeg_image.h"
#include "images/png_image.h"
#include "model/model.h"
#include "texture/atlas.h"
#include "texture/charts.h"
#include "texture/fill.h"

namespace ostraka::exchange {
namespace {

// A ball of 20 mm with dents of 0.15 mm, so that not every level can drop them.
TriangleMesh dentedBall() {
  constexpr int kRings = 90, kAround = 180;
  TriangleMesh mesh;
  const auto point = [](double up, double around) {
    const double r = 20 + 0.15 * std::sin(9 * around) * std::sin(7 * up);
    return Eigen::Vector3f(static_cast<float>(r * std::sin(up) * std::cos(around)),
                           static_cast<float>(r * std::sin(up) * std::sin(around)),
                           static_cast<float>(r * std::cos(up)));
  };
  mesh.vertices.push_back(point(0, 0));
  for (int i = 1; i < kRings; ++i)
    for (int k = 0; k < kAround; ++k)
      mesh.vertices.push_back(point(M_PI * i / kRings, 2 * M_PI * k / kAround));
  mesh.vertices.push_back(point(M_PI, 0));
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [](int ring, int k) { return 1 + (ring - 1) * kAround + k % kAround; };
  for (int k = 0; k < kAround; ++k) {
    mesh.triangles.push_back({0, at(1, k), at(1, k + 1)});
    mesh.triangles.push_back({last, at(kRings - 1, k + 1), at(kRings - 1, k)});
    for (int i = 1; i + 1 < kRings; ++i) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh;
}

TEST(LighterModel, TakesNoMoreThanItMayAndStatesHowFarOffItIs) {
  const TriangleMesh ball = dentedBall();
  ASSERT_TRUE(model::isClosedManifold(ball));
  std::size_t before = ball.triangles.size();
  for (const std::size_t most : {300'000, 60'000, 20'000}) {
    const auto lighter = lighterModel(ball, most);
    ASSERT_TRUE(lighter.has_value()) << lighter.error().sentence();
    EXPECT_LE(formatGlb(lighter->mesh, {})->size(), most);
    EXPECT_TRUE(model::isClosedManifold(lighter->mesh));
    EXPECT_LE(lighter->mesh.triangles.size(), before) << most;
    before = lighter->mesh.triangles.size();
    EXPECT_LT(before, ball.triangles.size());
    const Surface whole(ball), light(lighter->mesh);
    std::vector<double> off;
    for (const Eigen::Vector3f& v : ball.vertices)
      off.push_back(light.closest(v.cast<double>()).distance_mm);
    const auto within =
        std::count_if(off.begin(), off.end(), [&](double d) { return d <= lighter->deviation_mm; });
    EXPECT_GE(static_cast<double>(within), 0.999 * static_cast<double>(off.size()));
    for (const Eigen::Vector3f& v : lighter->mesh.vertices)
      off.push_back(whole.closest(v.cast<double>()).distance_mm);
    EXPECT_NEAR(*std::max_element(off.begin(), off.end()), lighter->farthest_mm, 1e-9);
    EXPECT_GE(lighter->farthest_mm, lighter->deviation_mm);
  }
  EXPECT_LT(before, ball.triangles.size() / 8);
}

TEST(LighterModel, IsTheModelItselfWhereThatIsSmallEnough) {
  const TriangleMesh ball = dentedBall();
  const auto lighter = lighterModel(ball, 5'000'000);
  ASSERT_TRUE(lighter.has_value());
  EXPECT_EQ(lighter->mesh.triangles, ball.triangles);
  EXPECT_LT(lighter->deviation_mm, 0) << "it is whole";
}

TEST(LighterModel, RefusesWhatItCannotThin) {
  TriangleMesh open = dentedBall();
  open.triangles.pop_back();
  EXPECT_EQ(lighterModel(open, 20'000).error().code, ErrorCode::UnusableInput);
}

// Rings of paint around z, 19 mm from one to the next; nobody saw what lies above 10 mm.
float paintAt(float z) {
  return 128 + 100 * std::sin(z / 3);
}

texture::TexturedMesh paintedBall() {
  TriangleMesh ball = dentedBall();
  ball.normals = model::vertexNormals(ball);
  const std::vector<texture::Chart> charts = texture::chartsOf(ball, 0.2);
  const texture::Atlas atlas = texture::packed(charts, 0.2);
  const texture::Texels texels = texture::texelsOf(charts, atlas);
  texture::TexturedMesh painted;
  cv::Mat3f page(texels.face.size(), cv::Vec3f(0, 0, 0));
  cv::Mat1b known(texels.face.size(), uchar{0});
  painted.texture.seen = cv::Mat1b(texels.face.size(), uchar{0});
  for (int y = 0; y < page.rows; ++y)
    for (int x = 0; x < page.cols; ++x) {
      if (texels.face(y, x) < 0) continue;
      const auto& t = ball.triangles[static_cast<std::size_t>(texels.face(y, x))];
      const cv::Vec2f& w = texels.weights(y, x);
      const float z = w[0] * ball.vertices[t[0]].z() + w[1] * ball.vertices[t[1]].z() +
                      (1 - w[0] - w[1]) * ball.vertices[t[2]].z();
      page(y, x) = {paintAt(z), 50, 50};
      known(y, x) = 255;
      painted.texture.seen(y, x) = z < 10 ? 255 : 0;
    }
  texture::filled(page, known).convertTo(painted.texture.picture, CV_8U);
  texture::UnwrappedMesh unwrapped = texture::unwrapped(ball, charts, atlas);
  painted.mesh = std::move(unwrapped.mesh);
  painted.uv = std::move(unwrapped.uv);
  return painted;
}

TEST(LighterModel, HasThePhotographsWhereTheyWere) {
  const auto lighter = lighterModel(dentedBall(), 60'000);
  ASSERT_TRUE(lighter.has_value());
  const auto made = retextured(lighter->mesh, paintedBall());
  ASSERT_TRUE(made.has_value()) << made.error().sentence();
  EXPECT_EQ(made->mesh.triangles.size(), lighter->mesh.triangles.size());
  ASSERT_EQ(made->uv.size(), made->mesh.vertices.size());
  EXPECT_GT(made->texel_mm, 0.18);
  EXPECT_LT(made->texel_mm, 0.3) << "charts are looked at along an axis: slopes have fewer texels";
  std::size_t right = 0;
  for (std::size_t v = 0; v < made->uv.size(); ++v) {
    const float z = made->mesh.vertices[v].z();
    const cv::Mat1b& mask = made->texture.seen;
    const int x = std::min(mask.cols - 1, static_cast<int>(made->uv[v].x() * mask.cols)),
              y = std::min(mask.rows - 1, static_cast<int>(made->uv[v].y() * mask.rows));
    const bool seen = std::abs(z - 10) < 1 || (mask(y, x) != 0) == (z < 10);
    // The model lies up to 0.2 mm off, which is 7 levels of paint.
    const float off = texture::levelAt(made->texture.picture, made->uv[v])[0] - paintAt(z);
    right += seen && std::abs(off) < 20 ? 1 : 0;
  }
  EXPECT_GE(static_cast<double>(right), 0.98 * static_cast<double>(made->uv.size()));
  EXPECT_GT(made->texture.seen_share, 0.5);
  EXPECT_LT(made->texture.seen_share, 0.9);
}

TEST(LighterModel, ShowsItsPhotographsOnTheFullModelWithoutASeam) {
  const auto lighter = lighterModel(dentedBall(), 60'000);
  ASSERT_TRUE(lighter.has_value());
  const auto textured = retextured(lighter->mesh, paintedBall());
  ASSERT_TRUE(textured.has_value()) << textured.error().sentence();
  const TriangleMesh ball = dentedBall();
  const CornerPlaces places = placesOn(ball, *textured);
  ASSERT_EQ(places.size(), ball.triangles.size());
  const cv::Mat3b& picture = textured->texture.picture;
  std::size_t right = 0;
  float largest = 0;  // edge of a triangle in the picture, texels
  for (std::size_t f = 0; f < places.size(); ++f) {
    Eigen::Vector2f middle = Eigen::Vector2f::Zero();
    float z = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      middle += places[f][k] / 3;
      z += ball.vertices[static_cast<std::size_t>(ball.triangles[f][k])].z() / 3;
      const Eigen::Vector2f edge = places[f][(k + 1) % 3] - places[f][k];
      largest = std::max({largest, std::abs(edge.x()) * static_cast<float>(picture.cols),
                          std::abs(edge.y()) * static_cast<float>(picture.rows)});
    }
    right += std::abs(texture::levelAt(picture, middle)[0] - paintAt(z)) < 20 ? 1 : 0;
  }
  EXPECT_GE(static_cast<double>(right), 0.97 * static_cast<double>(places.size()));
  EXPECT_LT(largest, 12) << "an edge has 0.9 mm, a texel 0.2 mm: none spans two charts";
}

TEST(LighterModel, HasSmallerPhotographsWhereTheyWouldNotFit) {
  auto made = retextured(lighterModel(dentedBall(), 60'000)->mesh, paintedBall());
  ASSERT_TRUE(made.has_value()) << made.error().sentence();
  const auto size = [&] {
    return formatGlb(made->mesh,
                     {made->uv, images::encodedJpeg(made->texture.picture),
                      images::encodedPng(made->texture.seen)},
                     {})
        ->size();
  };
  const cv::Size page = made->texture.picture.size();
  const double texel_mm = made->texel_mm;
  shrinkPhotographs(*made, size());
  EXPECT_EQ(made->texture.picture.size(), page) << "they fit";
  const std::size_t most = size() - images::encodedJpeg(made->texture.picture).size() / 2;
  shrinkPhotographs(*made, most);
  EXPECT_LE(size(), most);
  EXPECT_LT(made->texture.picture.cols, page.width);
  EXPECT_EQ(made->texture.seen.size(), made->texture.picture.size());
  EXPECT_GT(made->texel_mm, texel_mm);
  std::size_t right = 0;
  for (std::size_t v = 0; v < made->uv.size(); ++v)
    right += std::abs(texture::levelAt(made->texture.picture, made->uv[v])[0] -
                      paintAt(made->mesh.vertices[v].z())) < 25
                 ? 1
                 : 0;
  EXPECT_GE(static_cast<double>(right), 0.95 * static_cast<double>(made->uv.size()));
}

TEST(LighterModel, WithoutAClosedSurfaceHasNoPhotographs) {
  const texture::TexturedMesh painted = paintedBall();
  EXPECT_FALSE(retextured(painted.mesh, painted)) << "its charts are apart";
}

}  // namespace
}  // namespace ostraka::exchange
