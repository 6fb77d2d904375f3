#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "cloud/glb.h"
#include "tests/core/cloud/painted_tetrahedron.h"

namespace ostraka {
namespace {

const GlbTexture kPainting{{{0, 0}, {1, 0}, {0, 1}, {0.25f, 0.75f}}, "a JPEG", "a PNG"};

TEST(GlbRead, ATextureIsReadAsItWasWritten) {
  const auto read =
      parseTexturedGlb(*formatGlb(paintedTetrahedron(), kPainting, {"", "ARM1-7", "", -1}), "a");
  ASSERT_TRUE(read) << read.error().sentence();
  ASSERT_TRUE(read->has_value());
  const TexturedModel& model = **read;
  const TriangleMesh truth = paintedTetrahedron();
  ASSERT_EQ(model.mesh.vertices.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT((model.mesh.vertices[i] - truth.vertices[i]).norm(), 1e-5f) << i;
    EXPECT_EQ(model.mesh.normals[i], truth.normals[i]);
  }
  EXPECT_EQ(model.mesh.triangles, truth.triangles);
  EXPECT_EQ(model.mesh.seen, truth.seen);
  EXPECT_EQ(model.texture.uv, kPainting.uv);
  EXPECT_EQ(model.texture.jpeg, "a JPEG");
  EXPECT_EQ(model.texture.seen_png, "a PNG");
  const auto plain = parseTexturedGlb(*formatGlb(truth, {}), "a");
  ASSERT_TRUE(plain);
  EXPECT_FALSE(plain->has_value());
}

// The same bytes with one piece of the JSON replaced by another of its length.
std::string withText(std::string glb, const std::string& text, std::string other) {
  const std::size_t at = glb.find(text);
  EXPECT_NE(at, std::string::npos) << text;
  EXPECT_LE(other.size(), text.size());
  other.resize(text.size(), ' ');
  return glb.replace(at, text.size(), other);
}

TEST(GlbRead, AStrangersTextureIsReadOnlyFromTheFilesOwnBytes) {
  const std::string glb = *formatGlb(paintedTetrahedron(), kPainting, {});
  for (std::size_t size = 0; size < glb.size(); size += 7)
    EXPECT_FALSE(parseTexturedGlb(std::string_view(glb).substr(0, size), "a")) << size;
  const char* const image = R"("bufferView":5,"mimeType":"image/jpeg")";
  for (const auto& [text, other] :
       {std::pair(image, R"("uri":"/etc/passwd")"), std::pair(image, R"("bufferView":99)"),
        std::pair(image, R"("bufferView":-1)"),
        std::pair(R"("byteLength":48)", R"("byteLength":47)"),
        std::pair(R"("count":4)", R"("count":5)"), std::pair(R"("count":12)", R"("count":11)"),
        std::pair(R"("componentType":5126)", R"("componentType":5120)"),
        std::pair(R"("type":"VEC3")", R"("type":"VEC2")"),
        std::pair(R"("byteOffset":48)", R"("byteOffset":-8)"),
        std::pair(R"("metallicFactor":0)", R"("metallicFactor":)"),
        std::pair(R"("buffer":0)", R"("buffer":1)"), std::pair(R"("mesh":0,)", R"("skin":0,)")})
    EXPECT_FALSE(parseTexturedGlb(withText(glb, text, other), "a")) << other;
  TriangleMesh far = paintedTetrahedron();
  far.vertices[1].x() = NAN;
  EXPECT_FALSE(parseTexturedGlb(*formatGlb(far, kPainting, {}), "a"));
}

TEST(GlbRead, ProposedMunsellColoursAreReadFromTheHeadAlone) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "munsell.glb";
  GlbExtras extras;
  extras.munsell = R"({"chart":null})";
  const std::string whole = *formatGlb(paintedTetrahedron(), kPainting, extras);
  const auto read = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    return extrasInGlb(file).munsell;
  };
  EXPECT_EQ(read(whole), extras.munsell);
  EXPECT_EQ(read(whole.substr(0, whole.size() - 50)), extras.munsell) << "the picture is not read";
  EXPECT_EQ(read(*formatGlb(paintedTetrahedron(), {})), "");
  EXPECT_EQ(read(whole.substr(0, 100)), "");
  EXPECT_EQ(read(""), "");
  std::filesystem::remove(file);
  EXPECT_EQ(extrasInGlb(file).munsell, "");
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  EXPECT_EQ(extrasInGlb(file).munsell, "") << "nobody writes into the pipe";
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace ostraka
