#include "rig/rig.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "files/json.h"
#include "simulated_rig.h"
#include "tests/core/files/temporary_folder.h"

namespace ostraka::rig {
namespace {

struct RigFile : testing::Test {
  TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "rig.json";
};

Rig sample() {
  Rig rig;
  rig.cameras.push_back({0, lens(2600), lookingDown(0.5, 0.1), 0.2, 0.03, 0.01, {}});
  rig.cameras.push_back(
      {4, lens(2500), lookingDown(1.0, 0.2), 0.2, 0.03, 0.02, std::vector<double>(225, 0.5)});
  rig.stops = {0, 1, 5};
  rig.stop_angles_rad = {0, 0.7, 3};
  rig.reprojection_rms_px = 0.04;
  return rig;
}

TEST_F(RigFile, ComesBackAsItWasWritten) {
  const Rig rig = sample();
  ASSERT_TRUE(writeRig(file, rig).has_value());
  const auto read = readRig(file);
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  ASSERT_NE(read->find(4), nullptr);
  EXPECT_EQ(read->find(3), nullptr);
  EXPECT_EQ(read->find(4)->intrinsics.fx, 2500);
  EXPECT_EQ(read->find(4)->intrinsics.distortion, rig.cameras[1].intrinsics.distortion);
  EXPECT_TRUE(
      read->find(4)->camera_from_turntable.isApprox(rig.cameras[1].camera_from_turntable, 1e-15));
  EXPECT_TRUE(read->find(0)->covariance.empty());
  EXPECT_EQ(read->find(4)->covariance, rig.cameras[1].covariance);
  EXPECT_EQ(read->stops, rig.stops);
  EXPECT_NEAR(read->stop_angles_rad[2], 3, 1e-14);
}

TEST_F(RigFile, KeepsLensesOfEightAndTwelveTermsAndFisheyes) {
  Rig rig = sample();
  Distortion& first = rig.cameras[0].intrinsics.distortion;
  Distortion& second = rig.cameras[1].intrinsics.distortion;
  const Distortion prism{{0.9, 0.1, 0, 0, 0, 1, 0.2, 0, 0.001, 0, -0.001, 0}, Lens::Full};
  const Distortion fisheye{{0.03, -0.01, 0.004, -0.001}, Lens::Fisheye};
  const Distortion rational{{0.9, 0.1, 0, 0, 0, 1, 0.2}, Lens::Full};
  for (const Distortion& lens : {prism, fisheye, rational}) {
    first = lens;
    second = fisheye;
    ASSERT_TRUE(writeRig(file, rig));
    EXPECT_EQ(readJson(file)->at("cameras")[0].at("dist").size(), lens.list().size());
    const auto read = readRig(file);
    ASSERT_TRUE(read) << read.error().sentence();
    EXPECT_EQ(read->cameras[0].intrinsics.distortion, lens);
    EXPECT_EQ(read->cameras[1].intrinsics.distortion, fisheye);
  }
}

TEST_F(RigFile, WritesFiveTermsAndNoModelForAStandardLens) {
  ASSERT_TRUE(writeRig(file, sample()));
  std::ifstream stream(file);
  const auto json = nlohmann::ordered_json::parse(stream);
  std::string keys;
  for (const auto& [key, value] : json.at("cameras")[0].items()) keys += key + " ";
  EXPECT_EQ(keys,
            "camera width height K dist camera_from_turntable focal_sd_px intrinsics_rms_px "
            "marker_inset_px ");
  EXPECT_EQ(json.at("cameras")[0].at("dist").dump(), "[-0.06,0.02,0.0003,-0.0002,0.0]");
}

TEST_F(RigFile, RefusesWhatIsNoLens) {
  ASSERT_TRUE(writeRig(file, sample()));
  const nlohmann::json good = *readJson(file);
  const auto sentence = [&](const nlohmann::json& terms, const nlohmann::json& lens) {
    nlohmann::json json = good;
    json["cameras"][0]["dist"] = terms;
    if (!lens.is_null()) json["cameras"][0]["lens"] = lens;
    std::ofstream(file) << json;
    const auto read = readRig(file);
    return read ? std::string() : read.error().sentence().english();
  };
  const auto zeros = [](std::size_t count) { return std::vector<double>(count, 0.0); };
  for (const std::size_t count : {0U, 4U, 5U, 8U, 12U}) EXPECT_EQ(sentence(zeros(count), {}), "");
  for (const std::size_t count : {1U, 6U, 9U, 14U})
    EXPECT_THAT(sentence(zeros(count), {}), testing::HasSubstr("5, 8 or 12")) << count;
  EXPECT_EQ(sentence(zeros(4), "fisheye"), "");
  EXPECT_EQ(sentence(zeros(5), "standard"), "");
  EXPECT_THAT(sentence(zeros(5), "fisheye"), testing::HasSubstr("a fisheye has 4"));
  EXPECT_THAT(sentence(zeros(4), "brown"), testing::HasSubstr("\"brown\" is not known"));
  EXPECT_THAT(sentence(zeros(4), 7), testing::HasSubstr("7 is not known"));
  EXPECT_NE(sentence({1e9, 0, 0, 0, 0}, {}), "");
  EXPECT_NE(sentence({"0", 0, 0, 0, 0}, {}), "");
  // r - 100 r^3 grows up to 0.038, r - 10 r^3 up to 0.122; a quarter of 1200 px is 0.115.
  EXPECT_THAT(sentence({-100, 0, 0, 0, 0, 0.01, 0, 0}, {}), testing::HasSubstr("folds"));
  EXPECT_EQ(sentence({-10, 0, 0, 0, 0, 0.01, 0, 0}, {}), "");
  EXPECT_EQ(sentence({-100, 0, 0, 0, 0}, {}), "") << "as few markers may leave it";
}

TEST_F(RigFile, KeepsTheDevicesOfAnEarlierCalibration) {
  std::ofstream(file) << R"({"devices":{"settle_s":2},"cameras":["old"]})";
  ASSERT_TRUE(writeRig(file, sample()).has_value());
  const auto json = readJson(file);
  EXPECT_TRUE(readRig(file).has_value());
  ASSERT_TRUE(json.has_value());
  EXPECT_EQ(json->at("devices").at("settle_s"), 2);
  EXPECT_EQ(json->at("cameras").size(), 2u);
}

TEST_F(RigFile, DoesNotOverwriteWhatIsNoRigAtAll) {
  std::ofstream(file) << "Dear colleague";
  const auto written = writeRig(file, sample());
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().code, ErrorCode::UnusableInput);
}

TEST_F(RigFile, TakesThePlaceOfARigOfAnyVersionAlone) {
  EXPECT_TRUE(checkRigOutput(file)) << "not there yet";
  for (const char* rig : {R"({"format": 99, "cameras": [], "stops": []})", R"({"devices": []})"}) {
    std::ofstream(file) << rig;
    EXPECT_TRUE(checkRigOutput(file)) << rig;
  }
  for (const char* other : {R"({"rows": 3, "markers": []})", "not JSON", "[]", ""}) {
    std::ofstream(file) << other;
    const Result<void> checked = checkRigOutput(file);
    ASSERT_FALSE(checked) << other;
    EXPECT_EQ(checked.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(checked.error().where, file.string());
  }
}

TEST_F(RigFile, RefusesNumbersThatNoRigHas) {
  ASSERT_TRUE(writeRig(file, sample()).has_value());
  const nlohmann::json good = *readJson(file);
  const auto refuses = [&](const char* pointer, const nlohmann::json& value) {
    nlohmann::json json = good;
    json[nlohmann::json::json_pointer(pointer)] = value;
    std::ofstream(file) << json;
    const auto read = readRig(file);
    return !read && read.error().code == ErrorCode::UnusableInput;
  };
  EXPECT_FALSE(refuses("/unit", "mm"));
  EXPECT_TRUE(refuses("/unit", "cm"));
  EXPECT_TRUE(refuses("/cameras/0/camera_from_turntable/2/3", 1e30));
  EXPECT_TRUE(refuses("/cameras/0/width", 100'000)) << "a ratio of no picture";
  EXPECT_TRUE(refuses("/cameras/0/height", 10)) << "a ratio of no picture";
  EXPECT_TRUE(refuses("/stops/1/stop", 0)) << "twice";
  nlohmann::json stops = nlohmann::json::array();
  for (int k = 0; k < 400; ++k) stops.push_back({{"stop", k}, {"angle_deg", 0.9 * k}});
  EXPECT_FALSE(refuses("/stops", stops));
  stops.push_back({{"stop", 400}, {"angle_deg", 360}});
  EXPECT_TRUE(refuses("/stops", stops));
}

TEST_F(RigFile, RefusesWhatIsNoRig) {
  for (const char* text : {"{}", "[1]", R"({"format":"ostraka-rig/9","cameras":[],"stops":[]})",
                           R"({"format":"ostraka-rig/1","cameras":[],"stops":[]})",
                           R"({"format":"ostraka-rig/1","cameras":[{"camera":0}],"stops":[]})"}) {
    std::ofstream(file) << text;
    const auto read = readRig(file);
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_EQ(read.error().code, ErrorCode::UnusableInput);
    EXPECT_EQ(read.error().where, std::filesystem::path(file).string());
  }
}

}  // namespace
}  // namespace ostraka::rig
