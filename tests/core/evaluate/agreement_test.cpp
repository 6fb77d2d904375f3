// Our figures against those of the reference script, on the same files. The script draws other
// samples of the same density, so figures agree to the sampling error, below 0.005 mm; counts
// exactly.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "cloud/ply.h"
#include "evaluate/cloud.h"
#include "evaluate/model.h"
#include "evaluate/pairs.h"
#include "evaluate/samples.h"
#include "evaluate/truth.h"
#include "files/json.h"

namespace ostraka::evaluate {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double kAgree_mm = 0.005;

fs::path shared() {
  return OSTRAKA_SHARED_DIR;
}

fs::path scratch() {
  const fs::path folder = fs::path(testing::TempDir()) / "ostraka_agreement";
  fs::create_directories(folder);
  return folder;
}

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

// A python3 that has what the script needs; empty when there is none.
std::string python() {
  for (const char* program : {"python3", "/usr/bin/python3"})
    if (std::system((std::string(program) + " -c 'import numpy, scipy' 2>/dev/null").c_str()) == 0)
      return program;
  return {};
}

Json script(const std::string& arguments) {
  const std::string program = python();
  EXPECT_FALSE(program.empty()) << "The comparison needs python3 with numpy and scipy: install "
                                   "python3-numpy and python3-scipy.";
  const fs::path result = scratch() / "script.json";
  fs::remove(result);
  const std::string command = program + " " + quoted(shared() / "tools/evaluate.py") + " " +
                              arguments + " --json " + quoted(result) + " > /dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  const Result<Json> value = readJson(result);
  EXPECT_TRUE(value.has_value());
  return value ? *value : Json();
}

// The truth as an answer, its transforms off by `turn_deg` about a line through the origin and by
// `shift_mm`.
Json answer(const fs::path& truth_json, double turn_deg, double shift_mm) {
  const Result<PairsTruth> truth = readPairsTruth(truth_json);
  EXPECT_TRUE(truth.has_value());
  Json pairs = Json::array();
  int k = 0;
  for (const TruePair& pair : truth->pairs) {
    const Eigen::Vector3d axis = Eigen::Vector3d(1, k % 3, k % 5 - 2).normalized();
    const Eigen::Isometry3d off = Eigen::Translation3d(shift_mm * (k % 4), 0, shift_mm) *
                                  Eigen::AngleAxisd(turn_deg * M_PI / 180, axis) *
                                  Eigen::Isometry3d::Identity();
    pairs.push_back({{"front", pair.front},
                     {"back", pair.back},
                     {"ambiguous", k % 3 == 0},
                     {"T_front_from_back", Json(toJson(off * pair.front_from_back))}});
    ++k;
  }
  return {{"pairs", pairs},
          {"unpaired_front", truth->unpaired_front},
          {"unpaired_back", truth->unpaired_back}};
}

void expectSamePairs(const Json& proposal, const std::string& set) {
  const fs::path pairs_json = scratch() / "pairs.json";
  ASSERT_TRUE(writeJson(pairs_json, nlohmann::ordered_json(proposal)).has_value());
  const fs::path truth_json = shared() / "scans" / set / "truth.json";
  const Json theirs = script("pairs " + quoted(pairs_json) + " " + quoted(truth_json))["summary"];
  const auto read = [&](const std::string& file) {
    return readPlyCloud(truth_json.parent_path() / file);
  };
  const auto evaluation =
      evaluatePairs(*readProposal(pairs_json), *readPairsTruth(truth_json), read);
  ASSERT_TRUE(evaluation.has_value()) << evaluation.error().sentence();
  const PairsSummary ours = summarise({*evaluation});
  EXPECT_EQ(ours.true_pairs, theirs["true_pairs"]);
  EXPECT_EQ(ours.right, theirs["right"]);
  EXPECT_EQ(ours.wrong, theirs["wrong"]);
  EXPECT_EQ(ours.silent_errors, theirs["silent_errors"]);
  EXPECT_EQ(ours.flagged, theirs["flagged"]);
  EXPECT_EQ(ours.flagged_wrong, theirs["flagged_wrong"]);
  EXPECT_EQ(ours.missed, theirs["missed"]);
  EXPECT_EQ(ours.forgotten, theirs["forgotten_scans"]);
  EXPECT_EQ(ours.lone, theirs["lone"]);
  EXPECT_EQ(ours.lone_right, theirs["lone_right"]);
  EXPECT_EQ(ours.slipped, theirs["slipped"]);
  EXPECT_EQ(ours.not_registered, theirs["not_registered"]);
  EXPECT_NEAR(ours.rms_median_mm, theirs["rms_median_mm"], 1e-5);
  EXPECT_NEAR(ours.rms_p95_mm, theirs["rms_p95_mm"], 1e-5);
  EXPECT_NEAR(ours.rms_max_mm, theirs["rms_max_mm"], 1e-5);
  EXPECT_NEAR(ours.share_within_0_10_percent, theirs["share_rms_le_0_10_pct"], 1e-9);
  EXPECT_NEAR(ours.share_of_true_within_0_10_percent, theirs["share_of_all_true_pairs_le_0_10_pct"],
              1e-9);
  EXPECT_NEAR(ours.rotation_median_deg, theirs["rot_median_deg"], 1e-6);
  EXPECT_NEAR(ours.shift_median_mm, theirs["shift_median_mm"], 1e-6);
}

TEST(Agreement, OfPairsThatAreRightAndSlightlyOff) {
  expectSamePairs(answer(shared() / "scans/b01/truth.json", 0.05, 0.02), "b01");
}

TEST(Agreement, OfPairsThatAreSwappedForgottenAndSlipped) {
  Json proposal = answer(shared() / "scans/uneven/truth.json", 0.6, 0.1);
  Json& pairs = proposal["pairs"];
  std::swap(pairs[1]["back"], pairs[2]["back"]);
  pairs.erase(4);
  pairs[0]["back"] = proposal["unpaired_back"][0];
  expectSamePairs(proposal, "uneven");
}

// A true mesh with a wave on it, a piece cut off, and moved a little.
TriangleMesh disturbed(TriangleMesh mesh) {
  for (Eigen::Vector3f& v : mesh.vertices) {
    v += 0.06f * Eigen::Vector3f(std::sin(v.y()), std::sin(v.z() + v.x()), std::cos(v.x()));
    v.x() += 0.05f;
  }
  float highest = -1e9f;
  for (const Eigen::Vector3f& v : mesh.vertices) highest = std::max(highest, v.x());
  std::erase_if(mesh.triangles,
                [&](const auto& t) { return mesh.vertices[t[0]].x() > highest - 6; });
  return mesh;
}

void expectSameFigures(const ModelFigures& ours, const Json& theirs) {
  EXPECT_NEAR(ours.accuracy_mm, theirs["accuracy_mm"], kAgree_mm);
  EXPECT_NEAR(ours.mean_mm, theirs["mae_mm"], kAgree_mm);
  EXPECT_NEAR(ours.sd_mm, theirs["sd_mm"], kAgree_mm);
  // A sample in 100 000: three standard deviations of a share around 90 % are 0.3 %.
  EXPECT_NEAR(ours.completeness_percent, theirs["completeness_pct"], 0.3);
}

TEST(Agreement, OfAModelWithAndWithoutAligning) {
  const fs::path truth_file = shared() / "batches/demo/truth/sherd03.ply";
  const TriangleMesh truth = readPly(truth_file)->mesh;
  const TriangleMesh model = disturbed(truth);
  const fs::path model_file = scratch() / "model.ply";
  ASSERT_TRUE(writePly(model_file, model, "model").has_value());
  QuietProgress quiet;
  for (const auto& [align, word] : {std::pair(Align::None, "none"), std::pair(Align::Icp, "icp")}) {
    const Json theirs =
        script("model " + quoted(model_file) + " " + quoted(truth_file) + " --align " + word);
    const auto ours = compareModel(model, truth, {.align = align, .threads = 2}, quiet, {});
    ASSERT_TRUE(ours.has_value());
    expectSameFigures(*ours, theirs);
    EXPECT_EQ(ours->truth_samples, theirs["truth_samples"]);
    EXPECT_EQ(ours->model_samples, theirs["model_samples"]);
  }
}

TEST(Agreement, OfABatchWithAMissingSherd) {
  const fs::path truth_folder = shared() / "batches/demo/truth";
  const auto sherds = readTrueSherds(truth_folder);
  ASSERT_TRUE(sherds.has_value());
  std::vector<NamedMesh> models, truth;
  const fs::path out = scratch() / "out";
  fs::remove_all(out);
  for (const TrueSherd& sherd : *sherds) {
    truth.push_back({sherd.id, transformed(sherd.mesh, sherd.plate_front_from_model)});
    const int k = static_cast<int>(truth.size());
    if (k != 2 && k != 7) continue;  // the script needs some seconds for each
    models.push_back({"0" + std::to_string(9 - k), disturbed(truth.back().mesh)});
    ASSERT_TRUE(writePly(out / "sherds" / models.back().name / "model.ply", models.back().mesh,
                         "plate_front"));
  }
  const Json theirs = script("batch " + quoted(out) + " " + quoted(truth_folder));
  QuietProgress quiet;
  const auto ours = evaluateBatch(models, truth, {.threads = 2}, quiet, {});
  ASSERT_TRUE(ours.has_value());
  EXPECT_EQ(ours->missing, theirs["missing"]);
  EXPECT_NEAR(ours->accuracy_mm, theirs["mean"]["accuracy_mm"], kAgree_mm);
  EXPECT_NEAR(ours->mean_mm, theirs["mean"]["mae_mm"], kAgree_mm);
  EXPECT_NEAR(ours->completeness_missing_as_zero_percent,
              theirs["completeness_missing_as_zero_pct"], 0.1);
  for (std::size_t i = 0; i < ours->sherds.size(); ++i) {
    const Json& row = theirs["sherds"][i];
    ASSERT_EQ(ours->sherds[i].model.has_value(), !row["model"].is_null());
    if (!ours->sherds[i].model) continue;
    EXPECT_EQ(*ours->sherds[i].model, row["model"]);
    EXPECT_NEAR(ours->sherds[i].overlap, row["overlap"], 0.02);
    expectSameFigures(ours->sherds[i].figures, row);
  }
}

TEST(Agreement, OfOneSidesCloud) {
  const fs::path truth_folder = shared() / "batches/demo/truth";
  const auto sherds = readTrueSherds(truth_folder);
  ASSERT_TRUE(sherds.has_value());
  std::vector<TriangleMesh> truth;
  PointCloud cloud;
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0.04, 0.1);
  for (const TrueSherd& sherd : *sherds) {
    truth.push_back(transformed(sherd.mesh, sherd.plate_back_from_model));
    const SurfaceSamples samples = areaSamples(truth.back(), 0.35, 21);
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      const Eigen::Vector3d normal =
          (samples.normals[i] + 2 * Eigen::Vector3d(noise(random), noise(random), noise(random)))
              .normalized();
      if (samples.normals[i].z() < -0.3 || samples.points[i].x() > 60) continue;
      cloud.points.push_back(
          (samples.points[i] + noise(random) * samples.normals[i]).cast<float>());
      cloud.normals.push_back(normal.cast<float>());
    }
  }
  const fs::path file = scratch() / "cloud.ply";
  ASSERT_TRUE(writePly(file, cloud, "plate_back"));
  const Json theirs =
      script("cloud " + quoted(file) + " --truth " + quoted(truth_folder) + " --side back");
  const auto ours = evaluateCloud(cloud, truth, {.threads = 2});
  ASSERT_TRUE(ours.has_value());
  EXPECT_EQ(ours->points, theirs["points"]);
  EXPECT_NEAR(ours->outlier_percent, theirs["stray_pct"], 1e-9);
  for (const auto& [part, name] :
       {std::pair(&ours->flat, "flat"), std::pair(&ours->strip, "strip")}) {
    const Json& row = theirs[name];
    EXPECT_NEAR(*part->bias_mm, row["bias_mm"], kAgree_mm);
    EXPECT_NEAR(*part->sd_mm, row["sd_mm"], kAgree_mm);
    EXPECT_NEAR(*part->within_90_mm, row["acc90_mm"], kAgree_mm);
    EXPECT_NEAR(*part->normal_deg, row["normal_deg"], 0.5);
    EXPECT_NEAR(*part->covered_percent, row["complete_pct"], 1.0);
  }
}

}  // namespace
}  // namespace ostraka::evaluate
