#include "stages/batch_inputs.h"

#include <gmock/gmock.h>

#include "files/files.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::stages {
namespace {

namespace fs = std::filesystem;

class Inputs : public testing::Test {
 protected:
  Inputs() {
    batch.folder = folder_.path() / "batch";
    for (const char* name : {"front/a.jpg", "front/b.jpg", "back/a.jpg"}) {
      write(name, name);
      batch.shots.push_back({batch::Side::Front, 0, 0, batch.folder / name, {}, 1, 1});
    }
  }
  void write(const std::string& name, const std::string& bytes) const {
    ASSERT_TRUE(writeFileAtomically(batch.folder / name, bytes).has_value());
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    const BatchInputs inputs(batch, 1);
    for (const auto& [name, hash] : inputs.hashes().items()) all.push_back(name);
    return all;
  }
  TemporaryFolder folder_;
  batch::Batch batch;
};

TEST_F(Inputs, AreTheSameWhileTheirBytesAreHoweverOftenTheyAreWritten) {
  const BatchInputs inputs(batch, 2);
  EXPECT_EQ(inputs.hashes().at("back/a.jpg"), sha256("back/a.jpg"));
  EXPECT_TRUE(inputs.checkUnchanged().has_value());
  write("front/b.jpg", "front/b.jpg");
  EXPECT_TRUE(inputs.checkUnchanged().has_value()) << "copied anew";
  write("front/b.jpg", "front/a.jpg");
  const Result<void> changed = inputs.checkUnchanged();
  ASSERT_FALSE(changed.has_value()) << "as long as before";
  EXPECT_EQ(changed.error().where, (batch.folder / "front/b.jpg").string());
  write("front/b.jpg", "front/b.jpg");
  EXPECT_TRUE(inputs.checkUnchanged().has_value());
  fs::remove(batch.folder / "back/a.jpg");
  EXPECT_FALSE(inputs.checkUnchanged().has_value());
}

// Else fronts and backs could be masked by two networks.
TEST_F(Inputs, HoldTheNetworkForMasksButNotAmongTheFilesOfTheBatch) {
  write("../masks.onnx", "one network");
  const fs::path network = batch.folder / "../masks.onnx";
  const BatchInputs inputs(batch, 2, network);
  EXPECT_EQ(inputs.networkHash(), sha256("one network"));
  EXPECT_EQ(inputs.hashes(), BatchInputs(batch, 2).hashes());
  EXPECT_TRUE(inputs.checkUnchanged().has_value());
  write("../masks.onnx", "its follower");
  const Result<void> changed = inputs.checkUnchanged();
  ASSERT_FALSE(changed.has_value());
  EXPECT_EQ(changed.error().where, network.string());
}

TEST_F(Inputs, HoldWhateverIsReadFromTheBatch) {
  write("front/masks/a.png", "m");
  batch.shots[0].mask_file = batch.folder / "front/masks/a.png";
  write("calibration/c.jpg", "c");
  batch.calibration.push_back({0, batch.folder / "calibration/c.jpg"});
  write("empty/e.jpg", "e");
  batch.empty_plates.push_back({0, batch.folder / "empty/e.jpg"});
  for (const char* name : {"plate.json", "board.json", "scale.json", "notes.txt"})
    write(name, name);
  batch.plate_file = batch.folder / "plate.json";
  EXPECT_THAT(names(),
              testing::UnorderedElementsAre("front/a.jpg", "front/b.jpg", "back/a.jpg",
                                            "front/masks/a.png", "calibration/c.jpg", "empty/e.jpg",
                                            "plate.json", "board.json", "scale.json"));
}

// A known length that somebody adds or corrects while a run goes on.
TEST_F(Inputs, TellThatALengthWasTypedAnew) {
  write("scale.json", "{\"mm\": 100}");
  const BatchInputs inputs(batch, 1);
  write("scale.json", "{\"mm\": 101}");
  const Result<void> changed = inputs.checkUnchanged();
  ASSERT_FALSE(changed.has_value());
  EXPECT_EQ(changed.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(changed.error().where, (batch.folder / "scale.json").string());
}

TEST_F(Inputs, OfAPlateThatNoFileDescribesAreItsCorners) {
  batch.plate.emplace();
  batch.plate->dictionary = "DICT_4X4_100";
  batch::Marker marker;
  marker.id = 7;
  marker.corners = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(20, 0, 0), Eigen::Vector3d(20, 20, 0),
                    Eigen::Vector3d(0, 20, 0)};
  batch.plate->markers = {marker};
  const auto hash = [&] { return BatchInputs(batch, 1).hashes().at("plate.json"); };
  const auto first = hash();
  EXPECT_EQ(hash(), first);
  batch.plate->markers[0].corners[2].x() = 20.5;
  EXPECT_NE(hash(), first);
  batch.plate->markers[0].corners[2].x() = 20;
  batch.plate->dictionary = "DICT_5X5_100";
  EXPECT_NE(hash(), first);
}

TEST_F(Inputs, ThatCannotBeReadMayComeBackButNotChange) {
  fs::remove(batch.folder / "front/a.jpg");
  const BatchInputs inputs(batch, 1);
  EXPECT_EQ(inputs.hashes().at("front/a.jpg"), "unreadable");
  EXPECT_TRUE(inputs.checkUnchanged().has_value());
  write("front/a.jpg", "front/a.jpg");
  EXPECT_FALSE(inputs.checkUnchanged().has_value());
}

TEST_F(Inputs, AreTheSameWithAnyNumberOfThreads) {
  const BatchInputs one(batch, 1);
  for (const int threads : {3, 16}) EXPECT_EQ(BatchInputs(batch, threads).hashes(), one.hashes());
}

}  // namespace
}  // namespace ostraka::stages
