#include "rig/lenses.h"

#include <gmock/gmock.h>

namespace ostraka::rig {
namespace {

TEST(Lenses, AreSharedByPhotographsOfOneSizeWithoutAWordFromTheCamera) {
  std::vector<batch::Shot> shots(4);
  for (batch::Shot& shot : shots) shot.width = 4000, shot.height = 3000, shot.file = "/nowhere.jpg";
  shots[1].width = 3000, shots[1].height = 4000;  // turned, or of another camera: nothing tells
  EXPECT_THAT(lensesOf(shots), testing::ElementsAre(0, 1, 0, 0));
}

}  // namespace
}  // namespace ostraka::rig
