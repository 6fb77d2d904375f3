#include <gtest/gtest.h>

#include "model/model.h"
#include "shapes.h"

namespace ostraka::model {
namespace {

TEST(MeshCheck, ABoxIsClosed) {
  EXPECT_TRUE(isClosedManifold(boxMesh({1, 2, 3})));
}

TEST(MeshCheck, AMissingFaceIsNamed) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  mesh.triangles.pop_back();
  Message why;
  EXPECT_FALSE(isClosedManifold(mesh, &why));
  EXPECT_NE(why.english().find("one side only"), std::string::npos) << why;
}

TEST(MeshCheck, AFlippedFaceIsRefused) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  EXPECT_FALSE(isClosedManifold(mesh));
}

TEST(MeshCheck, TwoBoxesThatShareAVertexAreRefused) {
  TriangleMesh mesh = boxMesh({1, 1, 1});
  const TriangleMesh other = boxMesh({1, 1, 1});
  // Corner 0 of the second is corner 7 of the first.
  for (int k = 1; k < 8; ++k) mesh.vertices.push_back(other.vertices[k] + Eigen::Vector3f::Ones());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] ? t[0] + 7 : 7, t[1] ? t[1] + 7 : 7, t[2] ? t[2] + 7 : 7});
  Message why;
  EXPECT_FALSE(isClosedManifold(mesh, &why));
  EXPECT_NE(why.english().find("two separate fans"), std::string::npos) << why;
}

TEST(MeshCheck, ALooseVertexAndAWrongIndexAreRefused) {
  TriangleMesh loose = boxMesh({1, 1, 1});
  loose.vertices.emplace_back(5, 5, 5);
  EXPECT_FALSE(isClosedManifold(loose));
  TriangleMesh wrong = boxMesh({1, 1, 1});
  wrong.triangles[0][0] = 8;
  EXPECT_FALSE(isClosedManifold(wrong));
  EXPECT_FALSE(isClosedManifold(TriangleMesh{}));
}

TEST(MeshCheck, NormalsOfABoxPointAlongItsDiagonals) {
  const TriangleMesh mesh = boxMesh({2, 2, 2});
  const std::vector<Eigen::Vector3f> normals = vertexNormals(mesh);
  // Weighted by angles, each of the three faces at a corner counts the same.
  for (int k = 0; k < 8; ++k) EXPECT_LT((normals[k] - mesh.vertices[k].normalized()).norm(), 1e-5f);
}

}  // namespace
}  // namespace ostraka::model
