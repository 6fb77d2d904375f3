#include "torture.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace ostraka::capture::testing {
namespace {

class Torture : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Driver, Torture, ::testing::Values("grbl", "comxim1", "comxim2"));

// tests/bench runs a thousand stops of each driver; here a few, with more going wrong at each.
TEST_P(Torture, LosesDoublesAndMisnamesNoPhotograph) {
  TortureOptions options;
  options.driver = GetParam();
  options.stops = 16;
  options.cameras = 1;
  options.seed = 7;
  options.table_trouble = 0.03;
  options.camera_trouble = 0.04;
  options.folder = std::filesystem::temp_directory_path() /
                   ("ostraka_torture_" + options.driver + std::to_string(::getpid()));
  const TortureCount count = torture(options);
  EXPECT_EQ(count.stops, 16);
  EXPECT_EQ(count.photographs, 16);
  EXPECT_EQ(count.lost, 0);
  EXPECT_EQ(count.doubled, 0);
  EXPECT_EQ(count.misnamed, 0);
  EXPECT_EQ(count.wrong_end, 0);
  EXPECT_EQ(count.given_up, 0);
  EXPECT_GT(count.refused + count.troubles + count.resumed, 0) << "nothing went wrong at all";
}

}  // namespace
}  // namespace ostraka::capture::testing
