#include "api/register.h"

#include <gmock/gmock.h>

#include "api/point_files.h"
#include "tests/core/api/quiet.h"
#include "tests/core/files/temporary_folder.h"
#include "tests/core/model/shapes.h"
#include "tests/core/pipeline/synthetic_out.h"

namespace ostraka::api {
namespace {

TEST(RegisterScans, PairsAndRegistersScansHandedInAsPoints) {
  const TemporaryFolder folder;
  pipeline::SyntheticOptions options;
  options.sherds = 3;
  options.swapped_look_alikes = false;
  const pipeline::SyntheticOut truth = pipeline::writeSyntheticOut(folder.path() / "out", options);
  std::vector<PointCloud> fronts, backs;
  for (const int i : {1, 2, 3}) {
    const std::string number = "00" + std::to_string(i) + ".ply";
    fronts.push_back(*readCloud(truth.output / "work/scans_front" / ("f" + number)));
    backs.push_back(*readCloud(truth.output / "work/scans_back" / ("b" + number)));
  }
  std::swap(backs.front(), backs.back());
  const Result<RegisteredScans> found = registerScans(fronts, backs, 2, quiet, {});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  ASSERT_EQ(found->pairs.size(), 3u);
  for (const RegisteredPair& pair : found->pairs) EXPECT_EQ(pair.front + pair.back, 2);
  EXPECT_TRUE(found->unpaired_front.empty() && found->unpaired_back.empty());

  const Result<RegisteredScans> half =
      registerScans(std::span(fronts).first(1), std::span(backs).first(2), 2, quiet, {});
  ASSERT_TRUE(half.has_value()) << half.error().sentence();
  EXPECT_FALSE(half->unpaired_back.empty());
}

TEST(RegisterScans, RefusesScansWithoutNormalsOrPointsAndNamesThem) {
  const PointCloud good = scanOfBox(model::BoxScan{}, false, 1);
  PointCloud flat = good;
  flat.normals.clear();
  const std::vector<PointCloud> fronts = {good}, flats = {good, flat}, few = {PointCloud{}};
  const Result<RegisteredScans> no_normals = registerScans(fronts, flats, 1, quiet, {});
  ASSERT_FALSE(no_normals.has_value());
  EXPECT_EQ(no_normals.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(no_normals.error().sentence(), testing::HasSubstr("back 1"));
  EXPECT_EQ(registerScans(few, fronts, 1, quiet, {}).error().code, ErrorCode::NotEnough);
  EXPECT_EQ(registerScans({}, fronts, 1, quiet, {}).error().code, ErrorCode::NotEnough);
}

}  // namespace
}  // namespace ostraka::api
