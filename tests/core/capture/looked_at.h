#pragma once
#include <gtest/gtest.h>

#include "capture/shot_checks.h"
#include "tests/core/capture/flat_rig.h"

namespace ostraka::capture {

inline PlateInspection lookAt(const testing::FlatScene& scene, int camera, double degrees) {
  const auto inspection =
      inspectPlate(testing::flatPicture(scene, camera, degrees, ""), testing::flatPlate(), {});
  EXPECT_TRUE(inspection.has_value());
  return inspection ? *inspection : PlateInspection{};
}

}  // namespace ostraka::capture
