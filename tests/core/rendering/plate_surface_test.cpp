#include "rendering/plate_surface.h"

#include <gtest/gtest.h>

namespace ostraka::rendering {
namespace {

TEST(PlateSurface, IsOfFourColoursFromDarkToWhite) {
  float last = 0;
  for (const PlateColor color :
       {PlateColor::Dark, PlateColor::Grey, PlateColor::Light, PlateColor::White}) {
    const float felt = PlateSurface(color, 1).felt().y();
    EXPECT_GT(felt, 1.5f * last);
    EXPECT_LT(felt, 0.72f);  // marker paper's
    last = felt;
  }
}

}  // namespace
}  // namespace ostraka::rendering
