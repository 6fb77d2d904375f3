#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "cloud/nearest.h"
#include "cloud/ply.h"
#include "files/json.h"
#include "model/model.h"

namespace ostraka::model {
namespace {

// shared/scans/flake/README.md: a real stone flake with edges that run out to nothing.
TEST(CloseModelOfAFlake, VolumeAndAreaAreTheObjectsOwn) {
  const std::string set = std::string(OSTRAKA_SHARED_DIR) + "/scans/flake/";
  const auto front = readPlyCloud(set + "front/f001.ply"),
             back = readPlyCloud(set + "back/b001.ply");
  const auto truth = readJson(set + "truth.json");
  ASSERT_TRUE(front && back && truth);
  const nlohmann::json& pair = truth->at("pairs").at(0);
  const auto front_from_back = isometryFromJson(pair.at("T_front_from_back"), "truth.json");
  ASSERT_TRUE(front_from_back.has_value());
  QuietProgress quiet;
  const auto model = closeModel(*front, *back, *front_from_back, {}, quiet, {});
  ASSERT_TRUE(model.has_value()) << model.error().what;
  Message why;
  EXPECT_TRUE(isClosedManifold(model->mesh, &why)) << why;
  const Measures m = measure(model->mesh);
  EXPECT_NEAR(m.volume_mm3, 22823.7, 0.005 * 22823.7);
  EXPECT_NEAR(m.area_mm2, 5935.4, 0.01 * 5935.4);
  EXPECT_NEAR(m.length_mm, 76.51, 0.5);
  EXPECT_LT(model->filled_share, 0.001);
  const auto truth_mesh = readPly(set + "truth/flake.ply");
  ASSERT_TRUE(truth_mesh.has_value());
  const KdTree tree(truth_mesh->mesh.vertices);
  std::vector<float> d;
  for (const Eigen::Vector3f& v : model->mesh.vertices)
    d.push_back(std::sqrt(tree.nearest(v).squared_distance));
  std::sort(d.begin(), d.end());
  // To the nearest vertex of a mesh with edges of 0.3 mm: at most 0.17 on the surface itself.
  EXPECT_LT(d[d.size() * 9 / 10], 0.19f);
}

}  // namespace
}  // namespace ostraka::model
