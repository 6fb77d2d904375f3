#include "virtualrig/predict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/json.h"
#include "cloud/ply.h"
#include "evaluate/model.h"
#include "evaluate/truth.h"
#include "pipeline/process_batch.h"
#include "virtualrig/simulate.h"

namespace ostraka::virtualrig {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> kNames{"small", "medium", "large"};
constexpr std::array<double, 3> kRadii_mm{12, 22, 37};  // of outlines; sherds are 2.2 times as wide

std::string words(const char* format, double a, double b = 0) {
  char text[200];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

// What masks and stereo work on: large photographs are averaged down before.
int workingWidth(const rig::Rig& rig) {
  const rig::Intrinsics& own = rig.cameras.front().intrinsics;
  return rig::reducedTo(own, pipeline::ProcessOptions{}.megapixels).width / 4 * 4;
}

SimulateOptions simulateOptions(const rig::Rig& rig, const PredictOptions& options) {
  SimulateOptions out;
  out.seed = options.seed;
  out.sherds = 3 * options.sherds_per_size;
  out.width = options.width;
  out.output = options.work / "batch";
  out.threads = options.threads;
  out.rig = rig;
  for (std::size_t size = 3; size-- > 0;)  // largest first
    out.radii_mm.insert(out.radii_mm.end(), static_cast<std::size_t>(options.sherds_per_size),
                        kRadii_mm[size]);
  return out;
}

// Sherds come largest first.
SizePrediction& sizeOf(Prediction& prediction, std::size_t sherd, int per_size) {
  return prediction.sizes[2 - sherd / static_cast<std::size_t>(per_size)];
}

// What the rays tell, and the sentences about the rig itself.
Result<void> lookByRays(const rig::Rig& rig, const SimulateOptions& simulated,
                        const PredictOptions& options, Prediction& prediction,
                        std::stop_token stop) {
  const Result<std::vector<VirtualSherd>> sherds = makeSherds(simulated);
  if (!sherds) return sherds.error();
  const VirtualRig real = asVirtual(rig, rig.cameras.front().intrinsics.width);
  CoverageOptions coverage_options;
  coverage_options.threads = options.threads;
  const std::vector<SherdCoverage> found = coverage(*sherds, real, coverage_options);
  for (std::size_t i = 0; i < found.size(); ++i) {
    SizePrediction& size = sizeOf(prediction, i, options.sherds_per_size);
    size.width_mm += (*sherds)[i].width_mm / options.sherds_per_size;
    size.seen += found[i].seen / options.sherds_per_size;
    size.break_seen += found[i].break_seen / options.sherds_per_size;
    prediction.outside += found[i].outside / static_cast<double>(found.size());
  }
  const Result<CameraAdvice> advice = bestMove(*sherds, real, coverage_options, stop);
  if (!advice) return advice.error();
  prediction.advice = *advice;
  for (int c = 0; c < real.cameras(); ++c) {
    prediction.cameras.push_back(rig.cameras[static_cast<std::size_t>(c)].camera);
    prediction.elevations_rad.push_back(elevation(real, c));
    prediction.pixels_mm.push_back(pixelSize(real, c));
  }
  return {};
}

void remark(const rig::Rig& rig, Prediction& prediction) {
  const auto name = [&](std::size_t c) {
    return "Camera " + batch::cameraLetter(rig.cameras[c].camera);
  };
  const double finest = *std::min_element(prediction.pixels_mm.begin(), prediction.pixels_mm.end());
  for (std::size_t c = 0; c < prediction.pixels_mm.size(); ++c)
    if (prediction.pixels_mm[c] > 1.3 * finest)
      prediction.remarks.push_back(
          name(c) + words(" resolves %.2f mm a pixel, the finest %.2f; bring it nearer or zoom in, "
                          "and calibrate again.",
                          prediction.pixels_mm[c], finest));
  if (prediction.outside > 0.005)
    prediction.remarks.push_back(words(
        "%.1f %% of what the cameras look at falls outside of their pictures; aim them at the "
        "plate's middle or move them back.",
        100 * prediction.outside));
  if (prediction.advice.raise_rad != 0)
    prediction.remarks.push_back(
        name(static_cast<std::size_t>(prediction.advice.camera)) +
        (prediction.advice.raise_rad > 0 ? " should stand higher" : " should stand lower") +
        words(", by %.0f degrees about the plate's middle: %.1f %% more of the broken edges would "
              "be seen.",
              std::abs(prediction.advice.raise_rad) * 180 / M_PI, 100 * prediction.advice.gain));
  else
    prediction.remarks.push_back("No camera needs to be moved.");
}

Result<std::vector<evaluate::NamedMesh>> modelsOf(const fs::path& output,
                                                  const pipeline::ProcessSummary& summary) {
  std::vector<evaluate::NamedMesh> models;
  for (const pipeline::SherdSummary& sherd : summary.sherds) {
    if (!sherd.has_model) continue;
    Result<PlyContents> model = readPly(output / "sherds" / sherd.number / "model.ply");
    if (!model) return model.error();
    models.push_back({sherd.number, std::move(model->mesh)});
  }
  return models;
}

double surface(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]],
                          &c = mesh.vertices[t[2]];
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

struct Times {
  double fixed_s = 0, sherds_s = 0;  // whatever lies on the plate; by the sherds' surface
};

Result<Times> timesOf(const fs::path& output) {
  const Result<nlohmann::json> report = readJson(output / "report.json");
  if (!report) return report.error();
  Times times;
  for (const nlohmann::json& stage : report->at("stages")) {
    const auto name = stage.at("stage").get<std::string>();
    const bool of_sherds = name.starts_with("stereo") || name.starts_with("model");
    (of_sherds ? times.sherds_s : times.fixed_s) += stage.at("seconds").get<double>();
  }
  return times;
}

// The whole chain on the simulated batch, and its models against the truth.
Result<void> tryTheChain(const rig::Rig& rig, const SimulateOptions& simulated,
                         const PredictOptions& options, Prediction& prediction, Progress& progress,
                         std::stop_token stop) {
  if (const Result<void> made = simulateBatch(simulated, progress, stop); !made)
    return made.error();
  rig::Rig scaled = rig;
  const VirtualRig seen = asVirtual(rig, options.width);
  for (std::size_t c = 0; c < scaled.cameras.size(); ++c) {
    scaled.cameras[c].camera = static_cast<int>(c);  // as the simulation numbers them
    scaled.cameras[c].intrinsics = seen.intrinsics[c];
    scaled.cameras[c].marker_inset_px = 0;
    scaled.cameras[c].covariance.clear();
  }
  for (std::size_t k = 0; k < scaled.stops.size(); ++k) scaled.stops[k] = static_cast<int>(k);
  const fs::path rig_file = options.work / "rig.json";
  if (const Result<void> written = rig::writeRig(rig_file, scaled); !written) return written;
  pipeline::ProcessOptions process;
  process.batch = simulated.output;
  process.output = options.work / "result";
  process.rig = rig_file;
  process.threads = options.threads;
  const Result<pipeline::ProcessSummary> summary = pipeline::processBatch(process, progress, stop);
  if (!summary) return summary.error();
  prediction.seconds = summary->seconds;
  const Result<std::vector<evaluate::NamedMesh>> models = modelsOf(process.output, *summary);
  if (!models) return models.error();
  const Result<std::vector<evaluate::TrueSherd>> truth =
      evaluate::readTrueSherds(simulated.output / "truth");
  if (!truth) return truth.error();
  std::vector<evaluate::NamedMesh> true_meshes;
  for (const evaluate::TrueSherd& sherd : *truth)
    true_meshes.push_back({sherd.id, transformed(sherd.mesh, sherd.plate_front_from_model)});
  evaluate::ModelOptions model_options;
  model_options.threads = options.threads;
  const Result<evaluate::BatchEvaluation> figures =
      evaluate::evaluateBatch(*models, true_meshes, model_options, progress, stop);
  if (!figures) return figures.error();
  const Result<Times> times = timesOf(process.output);
  if (!times) return times.error();
  prediction.fixed_seconds = times->fixed_s;
  double area = 0;
  for (const evaluate::NamedMesh& one : true_meshes) area += surface(one.mesh);
  for (std::size_t i = 0; i < figures->sherds.size(); ++i)
    sizeOf(prediction, i, options.sherds_per_size).seconds +=
        times->sherds_s * surface(true_meshes[i].mesh) / area / options.sherds_per_size;
  for (std::size_t i = 0; i < figures->sherds.size(); ++i) {
    SizePrediction& size = sizeOf(prediction, i, options.sherds_per_size);
    ++size.sherds;
    if (!figures->sherds[i].model) {
      ++size.without_model;
      continue;
    }
    size.accuracy_mm += figures->sherds[i].figures.accuracy_mm;
    size.completeness_percent += figures->sherds[i].figures.completeness_percent;
  }
  for (SizePrediction& size : prediction.sizes) {
    const int models_made = size.sherds - size.without_model;
    if (models_made == 0) continue;
    size.accuracy_mm /= models_made;
    size.completeness_percent /= models_made;
  }
  return {};
}

}  // namespace

Result<void> PredictOptions::check() const {
  if (width != 0 && (width < 400 || width > 8192 || width % 4 != 0))
    return Error{ErrorCode::UnusableInput,
                 "width must be 0, or lie between 400 and 8192 pixels and be divisible by 4.",
                 {}};
  if (sherds_per_size < 1 || sherds_per_size > 4)
    return Error{ErrorCode::UnusableInput, "sherds_per_size must lie between 1 and 4.", {}};
  if (work.empty()) return Error{ErrorCode::UnusableInput, "work must name a folder.", {}};
  return {};
}

Result<Prediction> predict(const rig::Rig& rig, const PredictOptions& options, Progress& progress,
                           std::stop_token stop) {
  if (const Result<void> good = options.check(); !good) return good.error();
  if (rig.cameras.empty())
    return Error{ErrorCode::UnusableInput, "The rig has no camera; calibrate it again.", {}};
  PredictOptions fitting = options;
  const int most = workingWidth(rig);
  fitting.width = options.width == 0 ? most : std::min(options.width, most);
  Prediction prediction;
  for (std::size_t k = 0; k < 3; ++k) prediction.sizes[k].name = kNames[k];
  prediction.width_share = static_cast<double>(fitting.width) / most;
  prediction.photographs = static_cast<int>(2 * rig.cameras.size() * rig.stops.size());
  const SimulateOptions simulated = simulateOptions(rig, fitting);
  if (const Result<void> valid = simulated.check(); !valid) return valid.error();
  if (const Result<void> seen = lookByRays(rig, simulated, fitting, prediction, stop); !seen)
    return seen.error();
  remark(rig, prediction);
  if (const Result<void> tried = tryTheChain(rig, simulated, fitting, prediction, progress, stop);
      !tried)
    return tried.error();
  return prediction;
}

}  // namespace ostraka::virtualrig
