#include "rig/sheet_bundle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rig/camera.h"

namespace ostraka::rig {
namespace {

// Nine markers of 20 mm, one of them turned, in photographs from five places with a lens of 1500
// pixels and some distortion; edges lie 0.4 px inside of the printed ones.
struct World {
  Intrinsics lens{1600, 1200, 1500, 1500, 810, 590, {0.05, -0.08, 0, 0, 0}};
  std::map<int, FlatMarker> markers;
  std::vector<SheetView> views;

  World() {
    for (int i = 0; i < 9; ++i) markers[i] = {35.0 * (i % 3), -42.0 * (i / 3), i == 4 ? 0.3 : 0.0};
    for (int v = 0; v < 5; ++v) {
      SheetView view{lens.width, lens.height, {}, Eigen::Isometry3d::Identity()};
      const double around = 1.3 * v, tilt = 0.3 + 0.15 * v;
      view.camera_from_sheet.linear() = (Eigen::AngleAxisd(M_PI - tilt, Eigen::Vector3d::UnitX()) *
                                         Eigen::AngleAxisd(around, Eigen::Vector3d::UnitZ()))
                                            .toRotationMatrix();
      view.camera_from_sheet.translation() =
          Eigen::Vector3d(0, 0, 300 + 15 * v) -
          view.camera_from_sheet.linear() * Eigen::Vector3d(35, -42, 0);
      for (const auto& [id, marker] : markers) view.markers.push_back(seen(id, view));
      views.push_back(view);
    }
  }

  SeenMarker seen(int id, const SheetView& view) const {
    Quad at;
    const auto flat = cornersOf(markers.at(id), 20);
    for (std::size_t c = 0; c < 4; ++c)
      at[c] = lens.project(view.camera_from_sheet * Eigen::Vector3d(flat[c].x(), flat[c].y(), 0));
    SeenMarker marker{id, at, 0.06};
    for (std::size_t c = 0; c < 4; ++c)
      marker.corners[c] +=
          0.4 * ((at[(c + 1) % 4] - at[c]).normalized() + (at[(c + 3) % 4] - at[c]).normalized());
    return marker;
  }
};

TEST(SheetBundle, FindsMarkersAndPosesFromAFalseLensAndAMisplacedStart) {
  const World world;
  SheetBundle sheet{20, 1.2, world.markers, world.views};
  for (auto& [id, marker] : sheet.markers)
    if (id > 0) marker = {marker[0] * 1.05 + 1, marker[1] * 0.97, marker[2] - 0.05};
  for (SheetView& view : sheet.views) view.camera_from_sheet.translation().z() *= 1.25;
  const SheetFit fit = fitSheet(sheet);
  ASSERT_TRUE(fit.converged);
  EXPECT_LT(fit.rms_px, 0.02);  // the priors hold the lens back by as much
  // 0.05 mm of 100 mm: what the priors of lens and focus leave open.
  for (const auto& [id, marker] : world.markers) {
    EXPECT_NEAR(sheet.markers.at(id)[0], marker[0], 0.05) << id;
    EXPECT_NEAR(sheet.markers.at(id)[1], marker[1], 0.05) << id;
    EXPECT_NEAR(sheet.markers.at(id)[2], marker[2], 0.001) << id;
  }
}

TEST(SheetBundle, NamesTheMarkerThatDoesNotLieOnTheSheet) {
  World world;
  for (SheetView& view : world.views)
    for (SeenMarker& seen : view.markers)
      if (seen.id == 8)  // on a box: it moves against the sheet from place to place
        for (Eigen::Vector2d& corner : seen.corners)
          corner.x() += 30 * std::sin(view.camera_from_sheet.translation().x());
  SheetBundle sheet{20, 1, world.markers, world.views};
  const SheetFit fit = fitSheet(sheet);
  ASSERT_TRUE(fit.converged);
  for (const auto& [id, rms] : fit.marker_rms_px)
    if (id != 8) {
      EXPECT_GT(fit.marker_rms_px.at(8), 6 * rms) << id;
    }
}

}  // namespace
}  // namespace ostraka::rig
