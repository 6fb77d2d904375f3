// What becomes of photographs by hand that no plate.json describes.
#include "pipeline/proposed_sheet.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "batch/photographs.h"

namespace ostraka::pipeline {
namespace {

using testing::HasSubstr;

class Told final : public Progress {
 public:
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel, const Message& text) override { all += text.english() + "\n"; }
  std::string all;
};

batch::Batch photographsIn(const char* folder) {
  batch::Batch batch;
  batch.folder = std::string(OSTRAKA_SHARED_DIR) + folder;
  batch.way = batch::Way::FreeCamera;
  int camera = 0;
  for (const auto& file : batch::photographsIn(batch.folder))
    batch.shots.push_back({batch::Side::Front, camera++, 0, file, {}, 0, 0});
  return batch;
}

TEST(ProposedSheet, HasNoScaleUntilSomebodySaysHowLargeItsMarkersAre) {
  batch::Batch batch = photographsIn("/batches/hand/front");
  ProcessOptions options;
  Told told;
  const Result<void> done = proposeMissingSheet(batch, options, told, {});
  ASSERT_TRUE(done.has_value()) << done.error().sentence();
  ASSERT_TRUE(batch.plate && batch.plate->sheet);
  EXPECT_EQ(batch.plate->markers.size(), 32u);
  EXPECT_TRUE(isProposed(batch));
  EXPECT_TRUE(hasGuessedSize(batch, options));
  EXPECT_THAT(told.all, HasSubstr("--marker-mm"));
  EXPECT_THAT(told.all, HasSubstr("no scale"));
  options.marker_mm = 20;
  EXPECT_FALSE(hasGuessedSize(batch, options));
}

TEST(ProposedSheet, IsNoneWhereThePhotographsShowNoMarkers) {
  batch::Batch batch = photographsIn("/real/statue");  // coded targets, of no dictionary
  ProcessOptions options;
  Told told;
  EXPECT_TRUE(proposeMissingSheet(batch, options, told, {}).has_value());
  EXPECT_FALSE(batch.plate.has_value());
  EXPECT_EQ(told.all, "");
  options.marker_mm = 20;
  const Result<void> asked = proposeMissingSheet(batch, options, told, {});
  ASSERT_FALSE(asked.has_value()) << "a size was said, so markers were expected";
  EXPECT_EQ(asked.error().code, ErrorCode::NotEnough);
}

TEST(ProposedSheet, OfUnknownSizeGivesWayToALengthThatWasMarked) {
  batch::Batch batch = photographsIn("/batches/hand/front");
  batch.known_lengths.push_back({batch::Side::Front, 50, {}});
  Told told;
  EXPECT_TRUE(proposeMissingSheet(batch, {}, told, {}).has_value());
  EXPECT_FALSE(batch.plate.has_value()) << "the length would be compared with a guess";
  ProcessOptions options;
  options.marker_mm = 20;
  EXPECT_TRUE(proposeMissingSheet(batch, options, told, {}).has_value());
  ASSERT_TRUE(batch.plate.has_value()) << "the length checks a size that was measured";
  EXPECT_EQ(batch.plate->typed_marker_mm, 20);
}

TEST(ProposedSheet, IsNoneWhereAFileDescribesOneAndTheSizeGivenMustBeTheFiles) {
  batch::Batch batch;
  batch.way = batch::Way::FreeCamera;
  batch.plate_file = "/photographs/plate.json";
  batch.plate = batch::Plate();
  batch.plate->markers = {{7, {Eigen::Vector3d{0, 20, 0}, {20, 20, 0}, {20, 0, 0}, {0, 0, 0}}}};
  Told told;
  ProcessOptions options;
  options.marker_mm = 20.02;
  EXPECT_TRUE(proposeMissingSheet(batch, options, told, {}).has_value());
  options.marker_mm = 25;
  const Result<void> other = proposeMissingSheet(batch, options, told, {});
  ASSERT_FALSE(other.has_value());
  EXPECT_EQ(other.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(other.error().where, "/photographs/plate.json");
  EXPECT_THAT(other.error().what, HasSubstr("sides of 20.00 mm"));
  EXPECT_THAT(other.error().what, HasSubstr("says 25.00 mm"));
}

TEST(MarkerSide, IsWrittenIntoThePlateOfABatchByHandAndRefusedForARigs) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "ostraka_marker_side";
  fs::remove_all(folder);
  fs::copy(std::string(OSTRAKA_SHARED_DIR) + "/batches/hand", folder, fs::copy_options::recursive);
  Told told;
  const Result<batch::Plate> typed = setMarkerSide(folder, 18, told, {});
  ASSERT_TRUE(typed.has_value()) << typed.error().sentence();
  const Result<batch::Plate> written = batch::readPlate(folder / "plate.json");
  ASSERT_TRUE(written.has_value()) << written.error().sentence();
  EXPECT_EQ(written->typed_marker_mm, 18);
  EXPECT_NEAR(*batch::markerSide(*written), 18, 1e-6);
  EXPECT_FALSE(setMarkerSide(folder, 0, told, {}).has_value());
  EXPECT_EQ(batch::readPlate(folder / "plate.json")->typed_marker_mm, 18);
  fs::remove_all(folder);
  const Result<batch::Plate> rig =
      setMarkerSide(std::string(OSTRAKA_SHARED_DIR) + "/batches/demo", 18, told, {});
  ASSERT_FALSE(rig.has_value());
  EXPECT_THAT(rig.error().what, HasSubstr("its rig's"));
}

TEST(ProposedSheet, IsNotSoughtOnARig) {
  batch::Batch batch = photographsIn("/batches/hand/front");
  batch.way = batch::Way::Rig;
  Told told;
  EXPECT_TRUE(proposeMissingSheet(batch, {}, told, {}).has_value());
  EXPECT_FALSE(batch.plate.has_value());
}

}  // namespace
}  // namespace ostraka::pipeline
