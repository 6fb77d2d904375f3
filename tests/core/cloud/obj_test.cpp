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

TEST(Obj, APictureHasItsPlacesFromTheLowerLeftCornerAndTakesThePlaceOfColours) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1.5f, 0, 0}, {0, -2, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.colors.assign(3, {255, 0, 51});
  mesh.triangles = {{0, 1, 2}};
  const auto text = formatObj(mesh, {{0, 0}, {1, 0.25f}, {0.5f, 1}}, "a.mtl");
  ASSERT_TRUE(text.has_value());
  EXPECT_EQ(*text,
            "# Ostraka, unit mm\nmtllib a.mtl\nv 0 0 0\nv 1.5 0 0\nv 0 -2 0\n"
            "vt 0 1\nvt 1 0.75\nvt 0.5 0\nusemtl photographs\n"
            "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1/1/1 2/2/2 3/3/3\n");
  EXPECT_EQ(formatMtl("a.png"),
            "newmtl photographs\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd a.png\n");
  EXPECT_FALSE(formatObj(mesh, {{0, 0}}, "a.mtl")) << "a vertex without a place";
}

TEST(Obj, AnAbsentVertexIsRefused) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}};
  mesh.triangles = {{0, 0, 1}};
  EXPECT_EQ(formatObj(mesh).error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka
