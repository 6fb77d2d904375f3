#include "colmap/colmap_files.h"

#include <gmock/gmock.h>

#include "colmap/colmap_format.h"
#include "tests/core/rig/simulated_rig.h"

namespace ostraka::colmap {
namespace {

TEST(ColmapCamera, ShiftsThePixelCentreByAHalf) {
  const rig::Intrinsics i = rig::lens(2600);
  const ColmapCamera camera = toColmap(i, 1);
  EXPECT_EQ(camera.parameters[2], i.cx + 0.5);
  const auto back = fromColmap(camera);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->cx, i.cx);
  EXPECT_EQ(back->distortion, i.distortion);
}

TEST(ColmapCamera, KeepsK3AsFullOpenCv) {
  rig::Intrinsics i = rig::lens(2600);
  i.distortion[4] = 0.1;
  const ColmapCamera camera = toColmap(i, 1);
  EXPECT_EQ(camera.model, 6);
  EXPECT_EQ(camera.parameters.size(), 12U);
  EXPECT_EQ(fromColmap(camera)->distortion, i.distortion);
}

TEST(ColmapCamera, RefusesFisheyes) {
  ColmapCamera camera = toColmap(rig::lens(2600), 1);
  camera.model = 5;
  ASSERT_FALSE(fromColmap(camera).has_value());
  EXPECT_THAT(fromColmap(camera).error().what, testing::HasSubstr("OPENCV_FISHEYE"));
}

TEST(ColmapModel, OfAnUnknownNumberHasNeitherNameNorParameters) {
  EXPECT_STREQ(colmapModelName(4), "OPENCV");
  EXPECT_EQ(colmapParameterCount(4), 8);
  for (const int unknown : {-1, 11}) {
    EXPECT_STREQ(colmapModelName(unknown), "");
    EXPECT_EQ(colmapParameterCount(unknown), 0);
  }
}

}  // namespace
}  // namespace ostraka::colmap
