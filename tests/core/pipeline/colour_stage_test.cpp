// A colour chart in one of the photographs corrects the colours of all that is made of the batch.
#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "../colour/rendered_chart.h"
#include "cloud/ply.h"
#include "files/files.h"
#include "files/json.h"
#include "pipeline/chain.h"
#include "tests/core/files/temporary_folder.h"
#include "texture/texture.h"
#include "virtualrig/simulate.h"

namespace ostraka::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ColourStage : public testing::Test {
 protected:
  static void write(const fs::path& file, const cv::Mat3b& picture, const char* ending) {
    std::vector<unsigned char> bytes;
    cv::imencode(ending, picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 97});
    const std::string content(bytes.begin(), bytes.end());
    ASSERT_TRUE(writeFileAtomically(file, content).has_value());
  }

  static cv::Mat3f sceneWith(const cv::Mat3f& chart, float exposure = 1) {
    cv::Mat3f scene = colour::sceneWithSherds();
    colour::lay(chart, {{560, 380}, {960, 430}, {930, 690}, {520, 640}}, scene);
    return cv::Mat3f(scene * exposure);
  }

  // The photographs as front/0.png, front/1.png, ...
  Result<Staged<std::optional<colour::Correction>>> stageOf(const std::vector<cv::Mat3f>& scenes) {
    batch::Batch batch;
    batch.folder = folder;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const fs::path file = folder / "front" / (std::to_string(i) + ".png");
      write(file, colour::photographed(scenes[i], 2), ".png");
      batch.shots.push_back({batch::Side::Front, 0, static_cast<int>(i), file, {}, 1600, 1200});
    }
    const stages::BatchInputs inputs(batch, 2);
    fs::create_directories(folder / "work");
    const Result<FolderLock> held = FolderLock::take(folder / "work");
    if (!held) return held.error();
    const ProcessOptions options;
    const decisions::Decisions none;
    QuietProgress quiet;
    const pipeline::Run run{options, batch, *held, folder / "work", inputs,
                            "",      {},    none,  quiet,           {}};
    return colourStage(run);
  }

  TemporaryFolder temporary;
  fs::path folder = temporary.path();
};

TEST_F(ColourStage, TakesTheChartOfWhicheverPhotographShowsIt) {
  const cv::Mat3f chart = colour::chartOf(colour::photographedPatches(colour::camera()));
  const auto found =
      stageOf({colour::sceneWithSherds(), sceneWith(chart), sceneWith(cv::Mat3f(chart * 0.5))});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  ASSERT_TRUE(found->value.has_value());
  // The mean of both exposures.
  EXPECT_LT((found->value->matrix * colour::camera() * 0.75 - Eigen::Matrix3d::Identity()).norm(),
            0.08);
  const nlohmann::ordered_json& figures = found->record.notes.figures;
  EXPECT_EQ(figures.at("photographs_with_chart"), 2);
  EXPECT_LT(figures.at("ciede2000_95").get<double>(), 1.5);
  EXPECT_LE(figures.at("ciede2000_median"), figures.at("ciede2000_95"));
  EXPECT_EQ(found->value->median, figures.at("ciede2000_median").get<double>());
  EXPECT_EQ(found->value->within_95, figures.at("ciede2000_95").get<double>());
  EXPECT_TRUE(found->record.notes.warnings.empty());
}

TEST_F(ColourStage, LeavesNothingWithoutAChart) {
  const auto found = stageOf({colour::sceneWithSherds()});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_FALSE(found->value.has_value());
  EXPECT_TRUE(found->record.notes.figures.empty());
  EXPECT_TRUE(found->record.notes.warnings.empty());
}

TEST_F(ColourStage, NamesAChartThatItDoesNotUse) {
  const cv::Mat3f chart = colour::chartOf(colour::photographedPatches(colour::camera()));
  const auto found = stageOf({sceneWith(chart, 2.2f)});
  ASSERT_TRUE(found.has_value()) << found.error().sentence();
  EXPECT_FALSE(found->value.has_value());
  ASSERT_EQ(found->record.notes.warnings.size(), 1u);
  EXPECT_THAT(found->record.notes.warnings[0].english(), HasSubstr("0.png"));
}

Eigen::Vector3d meanOf(const std::vector<Color>& colours) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Color& c : colours) mean += Eigen::Vector3d(c[0], c[1], c[2]);
  return mean / static_cast<double>(colours.size());
}

// As the camera that all photographs are taken to come from turns them darker and warmer, so much
// brighter and cooler is what is made of them.
TEST_F(ColourStage, CorrectsPointsAndTextures) {
  virtualrig::SimulateOptions simulated;
  simulated.seed = 7;
  simulated.sherds = 2;
  simulated.width = 800;
  simulated.output = folder / "batch";
  QuietProgress quiet;
  const Result<void> made = virtualrig::simulateBatch(simulated, quiet, {});
  ASSERT_TRUE(made.has_value()) << made.error().sentence();
  const fs::path shown =
      folder / "batch" / "front" / "cam0_pos00.jpg";  // above the plate's far edge
  cv::Mat3f light = colour::lightIn(*batch::readPhotograph(shown));
  colour::lay(colour::chartOf(colour::photographedPatches(colour::camera())),
              {{10, 5}, {205, 8}, {203, 140}, {8, 138}}, light);
  write(shown, colour::photographed(light, 1), ".jpg");
  ProcessOptions options;
  options.batch = folder / "batch";
  options.output = folder / "out";
  const Result<ProcessSummary> summary = processBatch(options, quiet, {});
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();

  const auto report = readJson(options.output / "report.json");
  ASSERT_TRUE(report.has_value());
  colour::Correction correction;
  for (const nlohmann::json& stage : report->at("stages"))
    if (stage.at("stage") == "colours")
      for (Eigen::Index r = 0; r < 3; ++r)
        for (Eigen::Index c = 0; c < 3; ++c)
          correction.matrix(r, c) = stage.at("figures").at("matrix").at(r).at(c).get<double>();
  ASSERT_GT(correction.matrix(0, 0), 1.2) << "the chart was not found";
  const std::string html = *readFile(options.output / "report.html");
  EXPECT_THAT(html, HasSubstr("their reference by"));
  EXPECT_THAT(html, HasSubstr("Measured by the colour chart"));
  for (const SherdSummary& sherd : summary->sherds) {
    ASSERT_TRUE(sherd.munsell && sherd.munsell->chart) << sherd.number;
    EXPECT_GT(sherd.munsell->chart->within_95, 0);
  }

  const auto add = [](std::vector<Color>& all, const fs::path& file) {
    const Result<PointCloud> cloud = readPlyCloud(file);
    ASSERT_TRUE(cloud.has_value()) << cloud.error().sentence();
    all.insert(all.end(), cloud->colors.begin(), cloud->colors.end());
  };
  std::vector<Color> photographed, points, texels;
  for (const char* side : {"dense_front", "dense_back"})
    add(photographed, options.output / "work" / side / "cloud.ply");
  for (const char* number : {"01", "02"}) {
    const fs::path sherd = options.output / "sherds" / number;
    for (const char* scan : {"front.ply", "back.ply"}) add(points, sherd / scan);
    const auto textured = texture::openedBeside(sherd / "model.ply");
    ASSERT_TRUE(textured.has_value() && textured->has_value());
    const std::vector<Color> of_model = texture::vertexColours(**textured);
    texels.insert(texels.end(), of_model.begin(), of_model.end());
  }
  std::vector<Color> corrected;
  for (const Color& c : photographed) corrected.push_back(correction.of(c));
  for (const std::vector<Color>& result : {points, texels}) {
    const double off = (meanOf(result) - meanOf(corrected)).norm();
    EXPECT_LT(off, 0.5 * (meanOf(result) - meanOf(photographed)).norm());
    EXPECT_LT(off, 20);  // levels
  }
}

}  // namespace
}  // namespace ostraka::pipeline
