#include "exchange/lighter_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "evaluate/surface.h"
#include "model/model.h"

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

TEST(LighterModel, KeepsWhatItStatesAndIsLighterTheMoreItMay) {
  const TriangleMesh ball = dentedBall();
  ASSERT_TRUE(model::isClosedManifold(ball));
  std::size_t before = ball.triangles.size();
  for (const double allowed : {0.05, 0.1, 0.2}) {
    const auto lighter = lighterModel(ball, allowed);
    ASSERT_TRUE(lighter.has_value()) << lighter.error().sentence();
    EXPECT_TRUE(model::isClosedManifold(lighter->mesh));
    EXPECT_LT(lighter->mesh.triangles.size(), before) << allowed;
    before = lighter->mesh.triangles.size();
    const evaluate::Surface whole(ball), light(lighter->mesh);
    std::vector<double> off;
    for (const Eigen::Vector3f& v : ball.vertices)
      off.push_back(light.closest(v.cast<double>()).distance_mm);
    const auto within =
        std::count_if(off.begin(), off.end(), [&](double d) { return d <= lighter->deviation_mm; });
    EXPECT_GE(static_cast<double>(within), 0.999 * static_cast<double>(off.size()));
    for (const Eigen::Vector3f& v : lighter->mesh.vertices)
      off.push_back(whole.closest(v.cast<double>()).distance_mm);
    EXPECT_NEAR(*std::max_element(off.begin(), off.end()), lighter->farthest_mm, 1e-9);
    EXPECT_LE(lighter->deviation_mm, allowed);
    EXPECT_GE(lighter->farthest_mm, lighter->deviation_mm);
  }
  EXPECT_LT(before, ball.triangles.size() / 8);
}

TEST(LighterModel, RefusesWhatItCannotThin) {
  TriangleMesh open = dentedBall();
  open.triangles.pop_back();
  EXPECT_EQ(lighterModel(open, 0.1).error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(lighterModel(dentedBall(), 0).error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::exchange
