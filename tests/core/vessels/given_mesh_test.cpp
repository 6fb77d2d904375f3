#include "vessels/given_mesh.h"

#include <gtest/gtest.h>

#include <map>

#include "cloud/ply.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::vessels {
namespace {

namespace fs = std::filesystem;

// A box from a corner at (10, 20, 30), two triangles a face, counter-clockwise seen from outside.
TriangleMesh boxOf(const Eigen::Vector3f& sizes) {
  TriangleMesh box;
  for (int i = 0; i < 8; ++i)
    box.vertices.emplace_back(Eigen::Vector3f(10, 20, 30) +
                              sizes.cwiseProduct(Eigen::Vector3f(i & 1, i >> 1 & 1, i >> 2)));
  for (const auto& [a, b, c, d] :
       {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
        std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    box.triangles.push_back({a, b, c});
    box.triangles.push_back({a, c, d});
  }
  return box;
}

class GivenMesh : public testing::Test {
 protected:
  Result<VirtualSherd> read(const TriangleMesh& mesh) {
    const fs::path file = folder_ / "tea box.ply";
    EXPECT_TRUE(writePly(file, mesh, "model"));
    return sherdOfMesh(file);
  }
  void expectRefused(const TriangleMesh& mesh, const char* why) {
    const Result<VirtualSherd> sherd = read(mesh);
    ASSERT_FALSE(sherd);
    EXPECT_EQ(sherd.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(sherd.error().what.english().find(why), std::string::npos) << sherd.error().what;
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(GivenMesh, LiesAboutItsCentreOfMassWithShortEdges) {
  const Result<VirtualSherd> sherd = read(boxOf({30, 20, 10}));
  ASSERT_TRUE(sherd) << sherd.error().what;
  EXPECT_EQ(sherd->kind, "tea box");
  EXPECT_NEAR(sherd->volume_mm3, 6000, 0.1);
  EXPECT_NEAR(sherd->width_mm, 30, 1e-4);
  Eigen::Vector3d centre;
  enclosedVolume(sherd->mesh, &centre);
  EXPECT_LT(centre.norm(), 1e-3);
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& v : sherd->mesh.vertices) box.extend(v);
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3f(15, 10, 5), 1e-4f));
  EXPECT_EQ(sherd->places.size(), sherd->mesh.vertices.size());
  std::map<std::pair<int, int>, int> walks;
  for (const auto& t : sherd->mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      ++walks[{t[k], t[(k + 1) % 3]}];
      ASSERT_LE((sherd->mesh.vertices[t[k]] - sherd->mesh.vertices[t[(k + 1) % 3]]).norm(),
                kMostEdge_mm);
    }
  for (const auto& [edge, count] : walks) {  // still closed
    ASSERT_EQ(count, 1);
    ASSERT_EQ(walks.count({edge.second, edge.first}), 1u);
  }
}

TEST_F(GivenMesh, KeepsItsColoursAndMixesThemWhereEdgesAreHalved) {
  TriangleMesh box = boxOf({7.5F, 2.5F, 2.5F});
  box.colors.assign(8, {0, 0, 0});
  for (int i = 1; i < 8; i += 2) box.colors[static_cast<std::size_t>(i)] = {200, 100, 40};
  const Result<VirtualSherd> sherd = read(box);
  ASSERT_TRUE(sherd) << sherd.error().what;
  ASSERT_EQ(sherd->mesh.colors.size(), sherd->mesh.vertices.size());
  for (std::size_t i = 0; i < sherd->mesh.vertices.size(); ++i) {
    const float share = sherd->mesh.vertices[i].x() / 7.5F + 0.5F;  // black at -3.75 mm
    EXPECT_NEAR(sherd->mesh.colors[i][0], 200 * share, 2);  // three halvings, each rounded
    EXPECT_NEAR(sherd->mesh.colors[i][2], 40 * share, 2);
  }
}

TEST_F(GivenMesh, IsRefusedWhenItIsOpenInsideOutOrOfAnImpossibleSize) {
  TriangleMesh open = boxOf({30, 20, 10});
  open.triangles.pop_back();
  expectRefused(open, "not closed");
  TriangleMesh turned = boxOf({30, 20, 10});
  for (auto& t : turned.triangles) std::swap(t[1], t[2]);
  expectRefused(turned, "inside out");
  expectRefused(boxOf({3, 2, 1}), "5 and 300");
  expectRefused(boxOf({299, 2, 299}), "300 mm");
}

}  // namespace
}  // namespace ostraka::vessels
