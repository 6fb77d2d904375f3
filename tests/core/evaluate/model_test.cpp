#include "evaluate/model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "box.h"

namespace ostraka::evaluate {
namespace {

constexpr double kFaces = 2 * 50 * 40;                     // mm^2, upper and lower
constexpr double kWhole = kFaces + 2 * (50 * 6 + 40 * 6);  // mm^2

TriangleMesh shifted(TriangleMesh mesh, const Eigen::Vector3f& by) {
  for (Eigen::Vector3f& v : mesh.vertices) v += by;
  return mesh;
}

ModelFigures compare(const TriangleMesh& model, const TriangleMesh& truth,
                     Align align = Align::None) {
  QuietProgress quiet;
  const auto figures = compareModel(model, truth, {.align = align, .threads = 2}, quiet, {});
  EXPECT_TRUE(figures.has_value());
  return figures ? *figures : ModelFigures{};
}

TEST(CompareModel, FindsNothingWrongWithAPerfectModel) {
  const ModelFigures figures = compare(boxMesh(50, 40, 6, 20), boxMesh(50, 40, 6, 7));
  EXPECT_LT(figures.accuracy_mm, 1e-5);
  EXPECT_LT(figures.max_mm, 1e-5);
  EXPECT_EQ(figures.completeness_percent, 100);
  EXPECT_EQ(figures.model_samples, static_cast<std::size_t>(kWhole / (0.15 * 0.15)));
}

TEST(CompareModel, MeasuresATenthOfAMillimetreOfShift) {
  const TriangleMesh truth = boxMesh(50, 40, 6, 20);
  const ModelFigures figures = compare(shifted(truth, {0, 0, 0.1f}), truth);
  EXPECT_NEAR(figures.accuracy_mm, 0.1, 1e-4);
  // The upper and lower face are 0.1 off, the walls not. What the walls stand out above (0.05 mm on
  // average) the lower face gains at its border, where the wall is nearer than its old place.
  EXPECT_NEAR(figures.mean_mm, 0.1 * kFaces / kWhole, 1e-4);
  EXPECT_EQ(figures.completeness_percent, 100);
}

TEST(CompareModel, TakesOutAPoseErrorOnlyWhenAskedTo) {
  const TriangleMesh truth = boxMesh(50, 40, 6, 20);
  const TriangleMesh model = shifted(truth, {0.2f, -0.1f, 0.1f});
  EXPECT_GT(compare(model, truth).accuracy_mm, 0.09);
  const ModelFigures aligned = compare(model, truth, Align::Icp);
  // Only the walls that look along x hold x: 480 of 5080 mm^2, and as they lie farthest off, half
  // of them are the twentieth that each round leaves out. So a round closes about 5 % of what is
  // left, and the sixty allowed end 0.2 * 0.95^60 = 0.01 mm off.
  EXPECT_LT(aligned.accuracy_mm, 0.02);
  EXPECT_NEAR(aligned.aligned_by_mm, std::sqrt(0.04 + 0.01 + 0.01), 0.03);
  EXPECT_LT(aligned.aligned_by_deg, 0.05);
}

TEST(CompareModel, RefusesATruthWithoutArea) {
  TriangleMesh line;
  line.vertices = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  line.triangles = {{0, 1, 2}, {2, 1, 0}, {0, 0, 1}};
  QuietProgress quiet;
  const auto figures = compareModel(line, line, {.align = Align::None, .threads = 1}, quiet, {});
  ASSERT_FALSE(figures.has_value());
  EXPECT_EQ(figures.error().code, ErrorCode::UnusableInput);
}

TEST(CompareModel, CountsAMissingFaceAgainstCompletenessNotAccuracy) {
  const TriangleMesh truth = boxMesh(50, 40, 6, 20);
  TriangleMesh open = truth;
  std::erase_if(open.triangles, [&](const auto& t) {
    return open.vertices[t[0]].z() > 5.9f && open.vertices[t[1]].z() > 5.9f &&
           open.vertices[t[2]].z() > 5.9f;
  });
  const ModelFigures figures = compare(open, truth);
  // Of the upper face the outermost 0.25 mm lie near enough to the walls.
  EXPECT_NEAR(figures.completeness_percent, 100 * (kWhole - 49.5 * 39.5) / kWhole, 0.1);
  EXPECT_LT(figures.accuracy_mm, 1e-5);
}

TEST(CompareModel, RefusesATruthWithoutFacesAndAnEmptyModel) {
  QuietProgress quiet;
  TriangleMesh points;
  points.vertices = {{0, 0, 0}};
  EXPECT_FALSE(compareModel(boxMesh(1, 1, 1), points, {}, quiet, {}).has_value());
  EXPECT_FALSE(compareModel({}, boxMesh(1, 1, 1), {}, quiet, {}).has_value());
}

TEST(CompareModel, StopsWhenAsked) {
  QuietProgress quiet;
  std::stop_source source;
  source.request_stop();
  const auto figures =
      compareModel(boxMesh(1, 1, 1), boxMesh(1, 1, 1), {}, quiet, source.get_token());
  ASSERT_FALSE(figures.has_value());
  EXPECT_EQ(figures.error().code, ErrorCode::Cancelled);
}

TEST(EvaluateBatch, FindsEachModelsSherdAndCountsTheMissingOneAsZero) {
  const TriangleMesh box = boxMesh(50, 40, 6, 20);
  const std::vector<NamedMesh> truth = {
      {"s0", box}, {"s1", shifted(box, {100, 0, 0})}, {"s2", shifted(box, {200, 0, 0})}};
  const std::vector<NamedMesh> models = {{"01", shifted(box, {200, 0, 0})},
                                         {"02", shifted(box, {0, 0, 0.1f})},
                                         {"03", shifted(box, {0, 300, 0})}};
  QuietProgress quiet;
  const auto batch = evaluateBatch(models, truth, {.threads = 2}, quiet, {});
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->sherds[0].model, "02");
  EXPECT_FALSE(batch->sherds[1].model.has_value());
  EXPECT_EQ(batch->sherds[2].model, "01");
  EXPECT_EQ(batch->missing, 1);
  EXPECT_EQ(batch->superfluous, std::vector<std::string>{"03"});
  EXPECT_NEAR(batch->accuracy_mm, 0.05, 1e-4);
  EXPECT_NEAR(batch->completeness_missing_as_zero_percent, 200.0 / 3, 1e-9);
  EXPECT_FALSE(batch->goals_met);
}

TEST(EvaluateBatch, PrefersTheBestSumOfOverlapsToTheFirstGoodOne) {
  // Models shifted by 0.6 and -0.6 mm of a thin plate overlap both truths; the best sum keeps
  // order.
  const TriangleMesh plate = boxMesh(30, 30, 4, 4);
  const std::vector<NamedMesh> truth = {{"a", plate}, {"b", shifted(plate, {12, 0, 0})}};
  const std::vector<NamedMesh> models = {{"1", shifted(plate, {11, 0, 0})},
                                         {"2", shifted(plate, {1, 0, 0})}};
  QuietProgress quiet;
  const auto batch = evaluateBatch(models, truth, {.threads = 1}, quiet, {});
  ASSERT_TRUE(batch.has_value());
  EXPECT_EQ(batch->sherds[0].model, "2");
  EXPECT_EQ(batch->sherds[1].model, "1");
}

}  // namespace
}  // namespace ostraka::evaluate
