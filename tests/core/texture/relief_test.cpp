#include "texture/relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "block.h"
#include "cloud/glb.h"
#include "texture/atlas.h"
#include "texture/charts.h"
#include "texture/texture.h"

namespace ostraka::texture {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kRadius = 10, kBump = 0.06, kWaves = 16;  // mm, mm, radians on the unit ball

// A ball with bumps 3.9 mm from one to the next, up to 5.5 degrees steep.
double heightAt(const Vector3d& d) {
  return kBump * std::sin(kWaves * d.x()) * std::sin(kWaves * d.y()) * std::sin(kWaves * d.z());
}

// Of the level set |p| - radius - height(p / |p|), by hand.
Vector3d trueNormalAt(const Vector3d& p) {
  const Vector3d d = p.normalized();
  Vector3d gradient;
  for (int k = 0; k < 3; ++k) {
    gradient[k] = kBump * kWaves * std::cos(kWaves * d[k]);
    for (int other = 0; other < 3; ++other)
      if (other != k) gradient[k] *= std::sin(kWaves * d[other]);
  }
  return (d - (gradient - gradient.dot(d) * d) / p.norm()).normalized();
}

TriangleMesh bumpyBall() {
  return block({2, 2, 2}, 0.045f, [](const Vector3f& p) -> Vector3f {
    const Vector3d d = (p - Vector3f::UnitZ()).cast<double>().normalized();
    return ((kRadius + heightAt(d)) * d).cast<float>();
  });
}

// A grey page on a mesh.
TexturedMesh grey(const TriangleMesh& mesh, double texel_mm) {
  const std::vector<Chart> charts = chartsOf(mesh, texel_mm);
  const Atlas atlas = packed(charts, texel_mm);
  UnwrappedMesh flat = unwrapped(mesh, charts, atlas);
  TexturedMesh model{std::move(flat.mesh), std::move(flat.uv), {}, atlas.texel_mm};
  model.texture.picture = cv::Mat3b(atlas.height, atlas.width, cv::Vec3b(128, 128, 128));
  model.texture.seen = cv::Mat1b(atlas.height, atlas.width, uchar{255});
  return model;
}

// What a renderer makes of a GLB, read by the letter of glTF 2.0.
class Rendered {
 public:
  explicit Rendered(const std::string& glb) {
    std::uint32_t size = 0;
    std::memcpy(&size, glb.data() + 12, 4);
    json_ = nlohmann::json::parse(glb.substr(20, size));
    binary_ = glb.substr(20 + size + 8);
    const auto& attributes = json_["meshes"][0]["primitives"][0]["attributes"];
    positions_ = floats(attributes["POSITION"]);
    normals_ = floats(attributes["NORMAL"]);
    tangents_ = floats(attributes["TANGENT"]);
    places_ = floats(attributes["TEXCOORD_0"]);
    const int texture = json_["materials"][0]["normalTexture"]["index"];
    const int source = json_["textures"][texture]["source"];
    EXPECT_EQ(json_["images"][source]["mimeType"], "image/png");
    const std::string png = view(json_["images"][source]["bufferView"]);
    map_ = cv::imdecode(std::vector<char>(png.begin(), png.end()), cv::IMREAD_COLOR);
    EXPECT_EQ(json_["accessors"][attributes["TANGENT"].get<int>()]["type"], "VEC4");
    EXPECT_EQ(tangents_.size(), positions_.size() / 3 * 4);
    for (std::size_t v = 0; 4 * v < tangents_.size(); ++v) {
      const Eigen::Map<const Vector3f> along(tangents_.data() + 4 * v);
      EXPECT_NEAR(along.norm(), 1, 1e-5);
      EXPECT_NEAR(along.dot(Eigen::Map<const Vector3f>(normals_.data() + 3 * v)), 0, 1e-5);
      EXPECT_EQ(tangents_[4 * v + 3], 1);
    }
  }

  struct Shaded {
    Vector3d point, own, mapped;  // mm and z up; without and with the map
  };
  Shaded at(const std::array<int, 3>& t, const std::array<double, 3>& weights) const {
    const auto mixed = [&](const std::vector<float>& of, int each, int k) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c)
        sum += weights[c] * of[static_cast<std::size_t>(each * t[c] + k)];
      return sum;
    };
    const auto vector = [&](const std::vector<float>& of, int each) {
      return Vector3d(mixed(of, each, 0), mixed(of, each, 1), mixed(of, each, 2));
    };
    const Vector3d n = vector(normals_, 3).normalized(), along = vector(tangents_, 4).normalized();
    const Vector3d bitangent = mixed(tangents_, 4, 3) * n.cross(along);
    const cv::Vec3f bgr = levelAt(
        map_, {static_cast<float>(mixed(places_, 2, 0)), static_cast<float>(mixed(places_, 2, 1))});
    const Vector3d sampled = 2 / 255.0 * Vector3d(bgr[2], bgr[1], bgr[0]) - Vector3d::Ones();
    return {1000 * zUp(vector(positions_, 3)), zUp(n),
            zUp((sampled.x() * along + sampled.y() * bitangent + sampled.z() * n).normalized())};
  }

 private:
  static Vector3d zUp(const Vector3d& v) { return {v.x(), -v.z(), v.y()}; }
  std::string view(int number) const {
    const auto& of = json_["bufferViews"][number];
    return binary_.substr(of["byteOffset"].get<std::size_t>(), of["byteLength"].get<std::size_t>());
  }
  std::vector<float> floats(int accessor) const {
    const std::string bytes = view(json_["accessors"][accessor]["bufferView"]);
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }

  nlohmann::json json_;
  std::string binary_;
  std::vector<float> positions_, normals_, tangents_, places_;
  cv::Mat3b map_;
};

double degreesBetween(const Vector3d& a, const Vector3d& b) {
  return 180 / M_PI * std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

TEST(Relief, GivesALightMeshTheNormalsOfTheFullOne) {
  const TriangleMesh full = bumpyBall();
  TexturedMesh light = grey(*model::decimated(full, 0.15), 0.15);
  ASSERT_LT(20 * light.mesh.triangles.size(), full.triangles.size());
  light.relief = reliefOf(light, full, 2);
  ASSERT_FALSE(light.relief.empty());
  const std::string glb = *formatGlb(light, {});
  ASSERT_TRUE(*parseTexturedGlb(glb, "a")) << "the program's own reader takes it";
  const Rendered rendered(glb);
  double own = 0, mapped = 0, count = 0;
  std::vector<double> off;
  for (const auto& t : light.mesh.triangles)
    for (int i = 1; i < 12; ++i)
      for (int j = 1; i + j < 12; ++j) {
        const auto at = rendered.at(t, {i / 12.0, j / 12.0, (12 - i - j) / 12.0});
        const Vector3d truth = trueNormalAt(at.point);
        own += std::pow(degreesBetween(at.own, truth), 2);
        off.push_back(degreesBetween(at.mapped, truth));
        mapped += off.back() * off.back();
        ++count;
      }
  std::sort(off.begin(), off.end());
  EXPECT_LT(std::sqrt(mapped / count), 1) << "degrees";
  EXPECT_LT(off[off.size() * 95 / 100], 2);
  EXPECT_GT(std::sqrt(own / count), 2.5) << "the light mesh alone";
  EXPECT_GT(own, 16 * mapped);
}

TEST(Relief, IsFlatWhereNobodySawAndTheSameForAnyNumberOfThreads) {
  TriangleMesh full = bumpyBall();
  for (const Vector3f& v : full.vertices) full.seen.push_back(v.z() > 0 ? 1 : 0);
  const TexturedMesh light = grey(*model::decimated(full, 0.15), 0.3);
  const cv::Mat3b one = reliefOf(light, full, 1), three = reliefOf(light, full, 3);
  ASSERT_FALSE(one.empty());
  EXPECT_EQ(cv::norm(one, three, cv::NORM_INF), 0);
  const Texels texels = texelsOf(light.mesh, light.uv, one.size());
  int relief_below = 0, flat_above = 0, above = 0;
  for (int y = 0; y < one.rows; ++y)
    for (int x = 0; x < one.cols; ++x) {
      const bool flat = one(y, x) == cv::Vec3b(255, 128, 128);
      if (texels.face(y, x) < 0) {
        EXPECT_TRUE(flat) << "off the charts";
        continue;
      }
      const double z = pointOf(light.mesh, texels, x, y).z();
      if (z < -0.5 && !flat) ++relief_below;
      if (z > 0.5) ++above, flat_above += flat ? 1 : 0;
    }
  EXPECT_EQ(relief_below, 0);
  EXPECT_LT(20 * flat_above, above);
}

TEST(Relief, IsLeftOutWhereItAddsNothing) {
  const TriangleMesh full = bumpyBall();
  EXPECT_TRUE(reliefOf(grey(full, 0.3), full, 1).empty()) << "the mesh is the full one";
  const auto smoothBall = [](float cell) {
    TriangleMesh ball = block({2, 2, 2}, cell, [](const Vector3f& p) -> Vector3f {
      return 10 * (p - Vector3f::UnitZ()).normalized();
    });
    for (std::size_t v = 0; v < ball.vertices.size(); ++v)
      ball.normals[v] = ball.vertices[v].normalized();
    return ball;
  };
  const TriangleMesh smooth = smoothBall(0.08f);
  const TexturedMesh light = grey(smoothBall(0.16f), 0.3);
  EXPECT_TRUE(reliefOf(light, smooth, 1).empty()) << "normals of a ball, within a degree";
  EXPECT_EQ(formatGlb(light, {})->find("normalTexture"), std::string::npos);
  GlbTexture files = filesOf(light);
  files.normals_png = "a PNG";
  EXPECT_FALSE(ostraka::formatGlb(light.mesh, files, {})) << "a map without its frames";
}

}  // namespace
}  // namespace ostraka::texture
