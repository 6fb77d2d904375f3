#include "scansets/register_scans.h"

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cloud/ply.h"
#include "files/files.h"
#include "files/json.h"
#include "paper/report_page.h"
#include "scansets/register_report.h"
#include "tests/core/files/temporary_folder.h"
#include "tests/core/pipeline/synthetic_out.h"

namespace ostraka::scansets {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Three sherds whose true pairs and poses are known, as another scanner's files.
class RegisterScans : public testing::Test {
 protected:
  RegisterScans() {
    pipeline::SyntheticOptions options;
    options.sherds = 3;
    options.swapped_look_alikes = false;
    truth = pipeline::writeSyntheticOut(folder / "truth", options);
    fs::copy(truth.output / "work/scans_front", folder / "front");
    fs::copy(truth.output / "work/scans_back", folder / "back");
  }

  void scale(const char* side, double factor) {
    for (const auto& entry : fs::directory_iterator(folder / side)) {
      PointCloud cloud = *readPlyCloud(entry.path());
      for (Eigen::Vector3f& p : cloud.points) p *= static_cast<float>(factor);
      ASSERT_TRUE(writePly(entry.path(), cloud, "scanner").has_value());
    }
  }
  Result<RegisterSummary> run(const char* out, pairing::Scale scale = pairing::Scale::Fixed) {
    RegisterOptions options;
    options.front = folder / "front";
    options.back = folder / "back";
    options.output = folder / out;
    options.scale = scale;
    options.threads = 2;
    return registerScans(options, quiet, {});
  }

  TemporaryFolder temporary_;
  fs::path folder = temporary_.path();
  pipeline::SyntheticOut truth;
  QuietProgress quiet;
};

TEST_F(RegisterScans, FindThePairsAndAreWhole) {
  const auto summary = run("out");
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->pairs.size(), 3u);
  for (const RegisterSummary::Pair& p : summary->pairs)
    EXPECT_EQ(p.front.substr(1), p.back.substr(1)) << "front i belongs to back i";
  EXPECT_TRUE(summary->whole());
}

TEST_F(RegisterScans, AFrontWithoutItsBackIsNotWhole) {
  fs::remove(folder / "back/b003.ply");
  const auto summary = run("out");
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  EXPECT_EQ(summary->unpaired_front, std::vector<std::string>{"f003"});
  EXPECT_FALSE(summary->whole());
}

// The third back is missing: by likelihoods its front would stay alone.
TEST_F(RegisterScans, ByThePapersPairingTakeTheNearestBackAndStateNoProbability) {
  fs::remove(folder / "back/b003.ply");
  RegisterOptions options;
  options.front = folder / "front";
  options.back = folder / "back";
  options.output = folder / "out";
  options.pairing = pairing::Method::Paper;
  const auto summary = registerScans(options, quiet, {});
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->pairs.size(), 3u);
  EXPECT_EQ(summary->pairs[0].back, "b001");
  EXPECT_EQ(summary->pairs[1].back, "b002");
  EXPECT_TRUE(summary->pairs[2].ambiguous) << "its back is another front's, too";
  const auto pairs = readJson(folder / "out/pairs.json");
  ASSERT_TRUE(pairs.has_value());
  for (const auto& pair : pairs->at("pairs")) {
    EXPECT_TRUE(pair.at("score").is_null());
    EXPECT_TRUE(pair.at("margin").is_null());
    EXPECT_TRUE(pair.at("alternatives").empty());
    EXPECT_GT(pair.at("distance_rad").get<double>(), 0);
  }
}

// A cloud without an outline takes no part in the pairing, and says so where people look.
TEST_F(RegisterScans, WhatStaysUnpairedForAReasonStandsAmongTheWarnings) {
  PointCloud line;
  for (int i = 0; i < 300; ++i) {
    line.points.emplace_back(0.1f * static_cast<float>(i), 0.f, 0.f);
    line.normals.emplace_back(0, 0, 1);
  }
  ASSERT_TRUE(writePly(folder / "front/line.ply", line, "scanner").has_value());
  const auto summary = run("out");
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  EXPECT_THAT(summary->warnings, testing::Contains(HasSubstr("line stays unpaired")));
  const std::string report = *readFile(folder / "out/report.html");
  EXPECT_THAT(report, HasSubstr("line stays unpaired"));
  EXPECT_TRUE(isSafeReport(report));
}

TEST_F(RegisterScans, InCentimetresAreRefusedBeforeAnythingIsWritten) {
  scale("front", 0.1);
  scale("back", 0.1);
  const auto summary = run("out");
  ASSERT_FALSE(summary.has_value());
  EXPECT_EQ(summary.error().code, ErrorCode::UnusableInput);
  EXPECT_THAT(summary.error().sentence(), HasSubstr("seems to be centimetres"));
  EXPECT_THAT(summary.error().sentence(), HasSubstr("--scale free"));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// Metres here and half millimetres there: poses and lengths come in the fronts' own unit.
TEST_F(RegisterScans, WithScaleFreeFindTheirPosesInWhateverUnitTheFrontsHave) {
  constexpr double kFront = 0.001, kBack = 2;
  scale("front", kFront);
  scale("back", kBack);
  const auto summary = run("out", pairing::Scale::Free);
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->pairs.size(), 3u);
  EXPECT_THAT(summary->warnings, testing::Contains(HasSubstr("fronts are not in mm")));
  const auto pairs = readJson(folder / "out/pairs.json");
  ASSERT_TRUE(pairs.has_value());
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& pair = pairs->at("pairs").at(i);
    EXPECT_EQ(pair.at("front").get<std::string>().substr(1),
              pair.at("back").get<std::string>().substr(1));
    EXPECT_NEAR(pair.at("scale").get<double>() / (kFront / kBack), 1, 0.005);  // common_scale.h
    Eigen::Isometry3d found = *isometryFromJson(pair.at("T_front_from_back"), "pairs.json");
    found.translation() /= kFront;
    const decisions::ScanRef& back = truth.table.backs[i];
    const Eigen::Vector3d middle(back.place_mm.x(), back.place_mm.y(), 3);
    // 0.5 % of scale over the 130 mm that the backs lie away from their origin.
    EXPECT_LT((found * middle - truth.front_from_back[i] * middle).norm(), 0.7);
    EXPECT_LT(pair.at("fracture_rms_mm").get<double>(), 0.3 * kFront) << "in metres";
  }
  const auto merged = readPlyCloud(folder / "out/sherds/01/merged.ply");
  ASSERT_TRUE(merged.has_value());
  Eigen::Vector3f low = merged->points.front(), high = low;
  for (const Eigen::Vector3f& p : merged->points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  EXPECT_LT((high - low).maxCoeff(), 40 * kFront) << "both sides of a sherd of 20 to 30 mm";
}

// On from the batch's one scale.
TEST_F(RegisterScans, WithScaleFreeAndBbicpFindAScaleOfEachPair) {
  scale("back", 2);
  RegisterOptions options;
  options.front = folder / "front";
  options.back = folder / "back";
  options.output = folder / "out";
  options.scale = pairing::Scale::Free;
  options.registration = registration::Method::BilateralBoundary;
  options.boundary = registration::Boundary::Paper;
  const auto summary = registerScans(options, quiet, {});
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  const auto pairs = readJson(folder / "out/pairs.json");
  ASSERT_TRUE(pairs.has_value());
  std::set<double> scales;
  for (const auto& pair : pairs->at("pairs")) {
    scales.insert(pair.at("scale").get<double>());
    EXPECT_NEAR(*scales.rbegin(), 0.5, 0.05);
    EXPECT_NEAR(*scales.begin(), 0.5, 0.05);
  }
  EXPECT_GT(scales.size(), 1u);
}

TEST_F(RegisterScans, StoppedCanBeRepeatedAndLeavesNothingThatLooksWhole) {
  ASSERT_TRUE(run("out").has_value());
  const std::string whole = *readFile(folder / "out/pairs.json");
  RegisterOptions options;
  options.front = folder / "front";
  options.back = folder / "back";
  options.output = folder / "out";
  std::stop_source source;
  source.request_stop();
  const auto stopped = registerScans(options, quiet, source.get_token());
  ASSERT_FALSE(stopped.has_value());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  for (const char* name : {"pairs.json", "report.json", "report.html", "sherds"})
    EXPECT_FALSE(fs::exists(folder / "out" / name)) << name;
  const auto again = run("out");
  ASSERT_TRUE(again.has_value()) << again.error().sentence();
  EXPECT_EQ(*readFile(folder / "out/pairs.json"), whole);

  fs::remove(folder / "back/b003.ply");
  const auto others = run("out");
  ASSERT_FALSE(others.has_value()) << "of other scans";
  EXPECT_EQ(others.error().code, ErrorCode::UnusableInput);
  EXPECT_TRUE(fs::exists(folder / "out/report.json")) << "and it is left alone";
}

TEST(FractureWords, SaysNothingWhereNoFracturesWereCompared) {
  RegisterSummary::Pair pair;
  EXPECT_TRUE(toJson(pair).at("fracture_rms_mm").is_null());
  EXPECT_TRUE(toJson(pair).at("fracture_overlap").is_null());
  pair.fracture_rms_mm = 0.1;
  EXPECT_EQ(toJson(pair).at("fracture_rms_mm"), 0.1);
  EXPECT_EQ(toJson(pair).at("fracture_overlap"), 0.0) << "they were compared and do not meet";
}

}  // namespace
}  // namespace ostraka::scansets
