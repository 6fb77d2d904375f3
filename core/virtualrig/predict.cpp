#include "virtualrig/predict.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "base/parallel.h"
#include "base/text.h"
#include "cloud/ply.h"
#include "evaluate/model.h"
#include "evaluate/truth.h"
#include "files/json.h"
#include "files/json_numbers.h"
#include "pipeline/preflight.h"
#include "pipeline/process_batch.h"
#include "virtualrig/simulate.h"

namespace ostraka::virtualrig {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> kNames{"small", "medium", "large"};
constexpr std::array<double, 3> kRadii_mm{12, 22, 37};  // of outlines; sherds are 2.2 times as wide

// Of a trial's time; simulating takes what is left of processing it.
constexpr double kProcessShare = 0.75;

// What stereo works on: large photographs are averaged down before.
int workingWidth(const rig::Rig& rig) {
  const rig::Intrinsics& own = rig.cameras.front().intrinsics;
  return rig::reducedTo(own, pipeline::kUsualMegapixels).width / 4 * 4;
}

// One of several trials: its stages have their share of it.
class TrialProgress final : public Progress {
 public:
  TrialProgress(Progress& whole, double share) : whole_(whole), share_(share) {}
  void begin(std::string_view stage, double share) override {
    whole_.begin(stage, share * share_ * kProcessShare);
  }
  void report(std::int64_t done, std::int64_t total) override { whole_.report(done, total); }
  void note(NoteLevel level, const Message& text) override { whole_.note(level, text); }

 private:
  Progress& whole_;
  double share_;
};

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

// What the rays tell, and which moves they recommend.
Result<std::vector<CameraMove>> lookByRays(const rig::Rig& rig, const SimulateOptions& simulated,
                                           const PredictOptions& options, Prediction& prediction,
                                           std::stop_token stop) {
  const Result<std::vector<vessels::VirtualSherd>> sherds = makeSherds(simulated);
  if (!sherds) return sherds.error();
  const VirtualRig real = asVirtual(rig, rig.cameras.front().intrinsics.width);
  CoverageOptions coverage_options;
  coverage_options.threads = options.threads;
  const Result<std::vector<SherdCoverage>> looked = coverage(*sherds, real, coverage_options, stop);
  if (!looked) return looked.error();
  const std::vector<SherdCoverage>& found = *looked;
  for (std::size_t i = 0; i < found.size(); ++i) {
    SizePrediction& size = sizeOf(prediction, i, options.sherds_per_size);
    size.width_mm += (*sherds)[i].width_mm / options.sherds_per_size;
    size.seen += found[i].seen / options.sherds_per_size;
    size.break_seen += found[i].break_seen / options.sherds_per_size;
    prediction.outside += found[i].outside / static_cast<double>(found.size());
  }
  for (int c = 0; c < real.cameras(); ++c) {
    prediction.cameras.push_back(rig.cameras[static_cast<std::size_t>(c)].camera);
    prediction.elevations_rad.push_back(elevation(real, c));
    prediction.pixels_mm.push_back(pixelSize(real, c));
  }
  if (options.moves == 0) return std::vector<CameraMove>();
  return promisingMoves(*sherds, real, coverage_options, stop);
}

std::string cameraName(const rig::Rig& rig, std::size_t c) {
  return "Camera " + batch::cameraLetter(rig.cameras[c].camera);
}

// Of small, medium and large sherds.
std::string figuresOf(const Prediction& prediction, const std::array<SizePrediction, 3>& sizes) {
  return formatted("%.3f, %.3f, %.3f mm and ", prediction.expectedAccuracy(sizes[0]),
                   prediction.expectedAccuracy(sizes[1]), prediction.expectedAccuracy(sizes[2])) +
         formatted("%.1f, %.1f, %.1f %%", sizes[0].completeness_percent,
                   sizes[1].completeness_percent, sizes[2].completeness_percent);
}

void remarkOnMoves(const rig::Rig& rig, const PredictOptions& options, Prediction& prediction) {
  for (const MoveTried& tried : prediction.moves) {
    const double degrees = tried.move.raise_rad * 180 / M_PI;
    const std::string name = cameraName(rig, static_cast<std::size_t>(tried.move.camera)),
                      where = degrees > 0 ? "higher" : "lower",
                      figures =
                          "; in a simulation of this with the same sherds, the accuracy and "
                          "completeness of small, medium and large ones are " +
                          figuresOf(prediction, tried.sizes) + " instead of " +
                          figuresOf(prediction, prediction.sizes) + ".";
    prediction.remarks.push_back(
        tried.better
            ? name + " should be " + where +
                  formatted(", by %.0f degrees about the plate's middle", std::abs(degrees)) +
                  figures
            : name + " can stay: " + formatted("%.0f degrees ", std::abs(degrees)) + where +
                  " is most promising, but models would not be better" + figures);
  }
  if (prediction.moves.empty() && options.moves > 0)
    prediction.remarks.push_back(
        "No camera needs to be moved: 10 or 20 degrees higher or lower, none would view the sherds "
        "more squarely and stay close enough to the others for image matching.");
}

void remark(const rig::Rig& rig, const PredictOptions& options, Prediction& prediction) {
  const double finest = *std::min_element(prediction.pixels_mm.begin(), prediction.pixels_mm.end());
  for (std::size_t c = 0; c < prediction.pixels_mm.size(); ++c)
    if (prediction.pixels_mm[c] > 1.3 * finest)
      prediction.remarks.push_back(cameraName(rig, c) +
                                   formatted(" resolves %.2f mm per pixel, the finest camera %.2f; "
                                             "move it closer or zoom in, then recalibrate.",
                                             prediction.pixels_mm[c], finest));
  if (prediction.outside > 0.005)
    prediction.remarks.push_back(formatted(
        "On average, %.1f %% of the sherds' surface falls outside a camera's picture; aim "
        "the cameras at the plate's middle, or move them back.",
        100 * prediction.outside));
  remarkOnMoves(rig, options, prediction);
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
    (of_sherds ? times.sherds_s : times.fixed_s) += numberAt(stage, "seconds");
  }
  return times;
}

// The whole chain on the simulated batch, and its models against the truth.
Result<void> tryTheChain(const rig::Rig& rig, const SimulateOptions& simulated,
                         const PredictOptions& options, Prediction& prediction,
                         Progress& whole_progress, std::stop_token stop) {
  const double share = 1.0 / (1 + options.moves);
  whole_progress.begin("simulated photographs", share * (1 - kProcessShare));
  TrialProgress progress(whole_progress, share);
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
  const std::clock_t before = std::clock();  // of all threads
  const Result<pipeline::ProcessSummary> summary = pipeline::processBatch(process, progress, stop);
  if (!summary) return summary.error();
  prediction.seconds = summary->seconds;
  prediction.processors = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC /
                          std::max(summary->seconds, 1e-3);
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

// The same sherds from where the camera would stand.
Result<MoveTried> tryMove(const rig::Rig& rig, const CameraMove& move, PredictOptions options,
                          const std::string& folder, Progress& progress, std::stop_token stop) {
  rig::Rig moved = rig;
  Eigen::Isometry3d& pose =
      moved.cameras[static_cast<std::size_t>(move.camera)].camera_from_turntable;
  pose = raised(pose, move.raise_rad);
  options.work /= folder;
  Prediction there;
  const Result<void> tried =
      tryTheChain(moved, simulateOptions(moved, options), options, there, progress, stop);
  if (!tried && tried.error().code == ErrorCode::NotEnough)  // no sherd found, or the like
    for (SizePrediction& size : there.sizes)
      size.sherds = size.without_model = options.sherds_per_size;
  else if (!tried)
    return tried.error();
  return MoveTried{move, there.sizes, false};
}

}  // namespace

bool isBetter(const std::array<SizePrediction, 3>& after,
              const std::array<SizePrediction, 3>& before) {
  constexpr double kBetter = 0.9, kBetterPercent = 1, kSame = 1.03, kSamePercent = 0.3,
                   kWorse = 4.0 / 3, kWorsePercent = 3;
  double log_ratio = 0, percent = 0;
  int more_models = 0, compared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const SizePrediction &a = after[k], &b = before[k];
    if (a.without_model > b.without_model) return false;
    more_models += b.without_model - a.without_model;
    if (b.without_model == b.sherds) continue;
    const double more_percent = a.completeness_percent - b.completeness_percent;
    if (a.accuracy_mm > kWorse * b.accuracy_mm || more_percent < -kWorsePercent) return false;
    log_ratio += std::log(a.accuracy_mm / b.accuracy_mm);
    percent += more_percent;
    ++compared;
  }
  if (compared == 0) return more_models > 0;
  const double ratio = std::exp(log_ratio / compared);
  percent /= compared;
  if (ratio > kSame || percent < -kSamePercent) return false;
  return more_models > 0 || ratio < kBetter || percent > kBetterPercent;
}

Result<void> PredictOptions::check() const {
  if (width != 0 && (width < 400 || width > 8192 || width % 4 != 0))
    return Error::unusable(
        "width must be 0, or be between 400 and 8192 pixels and divisible by 4.");
  if (sherds_per_size < 1 || sherds_per_size > 4)
    return Error::unusable("sherds_per_size must be between 1 and 4.");
  if (moves < 0 || moves > 9) return Error::unusable("moves must be between 0 and 9.");
  if (work.empty()) return Error::unusable("work must name a folder.");
  return {};
}

Result<Prediction> predict(const rig::Rig& rig, const PredictOptions& options, Progress& progress,
                           std::stop_token stop) {
  if (const Result<void> good = options.check(); !good) return good.error();
  if (rig.cameras.empty())
    return Error::unusable(message("The rig has no camera; recalibrate it."));
  PredictOptions fitting = options;
  const int most = workingWidth(rig);
  fitting.width = options.width == 0 ? most : std::min(options.width, most);
  Prediction prediction;
  for (std::size_t k = 0; k < 3; ++k) prediction.sizes[k].name = kNames[k];
  prediction.width_share = static_cast<double>(fitting.width) / most;
  prediction.photographs = static_cast<int>(2 * rig.cameras.size() * rig.stops.size());
  const SimulateOptions simulated = simulateOptions(rig, fitting);
  if (const Result<void> valid = simulated.check(); !valid) return valid.error();
  const Result<std::vector<CameraMove>> moves =
      lookByRays(rig, simulated, fitting, prediction, stop);
  if (!moves) return moves.error();
  fitting.moves = std::min(fitting.moves, static_cast<int>(moves->size()));
  prediction.threads = options.threads > 0 ? options.threads : availableThreads();
  if (const Result<void> tried = tryTheChain(rig, simulated, fitting, prediction, progress, stop);
      !tried)
    return tried.error();
  for (int k = 0; k < fitting.moves; ++k) {
    Result<MoveTried> tried = tryMove(rig, (*moves)[static_cast<std::size_t>(k)], fitting,
                                      "move" + std::to_string(k + 1), progress, stop);
    if (!tried) return tried.error();
    tried->better = isBetter(tried->sizes, prediction.sizes);
    prediction.moves.push_back(*tried);
    if (tried->better) break;
  }
  remark(rig, options, prediction);
  return prediction;
}

}  // namespace ostraka::virtualrig
