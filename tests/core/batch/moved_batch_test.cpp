#include "batch/moved_batch.h"

#include <gtest/gtest.h>

#include <fstream>

#include "review/live_pairs.h"
#include "review/plate_map.h"
#include "tests/core/files/temporary_folder.h"
#include "tests/core/pipeline/synthetic_out.h"

namespace ostraka::batch {
namespace {

namespace fs = std::filesystem;

class MovedBatch : public testing::Test {
 protected:
  TemporaryFolder temporary_;
  fs::path folder = temporary_.path();
};

TEST_F(MovedBatch, ItsPhotographsAreFoundBesideTheResults) {
  const fs::path then = folder / "then/results/B0001", now = folder / "elsewhere/results/B0001";
  pipeline::writeSyntheticOut(then, {});
  const std::string photograph = (then / "photographs/front.png").string();
  EXPECT_EQ(photographNow(photograph, then), photograph) << "nothing has moved";
  fs::create_directories(folder / "then/batches/B0001");
  fs::rename(then / "photographs", folder / "then/batches/B0001/photographs");
  fs::rename(folder / "then", folder / "elsewhere");
  const fs::path found = folder / "elsewhere/batches/B0001/photographs/front.png";
  EXPECT_EQ(photographNow(photograph, now), found);
  EXPECT_EQ(photographNow(photograph, now / ""), found) << "with a slash at its end";
  const auto live = review::LivePairs::open(now);
  ASSERT_TRUE(live.has_value()) << live.error().sentence();
  const auto map = review::plateMap(**live, {});
  ASSERT_TRUE(map.has_value()) << map.error().sentence();
  EXPECT_EQ(map->front.photograph, found);
  EXPECT_TRUE((*live)->view(0, 0, Eigen::Isometry3d::Identity()).has_value());
}

TEST_F(MovedBatch, ACopyUsesItsOwnPhotographs) {
  const fs::path then = folder / "then/batches/B0001/front/cam0_pos00.jpg";
  fs::create_directories(then.parent_path());
  std::ofstream(then) << "JPEG";
  fs::copy(folder / "then", folder / "copy", fs::copy_options::recursive);
  EXPECT_EQ(photographNow(then.string(), folder / "copy/results/B0001"),
            folder / "copy/batches/B0001/front/cam0_pos00.jpg");
}

TEST_F(MovedBatch, APhotographThatIsGoneKeepsItsName) {
  EXPECT_EQ(photographNow("/gone/front/cam0_pos00.jpg", folder), "/gone/front/cam0_pos00.jpg");
}

}  // namespace
}  // namespace ostraka::batch
