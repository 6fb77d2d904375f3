#include "capture/manifest.h"

#include <gmock/gmock.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <tuple>

#include "files/files.h"
#include "files/json.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::capture {
namespace {

using batch::Side;
using ::testing::ElementsAre;

ManifestEntry entry(Side side, int camera, int stop, int take) {
  ManifestEntry e;
  e.side = side;
  e.camera = camera;
  e.stop = stop;
  e.take = take;
  e.file = std::string(batch::name(side)) + "/cam" + std::to_string(camera) + "_pos0" +
           std::to_string(stop) + ".jpg";
  e.sha256 = std::string(64, 'a');
  return e;
}

class ManifestFile : public ::testing::Test {
 protected:
  Result<Manifest> changed(const std::function<void(nlohmann::json&)>& change) const {
    nlohmann::json json = *readJson(folder_.path() / "manifest.json");
    change(json);
    EXPECT_TRUE(writeFileAtomically(folder_.path() / "manifest.json", json.dump()));
    Result<Manifest> read = readManifest(folder_.path());
    EXPECT_TRUE(writeManifest(folder_.path(), whole_));
    return read;
  }
  ManifestFile() {
    whole_.stops = 3;
    whole_.cameras = 2;
    whole_.entries = {entry(Side::Front, 1, 2, 1)};
    EXPECT_TRUE(writeManifest(folder_.path(), whole_));
  }
  TemporaryFolder folder_;
  Manifest whole_;
};

TEST_F(ManifestFile, ComesBackAsItWasWritten) {
  ManifestEntry e = entry(Side::Back, 1, 2, 3);
  e.raw = {"raw/back_cam1_pos02_take3.nef"};
  e.bytes = 5'000'000'000;
  e.camera_model = "D3200";
  e.camera_serial = "0815";
  e.settings = {{"exposure", "1/8"}};
  e.taken_at = "2026-11-21T18:30:00Z";
  e.angle_deg = 240;
  e.angle_seen_deg = 240.125;
  e.sharpness = 1.5;
  e.markers_seen = 11;
  e.sherds = 4;
  e.cut_off = true;
  e.problems = {"Too dark."};
  e.checked = true;
  e.used = false;
  e.reason = "reshot";
  whole_.entries = {e};
  ASSERT_TRUE(writeManifest(folder_.path(), whole_));
  const Manifest back = *readManifest(folder_.path());
  EXPECT_EQ(back.stops, 3);
  EXPECT_EQ(back.cameras, 2);
  ASSERT_EQ(back.entries.size(), 1u);
  const ManifestEntry& read = back.entries[0];
  EXPECT_EQ(
      std::tie(read.side, read.camera, read.stop, read.take, read.file, read.raw, read.sha256),
      std::tie(e.side, e.camera, e.stop, e.take, e.file, e.raw, e.sha256));
  EXPECT_EQ(std::tie(read.bytes, read.camera_model, read.camera_serial, read.settings,
                     read.taken_at, read.angle_deg, read.angle_seen_deg),
            std::tie(e.bytes, e.camera_model, e.camera_serial, e.settings, e.taken_at, e.angle_deg,
                     e.angle_seen_deg));
  EXPECT_EQ(std::tie(read.sharpness, read.markers_seen, read.sherds, read.cut_off, read.problems,
                     read.checked, read.used, read.reason),
            std::tie(e.sharpness, e.markers_seen, e.sherds, e.cut_off, e.problems, e.checked,
                     e.used, e.reason));
}

TEST_F(ManifestFile, ListsShotsBySideCameraStopAndTake) {
  whole_.entries = {entry(Side::Back, 0, 0, 1), entry(Side::Front, 1, 0, 1),
                    entry(Side::Front, 0, 1, 2), entry(Side::Front, 0, 1, 1)};
  ASSERT_TRUE(writeManifest(folder_.path(), whole_));
  std::vector<int> takes;
  std::vector<std::string> files;
  const Manifest back = *readManifest(folder_.path());
  for (const ManifestEntry& e : back.entries) {
    takes.push_back(e.take);
    files.push_back(e.file);
  }
  EXPECT_THAT(takes, ElementsAre(1, 2, 1, 1));
  EXPECT_THAT(files, ElementsAre("front/cam0_pos01.jpg", "front/cam0_pos01.jpg",
                                 "front/cam1_pos00.jpg", "back/cam0_pos00.jpg"));
}

TEST_F(ManifestFile, OfNoPhotographIsAnEmptyOne) {
  const TemporaryFolder empty;
  const Result<Manifest> none = readManifest(empty.path());
  ASSERT_TRUE(none) << none.error().sentence();
  EXPECT_EQ(none->stops, 0);
  EXPECT_TRUE(none->entries.empty());
}

TEST_F(ManifestFile, RefusesWhatNoCaptureWrites) {
  using Json = nlohmann::json;
  EXPECT_TRUE(changed([](Json&) {}));
  EXPECT_TRUE(changed([](Json& json) { json["photographs"][0].erase("angle_deg"); }));
  const std::pair<const char*, Json> bad[] = {{"camera", -1},
                                              {"camera", 1'000'000},
                                              {"stop", 0.5},
                                              {"take", "1"},
                                              {"bytes", -1},
                                              {"file", "../front/cam0_pos00.jpg"},
                                              {"file", "/etc/passwd"},
                                              {"raw", Json::array({"raw/../../x.nef"})},
                                              {"used", 1},
                                              {"sha256", nullptr}};
  for (const auto& [key, value] : bad) {
    const Result<Manifest> read =
        changed([name = key, to = value](Json& json) { json["photographs"][0][name] = to; });
    ASSERT_FALSE(read) << key << " " << value;
    EXPECT_EQ(read.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(read.error().where, (folder_.path() / "manifest.json").string());
  }
  EXPECT_FALSE(changed([](Json& json) { json["format"] = "ostraka-capture/2"; }));
  EXPECT_FALSE(changed([](Json& json) { json.erase("stops"); }));
  EXPECT_FALSE(changed([](Json& json) { json = Json::array(); }));
}

TEST(Manifest, FindsTheShotInUseAndCountsAllTakes) {
  Manifest manifest;
  manifest.entries = {entry(Side::Front, 0, 1, 1), entry(Side::Front, 0, 1, 3),
                      entry(Side::Front, 0, 1, 2), entry(Side::Back, 0, 1, 7)};
  manifest.entries[0].used = manifest.entries[1].used = false;
  EXPECT_EQ(manifest.find(Side::Front, 1, 0), &manifest.entries[2]);
  EXPECT_EQ(manifest.takes(Side::Front, 1, 0), 3) << "a number is given once";
  EXPECT_EQ(manifest.find(Side::Front, 0, 1), nullptr);
  EXPECT_EQ(manifest.takes(Side::Front, 0, 1), 0);
  manifest.entries[2].used = false;
  EXPECT_EQ(manifest.find(Side::Front, 1, 0), nullptr);
}

}  // namespace
}  // namespace ostraka::capture
