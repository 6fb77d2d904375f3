#include "calibration/calibrate.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <opencv2/imgcodecs.hpp>

#include "rig/marker_dictionary.h"

namespace ostraka::calibration {
namespace {

TEST(PoseBatch, SaysThatThereIsNoPlate) {
  QuietProgress quiet;
  const auto poses = poseBatch({}, {}, {}, quiet, {});
  ASSERT_FALSE(poses.has_value());
  EXPECT_EQ(poses.error().code, ErrorCode::NotEnough);
  EXPECT_THAT(poses.error().what, testing::HasSubstr("plate.json"));
}

batch::Batch batchWithoutMarkers(const std::filesystem::path& picture) {
  cv::imwrite(picture.string(), cv::Mat(60, 80, CV_8UC3, cv::Scalar(20, 20, 20)));
  batch::Batch batch;
  batch.folder = picture.parent_path();
  batch::Marker marker;
  marker.id = 1;
  marker.corners = {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(1, 0, 0),
                    Eigen::Vector3d(0, 0, 0)};
  batch.plate.emplace();
  batch.plate->dictionary = "DICT_4X4_100";
  batch.plate->diameter_mm = 300;
  batch.plate->markers = {marker};
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back})
    for (int stop = 0; stop < 3; ++stop)
      batch.shots.push_back({side, 0, stop, picture, {}, 80, 60});
  return batch;
}

TEST(PoseBatch, SaysWhatToDoWhenNoMarkerIsFound) {
  const auto picture =
      std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "-dark.png");
  const batch::Batch batch = batchWithoutMarkers(picture);
  QuietProgress quiet;
  const auto poses = poseBatch(batch, {}, {}, quiet, {});
  ASSERT_FALSE(poses.has_value());
  EXPECT_EQ(poses.error().code, ErrorCode::NotEnough);
  EXPECT_THAT(poses.error().what, testing::HasSubstr("add pictures of the board"));
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(poseBatch(batch, {}, {}, quiet, source.get_token()).error().code, ErrorCode::Cancelled);
  std::filesystem::remove(picture);
}

TEST(MarkerDictionary, RefusesAnUnknownName) {
  EXPECT_TRUE(rig::markerDictionary("DICT_6X6_1000").has_value());
  EXPECT_THAT(rig::markerDictionary("DICT_9X9").error().what, testing::HasSubstr("DICT_9X9"));
}

}  // namespace
}  // namespace ostraka::calibration
