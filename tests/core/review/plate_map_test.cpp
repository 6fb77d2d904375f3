#include "review/plate_map.h"

#include <gtest/gtest.h>

#include "cloud/ply.h"
#include "tests/core/files/temporary_folder.h"
#include "tests/core/pipeline/synthetic_out.h"

namespace ostraka::review {
namespace {

namespace fs = std::filesystem;

class PlateMaps : public testing::Test {
 protected:
  PointCloud frontCloud(std::size_t i) const {
    const auto cloud = readPlyCloud(out.output / "work" / out.table.front_files[i]);
    EXPECT_TRUE(cloud.has_value());
    return cloud ? *cloud : PointCloud{};
  }
  // Of one scan on the front: the middles of its parts, pixels.
  std::vector<Eigen::Vector2d> partsOf(int scan) const {
    std::vector<Eigen::Vector2d> parts;
    const auto live = LivePairs::open(out.output);
    EXPECT_TRUE(live.has_value());
    const auto map = plateMap(**live, {});
    EXPECT_TRUE(map.has_value());
    for (const MapMark& mark : map->front.marks)
      if (mark.scan == scan) {
        EXPECT_EQ(mark.part, static_cast<int>(parts.size()));
        EXPECT_GT(mark.outline.size(), 20u);
        parts.push_back(mark.at);
      }
    return parts;
  }
  TemporaryFolder temporary_;
  fs::path folder = temporary_.path();
  pipeline::SyntheticOut out = pipeline::writeSyntheticOut(folder / "out", {});
};

TEST_F(PlateMaps, APieceThatWasJoinedHasItsNumberOnEachOfItsParts) {
  const std::vector<Eigen::Vector2d> first = partsOf(0), second = partsOf(1);
  ASSERT_EQ(first.size(), 1u);
  ASSERT_EQ(second.size(), 1u);
  PointCloud joined = frontCloud(0);
  const PointCloud other = frontCloud(1);
  joined.normals.clear();
  joined.colors.clear();
  joined.quality.clear();
  joined.points.insert(joined.points.end(), other.points.begin(), other.points.end());
  ASSERT_TRUE(writePly(out.output / "work" / out.table.front_files[0], joined, "plate_front"));
  const std::vector<Eigen::Vector2d> parts = partsOf(0);
  ASSERT_EQ(parts.size(), 2u);
  const bool turned = (parts[0] - first[0]).norm() > (parts[1] - first[0]).norm();
  EXPECT_LT((parts[turned ? 1 : 0] - first[0]).norm(), 10);
  EXPECT_LT((parts[turned ? 0 : 1] - second[0]).norm(), 10);
}

}  // namespace
}  // namespace ostraka::review
