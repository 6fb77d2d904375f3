#include "cloud/glb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/core/cloud/painted_tetrahedron.h"

namespace ostraka {
namespace {

template <class T>
T at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

struct Glb {
  nlohmann::json json;
  std::string binary;
};

Glb parts(const std::string& file) {
  EXPECT_EQ(file.substr(0, 4), "glTF");
  EXPECT_EQ(at<std::uint32_t>(file, 4), 2u);
  EXPECT_EQ(at<std::uint32_t>(file, 8), file.size());
  const std::uint32_t json_size = at<std::uint32_t>(file, 12);
  EXPECT_EQ(json_size % 4, 0u);
  EXPECT_EQ(file.substr(16, 4), "JSON");
  const std::size_t next = 20 + json_size;
  const std::uint32_t binary_size = at<std::uint32_t>(file, next);
  EXPECT_EQ(binary_size % 4, 0u);
  EXPECT_EQ(file.substr(next + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(next + 8 + binary_size, file.size());
  return {nlohmann::json::parse(file.substr(20, json_size)), file.substr(next + 8)};
}

// Offset of the first element of an attribute.
std::size_t begin(const Glb& glb, const char* attribute) {
  const int accessor = glb.json["meshes"][0]["primitives"][0]["attributes"][attribute];
  return glb
      .json["bufferViews"][glb.json["accessors"][accessor]["bufferView"].get<int>()]["byteOffset"];
}

TEST(Glb, PositionsAreMetresWithYUpAndExactBounds) {
  const auto file = formatGlb(paintedTetrahedron(), {});
  ASSERT_TRUE(file.has_value());
  const Glb glb = parts(*file);
  const std::size_t p = begin(glb, "POSITION");
  EXPECT_EQ(at<float>(glb.binary, p + 12), 0.04f);       // vertex 1: x stays x
  EXPECT_EQ(at<float>(glb.binary, p + 24 + 8), -0.03f);  // vertex 2: y becomes -z
  EXPECT_EQ(at<float>(glb.binary, p + 36 + 4), 0.02f);   // vertex 3: z becomes y
  const auto& accessor = glb.json["accessors"][0];
  EXPECT_EQ(accessor["max"][0].get<float>(), 0.04f);
  EXPECT_EQ(accessor["max"][1].get<float>(), 0.02f);
  EXPECT_EQ(accessor["min"][2].get<float>(), -0.03f);
  EXPECT_FALSE(glb.json["nodes"][0].contains("scale"));
  EXPECT_FALSE(glb.json["nodes"][0].contains("rotation"));
}

TEST(Glb, ColoursAreLinearSixteenBit) {
  const auto file = formatGlb(paintedTetrahedron(), {});
  ASSERT_TRUE(file.has_value());
  const Glb glb = parts(*file);
  const std::size_t c = begin(glb, "COLOR_0");
  EXPECT_EQ(at<std::uint16_t>(glb.binary, c), 65535);
  EXPECT_EQ(at<std::uint16_t>(glb.binary, c + 8), 0);
  // sRGB 188 of 255 is half the light: 0.5029.
  EXPECT_NEAR(at<std::uint16_t>(glb.binary, c + 16) / 65535.0, 0.5029, 1e-4);
  // sRGB 10 lies on the straight part: 10 / 255 / 12.92.
  EXPECT_NEAR(at<std::uint16_t>(glb.binary, c + 24) / 65535.0, 10 / 255.0 / 12.92, 1e-5);
  EXPECT_EQ(at<std::uint16_t>(glb.binary, c + 6), 65535);  // opaque
}

TEST(Glb, SeenFlagsIndicesAndExtrasAreThere) {
  const auto file = formatGlb(paintedTetrahedron(), {"uuid", "ARM1-0007", "The museum", 2.5});
  ASSERT_TRUE(file.has_value());
  const Glb glb = parts(*file);
  EXPECT_EQ(at<float>(glb.binary, begin(glb, "_SEEN") + 8), 0.0f);
  const int indices = glb.json["meshes"][0]["primitives"][0]["indices"];
  EXPECT_EQ(glb.json["accessors"][indices]["componentType"], 5123);
  EXPECT_EQ(glb.json["accessors"][indices]["count"], 12);
  EXPECT_EQ(glb.json["asset"]["version"], "2.0");
  EXPECT_EQ(glb.json["asset"]["copyright"], "The museum");
  EXPECT_EQ(glb.json["nodes"][0]["extras"]["ostraka"]["number"], "ARM1-0007");
  EXPECT_EQ(glb.json["nodes"][0]["extras"]["ostraka"]["filled_pct"], 2.5);
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], nlohmann::json::array({0}));
  EXPECT_EQ(glb.json["buffers"][0]["byteLength"], glb.binary.size());
  for (const auto& view : glb.json["bufferViews"]) EXPECT_EQ(view["byteOffset"].get<int>() % 4, 0);
}

TEST(Glb, ManyVerticesNeedLongIndices) {
  TriangleMesh mesh = paintedTetrahedron();
  mesh.normals.clear();
  mesh.colors.clear();
  mesh.seen.clear();
  mesh.vertices.resize(65536, Eigen::Vector3f(1, 1, 1));
  const auto file = formatGlb(mesh, {});
  ASSERT_TRUE(file.has_value());
  const Glb glb = parts(*file);
  EXPECT_EQ(glb.json["accessors"][glb.json["meshes"][0]["primitives"][0]["indices"].get<int>()]
                    ["componentType"],
            5125);
}

TEST(Glb, ATextureTakesThePlaceOfColours) {
  const GlbTexture texture{{{0, 0}, {1, 0}, {0, 1}, {0.25f, 0.75f}}, "a JPEG", "a PNG"};
  const auto file = formatGlb(paintedTetrahedron(), texture, {"", "ARM1-7", "", -1});
  ASSERT_TRUE(file.has_value());
  const Glb glb = parts(*file);
  const auto& attributes = glb.json["meshes"][0]["primitives"][0]["attributes"];
  EXPECT_FALSE(attributes.contains("COLOR_0")) << "readers multiply both";
  const std::size_t uv = begin(glb, "TEXCOORD_0");
  EXPECT_EQ(at<float>(glb.binary, uv + 24), 0.25f);
  EXPECT_EQ(at<float>(glb.binary, uv + 28), 0.75f);
  const auto imageAt = [&](int number) {
    const auto& view = glb.json["bufferViews"][glb.json["images"][number]["bufferView"].get<int>()];
    return glb.binary.substr(view["byteOffset"].get<std::size_t>(),
                             view["byteLength"].get<std::size_t>());
  };
  EXPECT_EQ(imageAt(0), "a JPEG");
  EXPECT_EQ(imageAt(1), "a PNG");
  EXPECT_EQ(glb.json["images"][0]["mimeType"], "image/jpeg");
  EXPECT_EQ(glb.json["textures"][0]["source"], 0);
  EXPECT_EQ(glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  EXPECT_EQ(glb.json["nodes"][0]["extras"]["ostraka"]["seen_image"], 1);
  EXPECT_EQ(glb.json["nodes"][0]["extras"]["ostraka"]["number"], "ARM1-7");
  EXPECT_FALSE(formatGlb(paintedTetrahedron(), {{{0, 0}}, "a JPEG", ""}, {}).has_value())
      << "a vertex without a place";
  EXPECT_EQ(writeGlb("nowhere/x.glb", formatGlb({}, {})).error().where, "nowhere/x.glb");
}

TEST(Glb, WrongMeshesAreRefused) {
  TriangleMesh mesh = paintedTetrahedron();
  mesh.triangles[0][0] = 4;
  EXPECT_EQ(formatGlb(mesh, {}).error().code, ErrorCode::UnusableInput);
  mesh.triangles.clear();
  EXPECT_EQ(formatGlb(mesh, {}).error().code, ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka
