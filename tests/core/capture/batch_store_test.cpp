#include "capture/batch_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/files.h"
#include "flat_rig.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::capture {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class Store : public ::testing::Test {
 protected:
  Result<BatchStore> open(const batch::Plate& plate) const {
    return BatchStore::open(folder_, batch::Side::Front, 3, 1, plate);
  }
  void take(const std::vector<devices::CameraFile>& files) {
    Result<BatchStore> store = open(plate_);
    ASSERT_TRUE(store.has_value()) << store.error().what;
    const auto arriving = store->stage(files, 0, 0, 0.0, {"folder", "a camera", "1", ""});
    ASSERT_TRUE(arriving.has_value()) << arriving.error().what;
    ASSERT_TRUE(store->commit({*arriving}).has_value());
  }
  std::string textOf(const char* file) const {
    const auto bytes = readFile(folder_ / file);
    return bytes ? *bytes : "none";
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "batch";
  batch::Plate plate_ = testing::makeFlatRig(1).devices.plate;
};

// Of a capture that was killed one is left, and is in nobody's way.
TEST_F(Store, LeavesNoLockBehind) {
  fs::create_directories(folder_);
  ASSERT_TRUE(writeFileAtomically(folder_ / "lock", ""));
  {
    const Result<BatchStore> store = open(plate_);
    ASSERT_TRUE(store.has_value()) << store.error().what;
    EXPECT_FALSE(open(plate_).has_value()) << "one capture at a time";
    EXPECT_TRUE(fs::exists(folder_ / "lock"));
  }
  EXPECT_FALSE(fs::exists(folder_ / "lock"));
  take({{"DSC_1.JPG", "\xFF\xD8 a photograph"}});
  EXPECT_FALSE(fs::exists(folder_ / "lock"));
}

// The program ended between the names of a photograph and of its raw file.
TEST_F(Store, NamesTheRawFileOfAPhotographAfterACrash) {
  take({{"DSC_1.JPG", "\xFF\xD8 a photograph"}, {"DSC_1.NEF", "a raw file"}});
  ASSERT_EQ(textOf("raw/front_cam0_pos00_take1.nef"), "a raw file");
  const auto arriving = [&](const std::string& name) {
    return folder_ / "raw" / ("." + name + ".arriving");
  };
  fs::rename(folder_ / "raw/front_cam0_pos00_take1.nef", arriving("front_cam0_pos00_take1.nef"));
  ASSERT_TRUE(writeFileAtomically(arriving("front_cam0_pos01_take1.nef"), "of no photograph"));
  ASSERT_TRUE(writeFileAtomically(arriving("back_cam0_pos00_take1.nef"), "the other side's"));
  ASSERT_TRUE(open(plate_).has_value());
  EXPECT_EQ(textOf("raw/front_cam0_pos00_take1.nef"), "a raw file");
  EXPECT_FALSE(fs::exists(arriving("front_cam0_pos00_take1.nef")));
  EXPECT_FALSE(fs::exists(arriving("front_cam0_pos01_take1.nef")));
  EXPECT_TRUE(fs::exists(arriving("back_cam0_pos00_take1.nef")));
  EXPECT_EQ(textOf("front/cam0_pos00.jpg"), "\xFF\xD8 a photograph");
}

TEST_F(Store, NamesNothingOutsideOfItsFolder) {
  take({{"DSC_1.JPG", "\xFF\xD8 a photograph"}, {"DSC_1.NEF", "a raw file"}});
  auto manifest = readManifest(folder_);
  ASSERT_TRUE(manifest.has_value());
  manifest->entries[0].raw = {"../elsewhere.nef"};
  ASSERT_TRUE(writeManifest(folder_, *manifest).has_value());
  EXPECT_FALSE(open(plate_).has_value());
}

TEST_F(Store, MakesNothingInAFolderWithPhotographsOfOthers) {
  for (const char* name : {"front/DSC_0001.JPG", "front/cam0_pos00.png"}) {
    ASSERT_TRUE(makeFolder(folder_ / "front"));
    ASSERT_TRUE(writeFileAtomically(folder_ / name, "a person's"));
    const Result<BatchStore> store = open(plate_);
    ASSERT_FALSE(store.has_value()) << name;
    EXPECT_EQ(store.error().code, ErrorCode::UnusableInput);
    EXPECT_THAT(store.error().where, HasSubstr(name));
    EXPECT_FALSE(fs::exists(folder_ / "set_aside"));
    EXPECT_FALSE(fs::exists(folder_ / "plate.json"));
    EXPECT_EQ(textOf(name), "a person's");
    fs::remove_all(folder_);
  }
}

TEST_F(Store, IsHeldByOneProgramAtATime) {
  {
    const Result<BatchStore> first = open(plate_);
    ASSERT_TRUE(first.has_value()) << first.error().what;
    for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
      const Result<BatchStore> second = BatchStore::open(folder_, side, 3, 1, plate_);
      ASSERT_FALSE(second.has_value());
      EXPECT_EQ(second.error().code, ErrorCode::CannotWrite);
      EXPECT_THAT(second.error().what, HasSubstr("Another run is writing"));
    }
  }
  EXPECT_TRUE(open(plate_).has_value());
}

// The manifest must not name bytes that another file has.
TEST_F(Store, ForgetsAPhotographWhoseNameAnotherFileHasTaken) {
  Result<BatchStore> store = open(plate_);
  ASSERT_TRUE(store.has_value()) << store.error().what;
  const auto arriving = store->stage({{"DSC_1.JPG", "\xFF\xD8 a photograph"}}, 0, 0, 0.0, {});
  ASSERT_TRUE(arriving.has_value()) << arriving.error().what;
  ASSERT_TRUE(writeFileAtomically(folder_ / "front/cam0_pos00.jpg", "another's"));
  EXPECT_FALSE(store->commit({*arriving}).has_value());
  EXPECT_TRUE(store->manifest().entries.empty());
  const auto manifest = readManifest(folder_);
  ASSERT_TRUE(manifest.has_value());
  EXPECT_TRUE(manifest->entries.empty());
  EXPECT_EQ(textOf("front/cam0_pos00.jpg"), "another's");
}

TEST_F(Store, WritesAndDeletesNothingThroughALinkedFolder) {
  const fs::path foreign = temporary_.path() / "foreign";
  ASSERT_TRUE(makeFolder(foreign));
  ASSERT_TRUE(writeFileAtomically(foreign / ".x.arriving", "another's"));
  ASSERT_TRUE(makeFolder(folder_));
  for (const char* name : {"front", "back", "set_aside", "raw", "calib"}) {
    fs::create_directory_symlink(foreign, folder_ / name);
    const Result<BatchStore> refused = open(plate_);
    ASSERT_FALSE(refused.has_value()) << name;
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(refused.error().where, (folder_ / name).string());
    fs::remove(folder_ / name);
    EXPECT_EQ(textOf("../foreign/.x.arriving"), "another's");
  }
  EXPECT_TRUE(open(plate_).has_value());
}

TEST_F(Store, IsOfAnotherPlateOnlyOnceItHasPhotographs) {
  batch::Plate other = plate_;
  other.markers[0].corners[0].x() += 1;
  EXPECT_TRUE(checkPlate(folder_, plate_).has_value());  // nothing is there
  ASSERT_TRUE(open(plate_).has_value());
  EXPECT_TRUE(checkPlate(folder_, other).has_value());  // nothing was taken
  take({{"DSC_1.JPG", "\xFF\xD8 a photograph"}});
  EXPECT_TRUE(checkPlate(folder_, plate_).has_value());
  const Result<void> refused = checkPlate(folder_, other);
  ASSERT_FALSE(refused.has_value());
  EXPECT_THAT(refused.error().what, HasSubstr("started on another plate"));
}

}  // namespace
}  // namespace ostraka::capture
