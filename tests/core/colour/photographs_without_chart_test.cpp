#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "batch/photograph.h"
#include "colour/chart.h"

namespace ostraka::colour {
namespace {

// Among them a sheet of markers below a green apple on a red table, which mcc takes for a chart.
TEST(FindChart, FindsNoneInPhotographsThatShowNone) {
  const std::filesystem::path shared = OSTRAKA_SHARED_DIR;
  for (const char* folder : {"real/apple/photographs", "real/statue", "real/aruco", "real/charuco",
                             "batches/demo/front", "batches/light/back", "batches/hand/front"}) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(shared / folder))
      if (batch::hasPhotographEnding(entry.path())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ASSERT_FALSE(files.empty()) << folder;
    for (std::size_t i = 0; i < files.size(); i += 6) {
      const Result<cv::Mat> photograph = batch::readPhotograph(files[i]);
      ASSERT_TRUE(photograph.has_value()) << photograph.error().sentence();
      EXPECT_FALSE(findChart(*photograph).has_value()) << files[i];
    }
  }
}

}  // namespace
}  // namespace ostraka::colour
