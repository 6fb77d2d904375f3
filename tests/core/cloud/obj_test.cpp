#include "cloud/obj.h"

#include <gtest/gtest.h>

namespace ostraka {
namespace {

TEST(Obj, LinesHoldPointsColoursNormalsAndFacesFromOne) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1.5f, 0, 0}, {0, -2, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.colors = {{255, 0, 51}, {0, 0, 0}, {0, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  const auto text = formatObj(mesh);
  ASSERT_TRUE(text.has_value());
  EXPECT_EQ(*text,
            "# Ostraka, unit mm\nv 0 0 0 1 0 0.2\nv 1.5 0 0 0 0 0\nv 0 -2 0 0 0 0\n"
            "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1//1 2//2 3//3\n");
}

TEST(Obj, AnAbsentVertexIsRefused) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}};
  mesh.triangles = {{0, 0, 1}};
  EXPECT_EQ(formatObj(mesh).error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka
