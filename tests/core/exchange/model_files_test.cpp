#include "exchange/model_files.h"

#include <gtest/gtest.h>

#include <cstring>

#include "cloud/glb.h"
#include "cloud/ply.h"

namespace ostraka::exchange {
namespace {

TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.colors = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {9, 9, 9}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

const ModelLabel kLabel = {"019f5ff6-39c0-7b3a-9c55-2f7e8d104ab6", "ARM1-T3-0012-0007", "CC-BY-4.0",
                           "ostraka 1.0.0", ""};

TEST(ModelFiles, ALabelledPlyNamesItsSherdAndHoldsTheSameSurface) {
  const Result<std::string> ply = labelledPly(formatPly(tetrahedron(), "plate_front"), kLabel, "m");
  ASSERT_TRUE(ply);
  EXPECT_NE(ply->find("comment ostraka 1.0.0 id 019f5ff6-39c0-7b3a-9c55-2f7e8d104ab6 number "
                      "ARM1-T3-0012-0007 licence CC-BY-4.0\n"),
            std::string::npos);
  EXPECT_NE(ply->find("comment unit mm\n"), std::string::npos);
  const Result<PlyContents> read = parsePly(*ply, "m");
  ASSERT_TRUE(read) << read.error().sentence();
  EXPECT_EQ(read->mesh.vertices, tetrahedron().vertices);
  EXPECT_EQ(read->mesh.triangles, tetrahedron().triangles);
  EXPECT_FALSE(labelledPly("no ply", kLabel, "m"));
}

TEST(ModelFiles, ALabelCannotBreakTheHeader) {
  ModelLabel evil = kLabel;
  evil.licence = "x\nelement vertex 1000000000";
  const Result<std::string> ply = labelledPly(formatPly(tetrahedron(), "f"), evil, "m");
  ASSERT_TRUE(ply);
  EXPECT_EQ(parsePly(*ply, "m")->mesh.vertices.size(), 4u);
}

TEST(ModelFiles, ALabelledGlbKeepsItsBuffersAndItsLengths) {
  const std::string glb = *formatGlb(tetrahedron(), {"f+b", "01", "", 3.5});
  const Result<std::string> labelled = labelledGlb(glb, kLabel, "m");
  ASSERT_TRUE(labelled) << labelled.error().sentence();
  EXPECT_NE(labelled->find("\"number\":\"ARM1-T3-0012-0007\""), std::string::npos);
  EXPECT_NE(labelled->find("\"copyright\":\"CC-BY-4.0\""), std::string::npos);
  EXPECT_NE(labelled->find("\"filled_pct\":3.5"), std::string::npos) << "what was there stays";
  EXPECT_EQ(labelled->find("\"number\":\"01\""), std::string::npos);
  const auto u32 = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, labelled->data() + at, 4);
    return value;
  };
  EXPECT_EQ(u32(8), labelled->size());
  EXPECT_EQ(u32(12) % 4, 0u);
  const std::size_t binary = 20 + u32(12);
  EXPECT_EQ(binary + 8 + u32(binary), labelled->size());
  EXPECT_TRUE(glb.ends_with(labelled->substr(binary))) << "the buffer is untouched";
}

TEST(ModelFiles, ALighterModelSaysHowFarItIsOff) {
  ModelLabel label = kLabel;
  label.deviation_mm = 0.047;
  label.farthest_mm = 0.2;
  const std::string ply = formatPly(tetrahedron(), "f");
  for (const Result<std::string>& file :
       {labelledPly(ply, label, "m"), labelledObj(ply, label, "m")}) {
    ASSERT_TRUE(file);
    EXPECT_NE(
        file->find(
            " simplified from the full-detail model: 99.9 % within 0.047 mm, all within 0.2 mm\n"),
        std::string::npos);
  }
  const auto glb = labelledGlb(*formatGlb(tetrahedron(), {}), label, "m");
  ASSERT_TRUE(glb);
  EXPECT_NE(glb->find("\"deviation_mm\":0.047,\"farthest_mm\":0.2"), std::string::npos);
  EXPECT_EQ(labelledPly(ply, kLabel, "m")->find("simplified from"), std::string::npos);
}

TEST(ModelFiles, StrangeGlbFilesAreRefused) {
  const std::string glb = *formatGlb(tetrahedron(), {});
  for (std::size_t size :
       {std::size_t{0}, std::size_t{11}, std::size_t{19}, std::size_t{40}, glb.size() - 1})
    EXPECT_FALSE(labelledGlb(std::string_view(glb).substr(0, size), kLabel, "m")) << size;
}

TEST(ModelFiles, AnObjIsMadeInMillimetres) {
  const Result<std::string> obj = labelledObj(formatPly(tetrahedron(), "f"), kLabel, "m");
  ASSERT_TRUE(obj);
  EXPECT_TRUE(obj->starts_with("# ostraka 1.0.0 id "));
  EXPECT_NE(obj->find("mm"), std::string::npos);
  EXPECT_NE(obj->find("\nf "), std::string::npos);
}

// Who measures on the file alone must see it, too.
TEST(ModelFiles, ADoubtfulScaleStandsInEachKindOfFileAndGoesWhenItIsSettled) {
  ModelLabel doubtful = kLabel;
  doubtful.scale_doubts = "50 mm measure 49.5 mm.\n80 mm measure 79.2 mm.";
  const std::string plain = formatPly(tetrahedron(), "plate_front");
  const Result<std::string> ply = labelledPly(plain, doubtful, "m");
  ASSERT_TRUE(ply);
  EXPECT_NE(ply->find("\ncomment measurements in doubt: 50 mm measure 49.5 mm.\ncomment "
                      "measurements in doubt: 80 mm measure 79.2 mm.\n"),
            std::string::npos);
  EXPECT_EQ(parsePly(*ply, "m")->mesh.vertices, tetrahedron().vertices);
  const Result<std::string> obj = labelledObj(plain, doubtful, "m");
  ASSERT_TRUE(obj);
  EXPECT_NE(obj->find("\n# measurements in doubt: 50 mm measure 49.5 mm.\n"), std::string::npos);
  const Result<std::string> glb = labelledGlb(*formatGlb(tetrahedron(), {}), doubtful, "m");
  ASSERT_TRUE(glb);
  EXPECT_NE(glb->find(R"("scale_doubts":"50 mm measure 49.5 mm.\n80 mm measure 79.2 mm.")"),
            std::string::npos);
  EXPECT_EQ(labelledPly(*ply, kLabel, "m")->find("in doubt"), std::string::npos);
  EXPECT_EQ(labelledGlb(*glb, kLabel, "m")->find("scale_doubts"), std::string::npos);
  EXPECT_EQ(labelledPly(plain, kLabel, "m")->find("in doubt"), std::string::npos);
}

}  // namespace
}  // namespace ostraka::exchange
