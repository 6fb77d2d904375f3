#include "checks/scale_source.h"

#include <gtest/gtest.h>

namespace ostraka::checks {
namespace {

batch::Marker markerOf(int id, double side_mm) {
  return {id, {Eigen::Vector3d{0, side_mm, 0}, {side_mm, side_mm, 0}, {side_mm, 0, 0}, {0, 0, 0}}};
}

TEST(ScaleSource, IsTheSideOfTheMarkersAndWhoSaysSo) {
  batch::Batch batch;
  batch.plate.emplace().markers = {markerOf(1, 20), markerOf(2, 20)};
  batch.plate_file = "plate.json";
  EXPECT_EQ(scaleSource(batch, true).english(), "Scale: markers of 20.00 mm, as in plate.json.");
  batch.plate = batch::withMarkerSide(*batch.plate, 18);
  EXPECT_EQ(scaleSource(batch, true).english(), "Scale: markers of 18 mm, as typed at the import.");
  batch.plate->markers.push_back(markerOf(3, 40));
  batch.plate->typed_marker_mm.reset();
  EXPECT_EQ(scaleSource(batch, true).english(), "Scale: the markers that plate.json describes.");
}

TEST(ScaleSource, IsSaidToBeMissing) {
  batch::Batch batch;
  batch.plate.emplace().markers = {markerOf(1, 30)};
  EXPECT_EQ(scaleSource(batch, false).english(),
            "Scale: none; lengths in mm are based on a guess.");
}

TEST(ScaleSource, IsALengthWhereThereAreNoMarkers) {
  batch::Batch batch;
  EXPECT_EQ(scaleSource(batch, true).english(), "Scale: the board of board.json.");
  batch.known_lengths.push_back({batch::Side::Front, 50, {}});
  EXPECT_EQ(scaleSource(batch, true).english(), "Scale: the lengths marked in scale.json.");
}

}  // namespace
}  // namespace ostraka::checks
