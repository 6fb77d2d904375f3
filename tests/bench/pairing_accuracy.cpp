// pairing_accuracy SCANS_DIR [--paper] [--pairs] SET...: ranks of the true partners, errors of the
// start poses, pairs right by the outlines alone. Reads the truth; nothing of it reaches the
// program.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "cloud/ply.h"
#include "files/json.h"
#include "pairing/assignment.h"
#include "pairing/candidates.h"
#include "scan/fracture.h"

namespace {

using ostraka::pairing::PairCandidate;

struct TruePair {
  int front = -1, back = -1;
  Eigen::Isometry3d front_from_back = Eigen::Isometry3d::Identity();
  bool symmetric = false;
};

std::vector<ostraka::scan::Scan> readScans(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.insert(entry.path());
  std::vector<ostraka::scan::Scan> scans;
  for (const std::filesystem::path& file : files) {
    auto cloud = ostraka::readPlyCloud(file);
    if (!cloud)
      std::fprintf(stderr, "%s\n", cloud.error().sentence().english().c_str()), std::exit(2);
    ostraka::scan::Scan scan;
    scan.id = file.stem().string();
    scan.cloud = std::move(*cloud);
    scans.push_back(std::move(scan));
  }
  return scans;
}

int indexOf(const std::vector<ostraka::scan::Scan>& scans, const std::string& name) {
  const std::string id = std::filesystem::path(name).stem().string();
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (scans[i].id == id) return static_cast<int>(i);
  }
  return -1;
}

struct StartError {
  double plane_mm = 0, turn_deg = 0, tilt_deg = 0, height_mm = 0;
  bool good() const { return plane_mm <= 1.5 && turn_deg <= 3; }
};

StartError errorOf(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth,
                   const ostraka::scan::Scan& front, const ostraka::scan::Scan& back) {
  const Eigen::Vector3d up = ostraka::scan::estimateUp(front.cloud);
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : back.cloud.points) centre += p.cast<double>();
  centre /= static_cast<double>(back.cloud.size());
  const Eigen::Vector3d shift = found * centre - truth * centre;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(found.rotation() * truth.rotation().transpose()));
  const Eigen::Vector3d vector = turn.angle() * turn.axis() * 180 / std::numbers::pi;
  StartError e;
  e.height_mm = shift.dot(up);
  e.plane_mm = (shift - up * shift.dot(up)).norm();
  e.turn_deg = std::abs(vector.dot(up));
  e.tilt_deg = (vector - up * vector.dot(up)).norm();
  return e;
}

struct Tally {
  int pairs = 0, first = 0, listed = 0, started = 0, started_first = 0, assigned = 0, proposed = 0;
  int flagged = 0, silent = 0, candidates = 0;
  double seconds = 0;
};

void judgeAssignment(const std::vector<PairCandidate>& candidates, ostraka::pairing::Method method,
                     const std::vector<TruePair>& truth, int fronts, int backs, Tally& tally) {
  std::vector<ostraka::pairing::Evidence> evidence;
  for (const PairCandidate& c : candidates) {
    ostraka::pairing::Evidence e;
    e.front = c.front, e.back = c.back, e.log_likelihood = c.log_likelihood;
    e.distance_rad = c.distance_rad;
    evidence.push_back(e);
  }
  const auto assignment = method == ostraka::pairing::Method::Paper
                              ? ostraka::pairing::nearestPairs(evidence, fronts, backs)
                              : ostraka::pairing::assignPairs(evidence, fronts, backs, {});
  if (!assignment)
    std::fprintf(stderr, "%s\n", assignment.error().sentence().english().c_str()), std::exit(1);
  for (const ostraka::pairing::Decision& d : assignment->pairs) {
    const bool right = std::any_of(truth.begin(), truth.end(), [&](const TruePair& t) {
      return t.front == d.front && t.back == d.back;
    });
    ++tally.proposed;
    tally.assigned += right;
    tally.flagged += d.ambiguous();
    tally.silent += !right && !d.ambiguous();
  }
}

Tally judgeSet(const std::filesystem::path& folder, ostraka::pairing::Method method,
               bool print_pairs) {
  const auto fronts = readScans(folder / "front"), backs = readScans(folder / "back");
  const auto truth_json = ostraka::readJson(folder / "truth.json");
  if (!truth_json)
    std::fprintf(stderr, "%s\n", truth_json.error().sentence().english().c_str()), std::exit(2);
  std::vector<TruePair> truth;
  for (const auto& p : (*truth_json)["pairs"]) {
    truth.push_back({indexOf(fronts, p["front"]), indexOf(backs, p["back"]),
                     *ostraka::isometryFromJson(p["T_front_from_back"], "truth"), p["symmetric"]});
  }
  ostraka::pairing::CandidateOptions options;
  options.method = method;
  options.threads = 1;
  ostraka::QuietProgress quiet;
  const auto begin = std::chrono::steady_clock::now();
  const auto candidates = ostraka::pairing::findCandidates(fronts, backs, options, quiet, {});
  Tally tally;
  tally.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!candidates)
    std::fprintf(stderr, "%s\n", candidates.error().sentence().english().c_str()), std::exit(1);
  tally.candidates = static_cast<int>(candidates->size());
  for (const TruePair& t : truth) {
    int better = 0;
    const PairCandidate* own = nullptr;
    double rival = -1e9, rival_rms = 0;
    for (const PairCandidate& c : *candidates) {
      if (c.front == t.front && c.back == t.back) own = &c;
    }
    for (const PairCandidate& c : *candidates) {
      if (c.front == t.front && c.back != t.back && own && c.log_likelihood > own->log_likelihood)
        ++better;
      if (c.front == t.front && c.back != t.back && c.log_likelihood > rival) {
        rival = c.log_likelihood, rival_rms = c.starts[0].contour_rms_mm;
      }
    }
    ++tally.pairs;
    tally.listed += own != nullptr;
    tally.first += own && better == 0;
    int good = -1;
    for (std::size_t i = 0; own && i < own->starts.size() && good < 0; ++i) {
      if (errorOf(own->starts[i].front_from_back, t.front_from_back,
                  fronts[static_cast<std::size_t>(t.front)],
                  backs[static_cast<std::size_t>(t.back)])
              .good()) {
        good = static_cast<int>(i);
      }
    }
    tally.started += good >= 0;
    tally.started_first += good == 0;
    if (!print_pairs || !own) continue;
    const StartError e = errorOf(
        own->starts[static_cast<std::size_t>(std::max(0, good))].front_from_back, t.front_from_back,
        fronts[static_cast<std::size_t>(t.front)], backs[static_cast<std::size_t>(t.back)]);
    std::printf(
        "  %s %s%s rank %d ll %.1f rms %.3f rival %.1f rms %.3f | start %d of %zu: plane %.2f mm "
        "turn %.2f tilt %.1f deg height %+.2f",
        fronts[static_cast<std::size_t>(t.front)].id.c_str(),
        backs[static_cast<std::size_t>(t.back)].id.c_str(), t.symmetric ? "*" : "", better + 1,
        own->log_likelihood, own->starts[0].contour_rms_mm, rival, rival_rms, good,
        own->starts.size(), e.plane_mm, e.turn_deg, e.tilt_deg, e.height_mm);
    for (const auto& s : own->starts) std::printf(" %.2f", s.contour_rms_mm);
    std::printf("\n");
  }
  judgeAssignment(*candidates, method, truth, static_cast<int>(fronts.size()),
                  static_cast<int>(backs.size()), tally);
  return tally;
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path scans = argc > 1 ? argv[1] : ".";
  ostraka::pairing::Method method = ostraka::pairing::Method::Default;
  bool print_pairs = false;
  Tally all;
  std::printf(
      "set pairs | listed first | true start listed, first | by outline: proposed right flagged "
      "silent | candidates s\n");
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--paper") method = ostraka::pairing::Method::Paper;
    if (word == "--pairs") print_pairs = true;
    if (word.starts_with("--")) continue;
    const Tally t = judgeSet(scans / word, method, print_pairs);
    std::printf("%-12s %3d | %3d %3d | %3d %3d | %3d %3d %3d %3d | %d %.2f\n", word.c_str(),
                t.pairs, t.listed, t.first, t.started, t.started_first, t.proposed, t.assigned,
                t.flagged, t.silent, t.candidates, t.seconds);
    all.pairs += t.pairs, all.first += t.first, all.listed += t.listed, all.started += t.started;
    all.started_first += t.started_first, all.assigned += t.assigned, all.proposed += t.proposed;
    all.flagged += t.flagged, all.silent += t.silent, all.candidates += t.candidates,
        all.seconds += t.seconds;
  }
  std::printf("%-12s %3d | %3d %3d | %3d %3d | %3d %3d %3d %3d | %d %.2f\n", "all", all.pairs,
              all.listed, all.first, all.started, all.started_first, all.proposed, all.assigned,
              all.flagged, all.silent, all.candidates, all.seconds);
}
