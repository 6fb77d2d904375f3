// How well and how fast true pairs are registered, and how far false pairs of look-alikes stand
// apart. Prints one row per pair and a summary per set.
//   registration_accuracy SHARED/scans [--sets b01,stereo] [--method M] [--boundary B] [--size S]
//                         [--starts N] [--false] [--rows] [--batch SHARED/batches/demo]
// M, B: as in `ostraka process --registration M --boundary B`.
// --size S: the backs are made smaller by S, and BBICP has to find it (register --scale free).
// --batch: the photographs' masks and true cameras as constraints (for the set stereo).
#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <random>
#include <string>
#include <vector>

#include "cloud/ply.h"
#include "files/json.h"
#include "registration/register_sides.h"

namespace {

using namespace ostraka;
using Eigen::Isometry3d;
using Eigen::Vector3d;

struct Pair {
  std::string front, back;
  Isometry3d truth = Isometry3d::Identity();
  int group = -1;
  bool is_true = true;
  Vector3d up = Vector3d::UnitZ();
};

struct Row {
  double rms = 0, height = 0, seconds = 0;
  registration::Registration found;
};

struct Arguments {
  std::filesystem::path scans;
  std::vector<std::string> sets = {"b01",        "b02",    "b03",    "b04",   "b05",
                                   "lookalikes", "uneven", "stereo", "flake", "flake_narrow"};
  std::string method = "default", boundary = "strip";
  int starts = 3;
  double size = 1;
  bool false_pairs = false, rows = false;
  std::filesystem::path batch;  // a batch with truth: its cameras and masks are constraints
};

struct Views {
  std::vector<rig::PosedImage> cameras;
  std::vector<cv::Mat1b> masks;  // all sherds
};

Views readViews(const std::filesystem::path& batch) {
  Views views;
  if (batch.empty()) return views;
  const auto cameras = rig::readCameras(batch / "truth" / "cameras.json");
  if (!cameras) {
    std::fprintf(stderr, "%s\n", cameras.error().sentence().english().c_str());
    return views;
  }
  for (const rig::PosedImage& camera : *cameras) {
    char name[64];
    std::snprintf(name, sizeof name, "%s_cam%d_pos%02d.png", batch::name(camera.side),
                  camera.camera, camera.stop);
    const cv::Mat1b labels =
        cv::imread((batch / "truth" / "masks" / name).string(), cv::IMREAD_GRAYSCALE);
    views.cameras.push_back(camera);
    views.masks.push_back(labels > 0);
  }
  return views;
}

std::vector<registration::SilhouetteView> silhouettes(const Views& views, batch::Side side) {
  std::vector<registration::SilhouetteView> chosen;
  for (std::size_t i = 0; i < views.cameras.size(); ++i)
    if (views.cameras[i].side == side && !views.masks[i].empty())
      chosen.push_back({views.cameras[i], views.masks[i]});
  return chosen;
}

double cpuSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<Pair> readPairs(const std::filesystem::path& set) {
  std::vector<Pair> pairs;
  const auto json = readJson(set / "truth.json");
  if (!json) return pairs;
  for (const auto& p : (*json)["pairs"]) {
    Pair pair{p["front"], p["back"]};
    pair.truth = *isometryFromJson(p["T_front_from_back"], "truth.json");
    if (p["lookalike_group"].is_number()) pair.group = p["lookalike_group"];
    pairs.push_back(pair);
  }
  return pairs;
}

// Small errors as the pairing's start poses have them: along the fracture, tilt, height.
Isometry3d disturbed(const Isometry3d& truth, const PointCloud& back, std::mt19937_64& random) {
  const auto uniform = [&random](double limit) {
    return limit * (2.0 * static_cast<double>(random() >> 11) / 9007199254740992.0 - 1.0);
  };
  Vector3d centre = Vector3d::Zero();
  for (const auto& p : back.points) centre += p.cast<double>();
  centre /= static_cast<double>(back.size());
  double square = 0;
  for (const auto& p : back.points) square += (p.cast<double>() - centre).squaredNorm();
  const double radius = std::sqrt(square / static_cast<double>(back.size()));
  const Vector3d at = truth * centre;
  Isometry3d change = Isometry3d::Identity();
  change.translate(at + Vector3d(uniform(1), uniform(1), uniform(3)));
  change.rotate(Eigen::AngleAxisd(uniform(std::min(0.087, 3.0 / radius)), Vector3d::UnitZ()));
  change.rotate(Eigen::AngleAxisd(uniform(0.087), Vector3d::UnitX()));
  change.rotate(Eigen::AngleAxisd(uniform(0.087), Vector3d::UnitY()));
  change.translate(-at);
  return change * truth;
}

// Starts all around for two sherds whose alignment is not known: centre on centre, turned.
std::vector<Isometry3d> allAround(const PointCloud& front, const PointCloud& back) {
  const auto mean = [](const PointCloud& cloud) {
    Vector3d sum = Vector3d::Zero();
    for (const auto& p : cloud.points) sum += p.cast<double>();
    return Vector3d(sum / static_cast<double>(cloud.size()));
  };
  const Vector3d f = mean(front), b = mean(back);
  std::vector<Isometry3d> starts;
  for (int k = 0; k < 72; ++k) {
    Isometry3d start = Isometry3d::Identity();
    start.translate(f - Vector3d(0, 0, 4));
    start.rotate(Eigen::AngleAxisd(k * M_PI / 36, Vector3d::UnitZ()));
    start.rotate(Eigen::AngleAxisd(M_PI, Vector3d::UnitX()));
    start.translate(-b);
    starts.push_back(start);
  }
  return starts;
}

// The back made smaller about its plate's origin; starts still lay its middle where it was.
void shrink(PointCloud& back, double size, std::vector<Isometry3d>& starts) {
  Vector3d centre = Vector3d::Zero();
  for (const auto& p : back.points) centre += p.cast<double>() / static_cast<double>(back.size());
  for (Isometry3d& start : starts)
    start.pretranslate(Vector3d(start.linear() * (centre - centre / size)));
  for (auto& p : back.points) p /= static_cast<float>(size);
}

// size: of the back, as shrink() had it.
void measure(const Pair& pair, const PointCloud& back, double size, Row& row) {
  double squares = 0, height = 0;
  for (const auto& p : back.points) {
    const Vector3d d = row.found.front_from_back * Vector3d(row.found.scale * p.cast<double>()) -
                       pair.truth * Vector3d(size * p.cast<double>());
    squares += d.squaredNorm();
    height += d.z() * d.z();
  }
  row.rms = std::sqrt(squares / static_cast<double>(back.size()));
  row.height = std::sqrt(height / static_cast<double>(back.size()));
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  const auto k = static_cast<std::size_t>(std::max(0.0, std::ceil(share * n) - 1));
  return values[std::min(k, values.size() - 1)];
}

void printRow(const std::string& set, const Pair& pair, const Row& row) {
  const auto& f = row.found;
  std::printf(
      "%-12s %s %s %s rms %.3f (height %.3f) fracture %.3f overlap %.2f LL %7.1f sigma %.3f gap "
      "%.1f at "
      "%.2f cross %.3f wall %.2f%s %.2f s %s\n",
      set.c_str(), pair.is_true ? "true " : "FALSE", pair.front.substr(6, 4).c_str(),
      pair.back.substr(5, 4).c_str(), row.rms, row.height, f.fracture_rms_mm, f.fracture_overlap,
      f.log_likelihood, f.uncertainty_mm, std::min(f.runner_up_gap, 999.0), f.runner_up_mm,
      f.crossing_share, f.thickness_mm, f.check_failed ? " SLIPPED" : "", row.seconds,
      f.reason.c_str());
}

void runSet(const Arguments& arguments, const std::string& set) {
  std::vector<Pair> pairs = readPairs(arguments.scans / set);
  const auto true_count = pairs.size();
  if (arguments.false_pairs)
    for (std::size_t i = 0; i < true_count; ++i)
      for (std::size_t j = 0; j < true_count; ++j)
        if (i != j && pairs[i].group >= 0 && pairs[i].group == pairs[j].group)
          pairs.push_back({pairs[i].front, pairs[j].back, pairs[i].truth, pairs[i].group, false});
  std::vector<double> rms, fracture_true, fracture_false, seconds, ratio;
  int check_failed = 0, bad_unflagged = 0, refused = 0;
  std::mt19937_64 random(1);
  const Views views = readViews(arguments.batch);
  const auto front_views = silhouettes(views, batch::Side::Front);
  const auto back_views = silhouettes(views, batch::Side::Back);
  const bool plates = set.rfind("flake", 0) != 0;
  for (const Pair& pair : pairs) {
    scan::Scan front, back;
    front.id = pair.front;
    back.id = pair.back;
    front.cloud = *readPlyCloud(arguments.scans / set / pair.front);
    back.cloud = *readPlyCloud(arguments.scans / set / pair.back);
    std::vector<Isometry3d> starts;
    if (pair.is_true)
      for (int k = 0; k < arguments.starts; ++k)
        starts.push_back(disturbed(pair.truth, back.cloud, random));
    else
      starts = allAround(front.cloud, back.cloud);
    registration::RegistrationOptions options;
    options.method = registration::methodsByName().at(arguments.method);
    options.free_scale = arguments.size != 1;
    if (options.free_scale) shrink(back.cloud, arguments.size, starts);
    options.strip.boundary = registration::boundariesByName().at(arguments.boundary);
    const double before = cpuSeconds();
    registration::Constraints constraints;
    constraints.front = front_views;
    constraints.back = back_views;
    if (plates) constraints.front_support = constraints.back_support = rig::SheetBend{};
    QuietProgress quiet;
    const auto front_strip = registration::prepareStrip(front, options.strip, front_views),
               back_strip = registration::prepareStrip(back, options.strip, back_views);
    const auto found = !front_strip ? Result<registration::Registration>(front_strip.error())
                       : !back_strip
                           ? back_strip.error()
                           : registration::registerSides(*front_strip, *back_strip, starts,
                                                         constraints, options, quiet, {});
    Row row;
    row.seconds = cpuSeconds() - before;
    if (!found) {
      ++refused;
      std::printf("%s %s: %s\n", set.c_str(), pair.front.c_str(),
                  found.error().sentence().english().c_str());
      continue;
    }
    row.found = *found;
    measure(pair, back.cloud, arguments.size, row);
    if (arguments.rows) printRow(set, pair, row);
    (pair.is_true ? fracture_true : fracture_false).push_back(row.found.fracture_rms_mm);
    if (!pair.is_true) continue;
    rms.push_back(row.rms);
    seconds.push_back(row.seconds);
    ratio.push_back(row.rms / row.found.uncertainty_mm);
    check_failed += row.found.check_failed;
    bad_unflagged += row.rms > 0.4 && !row.found.check_failed;
  }
  const auto share = std::count_if(rms.begin(), rms.end(), [](double r) { return r <= 0.1; });
  std::printf(
      "| %s | %zu | %.3f | %.3f | %.3f | %ld | %.3f | %.3f | %d | %d | %d | %.2f | %.2f | %.2f |\n",
      set.c_str(), rms.size(), percentile(rms, 0.5), percentile(rms, 0.95), percentile(rms, 1),
      static_cast<long>(share), percentile(fracture_true, 1), percentile(fracture_false, 0),
      check_failed, bad_unflagged, refused, percentile(ratio, 0.5), percentile(ratio, 0.95),
      percentile(seconds, 0.5));
  std::fflush(stdout);
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t at = 0;
  while (at <= text.size()) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    parts.push_back(text.substr(at, comma - at));
    at = comma + 1;
  }
  return parts;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  if (argc < 2) {
    std::fprintf(stderr,
                 "usage: %s SCANS [--sets A,B] [--method M] [--boundary B] [--size S] [--starts N] "
                 "[--false] [--rows]\n",
                 argv[0]);
    return 2;
  }
  arguments.scans = argv[1];
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--false") arguments.false_pairs = true;
    if (word == "--rows") arguments.rows = true;
    if (word == "--batch" && i + 1 < argc) arguments.batch = argv[++i];
    if (word == "--sets" && i + 1 < argc) arguments.sets = split(argv[++i]);
    if (word == "--method" && i + 1 < argc) arguments.method = argv[++i];
    if (word == "--size" && i + 1 < argc) arguments.size = std::stod(argv[++i]);
    if (word == "--boundary" && i + 1 < argc) arguments.boundary = argv[++i];
    if (word == "--starts" && i + 1 < argc) arguments.starts = std::stoi(argv[++i]);
  }
  if (!registration::methodsByName().contains(arguments.method) ||
      !registration::boundariesByName().contains(arguments.boundary)) {
    std::fprintf(stderr, "%s, %s: no such method or boundary\n", arguments.method.c_str(),
                 arguments.boundary.c_str());
    return 2;
  }
  std::printf(
      "| set | pairs | rms median | 95 %% | worst | <= 0.10 | fracture true max | fracture false "
      "min | "
      "check_failed "
      "| > 0.40 unflagged | no pose | rms/sigma median | 95 %% | CPU s |\n");
  for (const auto& set : arguments.sets) runSet(arguments, set);
  return 0;
}
