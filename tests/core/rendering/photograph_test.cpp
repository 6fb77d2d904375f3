#include "rendering/photograph.h"

#include <gtest/gtest.h>

#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "virtualrig/setup.h"

namespace ostraka::rendering {
namespace {

TEST(Photograph, ShowsTheMarkersWhereTheTrueCameraProjectsThem) {
  vessels::Random random(21);
  const virtualrig::VirtualRig rig = virtualrig::makeRig(1000, 4, random);
  const Lighting lighting = makeLighting(random);
  const PlateSurface surface(PlateColor::Grey, 3);
  const std::vector<vessels::VirtualSherd> none;
  const Scene scene(none, {});
  const int stop = 1;
  const Lighting room_plate = turned(lighting, rig.angles_rad[stop]);
  const AmbientField ambient = gatherAmbient(scene, lighting, surface, 1, {.threads = 1});
  const LightField light = castShadows(scene, room_plate, 2, 1);
  const batch::Plate plate = standardPlate();
  for (int camera = 0; camera < virtualrig::kCameras; ++camera) {
    const rig::Intrinsics& k = rig.intrinsics[static_cast<std::size_t>(camera)];
    const Eigen::Isometry3d camera_from_plate = rig.cameraFromPlate(camera, stop);
    const PlateBackdrop backdrop(room_plate, light, ambient, surface, rig.angles_rad[stop]);
    const View view{scene, room_plate, light, ambient, backdrop, camera_from_plate};
    const Photograph shot = photograph(view, LensRays(k), Sensor(), 7, {});
    EXPECT_EQ(cv::countNonZero(shot.labels), 0);
    cv::Mat grey;
    cv::cvtColor(shot.image, grey, cv::COLOR_BGR2GRAY);
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> ids;
    auto parameters = cv::aruco::DetectorParameters::create();
    parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
    parameters->cornerRefinementWinSize = 2;  // wider ones reach a far marker's other edges
    cv::aruco::detectMarkers(grey, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_100),
                             corners, ids, parameters);
    EXPECT_EQ(ids.size(), 24u) << camera;
    // Light paper spreads over black alike on all four sides: corners may lie inside by some tenths
    // of a pixel, the mean of the four may not. 24 markers of SD 0.06 px: 0.04 px is 3 sigma.
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      Eigen::Vector2d off = Eigen::Vector2d::Zero();
      for (std::size_t c = 0; c < 4; ++c)
        off += Eigen::Vector2d(corners[i][c].x, corners[i][c].y) -
               k.project(camera_from_plate *
                         plate.markers[static_cast<std::size_t>(ids[i])].corners[c]);
      EXPECT_LT((off / 4).norm(), 0.3) << camera << " marker " << ids[i];
      mean += off / 4 / static_cast<double>(ids.size());
    }
    EXPECT_LT(mean.norm(), 0.04) << camera;
  }
}

// A pyramid of 60 mm, its colour as if painted, seen from above.
TEST(Photograph, ShowsAThingInItsOwnColours) {
  vessels::VirtualSherd thing;
  thing.mesh.vertices = {{-30, -30, 0}, {30, -30, 0}, {30, 30, 0}, {-30, 30, 0}, {0, 0, 10}};
  thing.mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}};
  thing.mesh.colors.assign(5, {40, 60, 200});
  thing.places.resize(5);
  thing.clay.body = {0.5F, 0.3F, 0.2F};  // red clay, which is not to be seen
  const std::vector<vessels::VirtualSherd> things{thing};
  const Scene scene(things, {Eigen::Isometry3d::Identity()});
  vessels::Random random(21);
  const Lighting lighting = makeLighting(random);
  const PlateSurface surface(PlateColor::Grey, 3);
  const AmbientField ambient = gatherAmbient(scene, lighting, surface, 1, {.threads = 1});
  const LightField light = castShadows(scene, lighting, 2, 1);
  const PlateBackdrop backdrop(lighting, light, ambient, surface, 0);
  rig::Intrinsics k;
  k.width = 80, k.height = 60, k.fx = k.fy = 150, k.cx = 39.5, k.cy = 29.5;
  const View view{scene,   lighting, light,
                  ambient, backdrop, virtualrig::lookingAt({0, -60, 300}, {0, 0, 0}, 0)};
  const Photograph shot = photograph(view, LensRays(k), Sensor(), 7, {});
  EXPECT_GT(cv::countNonZero(shot.labels), 500);
  const cv::Scalar mean = cv::mean(shot.image, shot.labels);
  EXPECT_GT(mean[0], 1.8 * mean[2]);  // blue; clay would be red
}

}  // namespace
}  // namespace ostraka::rendering
