#include "virtualrig/predict.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "virtualrig/setup.h"

namespace ostraka::virtualrig {
namespace {

namespace fs = std::filesystem;

// A rig as a calibration would have found it.
rig::Rig calibrated(int width, int stops) {
  Random random(5);
  const VirtualRig real = makeRig(width, stops, random);
  rig::Rig rig;
  for (int c = 0; c < real.cameras(); ++c) {
    const auto i = static_cast<std::size_t>(c);
    rig.cameras.push_back({c, real.intrinsics[i], real.camera_from_room[i], 0, 0, 0, {}});
  }
  for (int s = 0; s < stops; ++s) {
    rig.stops.push_back(s);
    rig.stop_angles_rad.push_back(real.angles_rad[static_cast<std::size_t>(s)]);
  }
  return rig;
}

class Predict : public ::testing::Test {
 protected:
  Predict() {
    fs::remove_all(work_);
    options_.work = work_;
    options_.sherds_per_size = 1;
  }
  ~Predict() override { fs::remove_all(work_); }

  fs::path work_ = fs::temp_directory_path() / ("ostraka_predict_" + std::to_string(::getpid()));
  PredictOptions options_;
  QuietProgress quiet_;
};

TEST_F(Predict, TellsAccuracyCompletenessAndTimeForSherdsOfThreeSizes) {
  options_.width = 480;
  const auto found = predict(calibrated(1920, 6), options_, quiet_, {});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_EQ(found->photographs, 36);
  EXPECT_DOUBLE_EQ(found->width_share, 0.25);
  EXPECT_GT(found->seconds, 0);
  EXPECT_DOUBLE_EQ(found->expectedSeconds(), 16 * found->seconds);
  EXPECT_EQ(found->cameras, (std::vector<int>{0, 1, 2}));
  ASSERT_EQ(found->pixels_mm.size(), 3u);
  for (const double size : found->pixels_mm) EXPECT_NEAR(size, 0.24, 0.05);  // 450 mm over 1920
  const std::array<double, 3> widths{26, 48, 82};
  for (std::size_t k = 0; k < 3; ++k) {
    const SizePrediction& size = found->sizes[k];
    EXPECT_EQ(size.sherds, 1);
    EXPECT_NEAR(size.width_mm, widths[k], 0.3 * widths[k]) << size.name;
    EXPECT_GT(size.seen, 0.9) << size.name;
    EXPECT_LE(size.break_seen, 1) << size.name;
  }
  // 0.9 mm a pixel is a trial only; the large one comes through it all the same.
  const SizePrediction& large = found->sizes[2];
  EXPECT_EQ(large.without_model, 0);
  EXPECT_GT(large.completeness_percent, 30);
  EXPECT_GT(large.accuracy_mm, 0.02);
  EXPECT_LT(large.accuracy_mm, 1.5);
  EXPECT_DOUBLE_EQ(found->expectedAccuracy(large), 0.25 * large.accuracy_mm);
}

TEST_F(Predict, RefusesWhatIsNoRig) {
  EXPECT_EQ(predict({}, options_, quiet_, {}).error().code, ErrorCode::UnusableInput);
  options_.width = 401;
  EXPECT_EQ(predict(calibrated(800, 8), options_, quiet_, {}).error().code,
            ErrorCode::UnusableInput);
}

}  // namespace
}  // namespace ostraka::virtualrig
