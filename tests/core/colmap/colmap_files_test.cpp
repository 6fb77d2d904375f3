#include "colmap/colmap_files.h"

#include <gmock/gmock.h>

#include <cmath>

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

TEST(ColmapCamera, KeepsRationalTermsAndFisheyes) {
  rig::Intrinsics i = rig::lens(2600);
  i.distortion = {{0.9, 0.1, 0.001, -0.002, 0.3, 1, 0.2, -0.1}, rig::Lens::Full};
  EXPECT_EQ(toColmap(i, 1).model, 6);
  EXPECT_EQ(fromColmap(toColmap(i, 1))->distortion, i.distortion);
  i.distortion = {{0.03, -0.01, 0.004, -0.001}, rig::Lens::Fisheye};
  EXPECT_EQ(toColmap(i, 1).model, 5);
  EXPECT_EQ(fromColmap(toColmap(i, 1))->distortion, i.distortion);
}

TEST(ColmapCamera, ReadsTheFisheyesThatOursIs) {
  ColmapCamera camera = toColmap(rig::lens(2600), 1);
  camera.model = 8;
  camera.parameters = {900, 800.5, 600.5, 0.02};
  auto lens = fromColmap(camera);
  ASSERT_TRUE(lens);
  EXPECT_EQ(lens->fy, 900);
  EXPECT_EQ(lens->cy, 600);
  EXPECT_EQ(lens->distortion, (rig::Distortion{{0.02}, rig::Lens::Fisheye}));
  camera.model = 9;
  camera.parameters = {900, 800.5, 600.5, 0.02, -0.01};
  EXPECT_EQ(fromColmap(camera)->distortion, (rig::Distortion{{0.02, -0.01}, rig::Lens::Fisheye}));
  // fx fy cx cy k1 k2 p1 p2 k3 k4 sx1 sy1
  camera.model = 10;
  camera.parameters = {900, 890, 800.5, 600.5, 0.02, -0.01, 0, 0, 0.004, -0.001, 0, 0};
  EXPECT_EQ(fromColmap(camera)->distortion,
            (rig::Distortion{{0.02, -0.01, 0.004, -0.001}, rig::Lens::Fisheye}));
}

TEST(ColmapCamera, RefusesWhatIsNoLensOfOurs) {
  ColmapCamera camera = toColmap(rig::lens(2600), 1);
  const auto refusal = [&](int model, std::vector<double> parameters) {
    camera.model = model;
    camera.parameters = std::move(parameters);
    const auto lens = fromColmap(camera);
    return lens ? std::string() : lens.error().sentence().english();
  };
  EXPECT_THAT(refusal(10, {900, 890, 800, 600, 0.02, 0, 0, 0.001, 0, 0, 0, 0}),
              testing::HasSubstr("THIN_PRISM_FISHEYE"));
  EXPECT_THAT(refusal(7, {900, 890, 800, 600, 0.9}), testing::HasSubstr("'FOV'"));
  EXPECT_NE(refusal(4, {900, 890, 800, 600, NAN, 0, 0, 0}), "");
  EXPECT_NE(refusal(6, {900, 890, 800, 600, -100, 0, 0, 0, 0, 1, 0, 0}), "") << "folds at 0.04";
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
