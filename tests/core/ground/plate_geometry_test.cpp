#include "ground/plate_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ostraka::ground {
namespace {

batch::Plate ringPlate() {
  batch::Plate plate;
  plate.diameter_mm = 200;
  const double r = 80, h = 6;
  plate.markers.push_back({0, {{{r + h, h, 0}, {r + h, -h, 0}, {r - h, -h, 0}, {r - h, h, 0}}}});
  return plate;
}

rig::PosedImage tiltedCamera() {
  rig::PosedImage image;
  image.intrinsics = {400, 300, 500, 500, 199.5, 149.5, {-0.05, 0.01, 0, 0, 0}};
  // Looks down by 40 degrees at the origin from 300 mm.
  image.camera_from_plate.linear() = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) *
                                      Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitX()))
                                         .toRotationMatrix();
  image.camera_from_plate.translation() = Eigen::Vector3d(0, 0, 300);
  return image;
}

TEST(PlateGeometry, GridPixelsAndPixelCellsAreEachOthersInverse) {
  const rig::PosedImage image = tiltedCamera();
  const PlateGrid grid = gridOver(ringPlate(), millimetresPerPixel(image));
  const cv::Mat2f cells = gridOfPixels(image, grid);
  const cv::Mat2f pixels = pixelsOfGrid(image, grid);
  const int column = static_cast<int>(grid.middle()) + 13,
            row = static_cast<int>(grid.middle()) - 21;
  const Eigen::Vector3d p((column - grid.middle()) * grid.pitch_mm,
                          (row - grid.middle()) * grid.pitch_mm, 0);
  const Eigen::Vector2d exact = image.project(p);
  EXPECT_NEAR(pixels(row, column)[0], exact.x(), 0.02);
  EXPECT_NEAR(pixels(row, column)[1], exact.y(), 0.02);
  const int x = cvRound(exact.x()), y = cvRound(exact.y());
  const Eigen::Vector2d n =
      image.intrinsics.unproject({static_cast<double>(x), static_cast<double>(y)});
  const Eigen::Isometry3d back = image.camera_from_plate.inverse();
  const Eigen::Vector3d ray = back.linear() * n.homogeneous();
  const Eigen::Vector3d hit = back.translation() - back.translation().z() / ray.z() * ray;
  EXPECT_NEAR(cells(y, x)[0], hit.x() / grid.pitch_mm + grid.middle(), 0.02);
  EXPECT_NEAR(cells(y, x)[1], hit.y() / grid.pitch_mm + grid.middle(), 0.02);
}

TEST(PlateGeometry, TheRingBeginsOneModuleInsideTheMarkers) {
  // Marker 12 mm, module 2 mm, inner side at 74 mm.
  EXPECT_NEAR(gridOver(ringPlate(), 0.25).ring_inner_mm, 72, 1e-9);
}

TEST(PlateGeometry, AMarkerInTheMiddleOfAPlateEndsNoRing) {
  batch::Plate plate = ringPlate();
  const double h = 6;
  plate.markers.push_back({1, {{{-h, h, 0}, {h, h, 0}, {h, -h, 0}, {-h, -h, 0}}}});
  EXPECT_NEAR(gridOver(plate, 0.25).ring_inner_mm, 72, 1e-9);
}

// The circle through its markers is all that such a plate.json says of a diameter.
TEST(PlateGeometry, TheGridHoldsAllOfASheetWhoseMarkersLieInItsMiddle) {
  batch::Plate plate;
  const double h = 10;
  plate.markers.push_back({1, {{{-h, h, 0}, {h, h, 0}, {h, -h, 0}, {-h, -h, 0}}}});
  plate.diameter_mm = 2 * std::hypot(h, h);
  plate.sheet = Eigen::AlignedBox2d(Eigen::Vector2d(-148, -105), Eigen::Vector2d(148, 105));
  const PlateGrid grid = gridOver(plate, 0.2);
  EXPECT_GE(grid.pitch_mm * grid.middle(), 148);
}

TEST(PlateGeometry, MarkerPaperReachesOneModuleBeyondTheMarker) {
  const PlateGrid grid = gridOver(ringPlate(), 0.25);
  const cv::Mat1b paper = markerPaper(ringPlate(), grid);
  const auto at = [&](double x, double y) {
    return paper(cvRound(y / grid.pitch_mm + grid.middle()),
                 cvRound(x / grid.pitch_mm + grid.middle()));
  };
  EXPECT_EQ(at(80, 0), 255);
  EXPECT_EQ(at(87.4, 7.4), 255);
  EXPECT_EQ(at(88.8, 0), 0);
  EXPECT_EQ(at(71.2, 0), 0);
}

}  // namespace
}  // namespace ostraka::ground
