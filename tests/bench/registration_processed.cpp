// How well the pairs of finished `ostraka process` results are registered, and whether the stated
// uncertainty holds: each true pair from the starts that the outlines gave, with the result's own
// scans, cameras and masks.
//   registration_processed [--constraints] OUT TRUTH [OUT TRUTH ...]
// TRUTH: the batch's truth folder. --constraints: also what each constraint says at the true pose:
// its chi-square per degree of freedom (1: honest) and how far off it would pull alone.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "cloud/ply.h"
#include "decisions/candidate_table.h"
#include "files/json.h"
#include "pipeline/chain.h"
#include "registration/break_misfit.h"
#include "registration/contact.h"
#include "registration/fracture_colour.h"
#include "registration/fracture_icp.h"
#include "registration/outline.h"
#include "registration/register_sides.h"
#include "registration/silhouettes.h"

namespace {

using namespace ostraka;
using Eigen::Isometry3d;
using Eigen::Vector3d;
namespace fs = std::filesystem;
namespace reg = registration;

struct Sherd {
  Isometry3d front, back;  // plate_from_model
};

std::vector<Sherd> readTruth(const fs::path& truth) {
  std::vector<Sherd> sherds;
  const auto json = readJson(truth / "sherds.json");
  if (!json) return sherds;
  for (const auto& s : (*json)["sherds"])
    sherds.push_back({*isometryFromJson(s["plate_from_model_front"], "sherds.json"),
                      *isometryFromJson(s["plate_from_model_back"], "sherds.json")});
  return sherds;
}

Vector3d meanOf(const PointCloud& cloud) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& p : cloud.points) sum += p.cast<double>();
  return sum / static_cast<double>(cloud.size());
}

std::size_t nearestSherd(const std::vector<Sherd>& sherds, const Vector3d& p, bool front) {
  std::size_t best = 0;
  double least = 1e9;
  for (std::size_t i = 0; i < sherds.size(); ++i) {
    const Vector3d at = (front ? sherds[i].front : sherds[i].back).translation();
    const double d = (at - p).head<2>().norm();
    if (d < least) least = d, best = i;
  }
  return best;
}

struct Ratios {
  std::vector<double> error, over_stated;
  int flagged = 0, silent = 0;
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto k = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  return values[k];
}

// The start's own spread keeps directions that a constraint says nothing of from counting.
void printConstraint(const char* name, const reg::Evidence& e, double radius) {
  reg::Matrix6 prior = reg::Matrix6::Zero();
  for (int k = 0; k < 3; ++k) prior(k, k) = radius * radius, prior(k + 3, k + 3) = 1;
  const reg::Matrix6 all = e.information + prior;  // 1 mm
  const reg::Matrix6 cov = all.inverse();
  const double chi = e.gradient.dot(cov * e.gradient);
  const double dof = (cov * e.information).trace();
  const reg::Vector6 x = -cov * e.gradient;
  const reg::Vector6 s = cov.diagonal().cwiseSqrt();
  std::printf(
      "      %-11s chi2/dof %6.2f (dof %.1f)  x/y %+.3f %+.3f z %+.3f  tilt mm %+.3f %+.3f "
      "turn %+.3f | sd %.3f %.3f %.3f  %.3f %.3f %.3f\n",
      name, chi / std::max(0.01, dof), dof, x[3], x[4], x[5], x[0] * radius, x[1] * radius,
      x[2] * radius, s[3], s[4], s[5], s[0] * radius, s[1] * radius, s[2] * radius);
}

void printConstraints(const Isometry3d& truth, const reg::Constraints& w, const reg::Strip& front,
                      const reg::Strip& back) {
  const Vector3d pivot = 0.5 * (front.centre + truth * back.centre);
  const double radius = 0.5 * (front.radius_mm + back.radius_mm);
  const double spacing = std::max(front.spacing_mm, back.spacing_mm);
  const reg::BreakMisfit misfit = reg::breakMisfit(front, back, truth);
  reg::FracturePairing pairing;
  const double noise = std::max(front.noise_mm, back.noise_mm);
  pairing.radius_mm = std::max({0.35, 4.0 * noise, 0.9 * spacing});
  pairing.robust_mm = pairing.radius_mm;
  reg::FractureFit fracture =
      reg::fitFracture(front.fine, back.fine, front.up, truth, pivot, radius, pairing);
  pairing.sigma_mm = std::clamp(fracture.sigma_mm, 0.02, 0.3);
  pairing.robust_mm = std::max(0.12, std::min(pairing.radius_mm, 3 * pairing.sigma_mm));
  pairing.correlated =
      2 * std::max({1.0, std::pow(0.9 / std::max(spacing, 0.05), 2), misfit.alike});
  pairing.bias_mm = std::clamp(0.015 * std::pow(pairing.sigma_mm / 0.1, 6), 0.004, 0.5);
  fracture = reg::fitFracture(front.fine, back.fine, front.up, truth, pivot, radius, pairing);
  std::printf(
      "      noise %.3f %.3f spacing %.3f strip sigma %.3f pairs %d alike %.1f overlap %.2f "
      "radius %.1f points %zu %zu\n",
      front.noise_mm, back.noise_mm, spacing, fracture.sigma_mm, fracture.pairs, misfit.alike,
      fracture.overlap, radius, front.fine.points.size(), back.fine.points.size());
  printConstraint("strip", fracture.evidence, radius);
  const auto colours = reg::fitColours(front.fine, back.fine, truth, pivot, {});
  std::printf("      colours %d pairs, correlation %.2f %.2f %.2f\n", colours.pairs,
              colours.correlation[0], colours.correlation[1], colours.correlation[2]);
  printConstraint("colours", colours.evidence, radius);
  const auto outline = reg::fitOutlines(front.all, back.all, spacing, truth,
                                        (front.up - truth.linear() * back.up).normalized(), pivot);
  printConstraint("outline", outline.evidence, radius);
  for (const bool on_front : {true, false}) {
    reg::ContactOptions contact;
    contact.grain_mm = spacing;
    if (!w.front.empty()) {
      const auto& camera = w.front[0].camera;
      const double depth = (camera.camera_from_plate * front.centre).z();
      contact.grain_mm = std::max(spacing, depth / camera.intrinsics.fx);
    }
    const rig::Support& support = on_front ? w.front_support : w.back_support;
    if (!support) continue;
    const auto rest =
        reg::contactEvidence(front, back, truth, pivot, on_front ? support : std::nullopt,
                             on_front ? std::nullopt : support, 0, contact);
    printConstraint(on_front ? "rest front" : "rest back", rest, radius);
    const Isometry3d pose = on_front ? truth : truth.inverse();
    const reg::Strip& side = on_front ? back : front;
    const Vector3d centre = 0.5 * ((on_front ? front : back).centre + pose * side.centre);
    const reg::Contact c = reg::restingFacet(side, pose, centre, *support);
    std::printf("        ");
    for (int i : c.points) {
      if (i < 0) continue;
      const Vector3d p = pose * side.shell[i].cast<double>();
      std::printf(" z %+.3f%s", p.z() - support->at(p.x(), p.y()),
                  side.shell_inside[i] ? " face" : " edge");
    }
    std::printf("\n");
  }
  if (!w.front.empty()) {
    const reg::SilhouetteConstraint s(front, back, w.front, w.back, truth, 1);
    const auto fit = s.evidence(truth, pivot, 3);
    std::printf("      silhouettes sigma %.2f px, %d\n", fit.sigma_mm, fit.pairs);
    printConstraint("silhouettes", fit.evidence, radius);
  }
}

void runResult(const fs::path& out, const fs::path& truth, bool explain, Ratios& ratios) {
  const auto cameras = rig::readCameras(out / "work" / "rig" / "cameras.json");
  const auto table = decisions::readCandidates(out / "work" / "pairs" / "candidates.json");
  const std::vector<Sherd> sherds = readTruth(truth);
  if (!cameras || !table || sherds.empty()) {
    std::fprintf(stderr, "%s is no finished result, or its truth is not there.\n", out.c_str());
    return;
  }
  std::vector<reg::SilhouetteView> front_views, back_views;
  for (const rig::PosedImage& camera : *cameras) {
    const bool of_front = camera.side == batch::Side::Front;
    const fs::path masks = out / "work" / (of_front ? "masks_front" : "masks_back");
    const cv::Mat1b mask =
        cv::imread((masks / rig::maskName(camera)).string(), cv::IMREAD_GRAYSCALE);
    (of_front ? front_views : back_views).push_back({camera, mask});
  }
  const reg::Constraints constraints{front_views, back_views, table->supports[0],
                                     table->supports[1]};
  for (const decisions::RegisteredCandidate& c : table->candidates) {
    scan::Scan front, back;
    front.cloud = *readPlyCloud(out / "work" /
                                table->front_files[static_cast<std::size_t>(c.evidence.front)]);
    back.cloud =
        *readPlyCloud(out / "work" / table->back_files[static_cast<std::size_t>(c.evidence.back)]);
    const std::size_t f = nearestSherd(sherds, meanOf(front.cloud), true);
    if (f != nearestSherd(sherds, meanOf(back.cloud), false)) continue;
    const Isometry3d t = sherds[f].front * sherds[f].back.inverse();
    std::vector<Isometry3d> starts;
    for (const auto& s : c.starts) starts.push_back(s.front_from_back);
    const auto front_strip = reg::prepareStrip(front, {});
    const auto back_strip = reg::prepareStrip(back, {});
    if (!front_strip || !back_strip) continue;
    QuietProgress quiet;
    const auto found =
        reg::registerSides(*front_strip, *back_strip, starts, constraints, {}, quiet, {});
    if (!found) continue;
    double squares = 0;
    for (const auto& p : back.cloud.points)
      squares += (found->front_from_back * p.cast<double>() - t * p.cast<double>()).squaredNorm();
    const double rms = std::sqrt(squares / static_cast<double>(back.cloud.size()));
    const Vector3d at = back_strip->centre;
    const Vector3d shift = found->front_from_back * at - t * at;
    const Eigen::AngleAxisd turn(
        Eigen::Matrix3d(found->front_from_back.linear() * t.linear().transpose()));
    const Vector3d tilt = 1e3 * turn.angle() * turn.axis();
    std::printf(
        "%-32s %s %s sherd %zu rms %.3f stated %.3f ratio %.2f | shift %+.3f %+.3f %+.3f "
        "tilt mrad %+.1f %+.1f %+.1f | fracture %.3f overlap %.2f misfit %.3f %s\n",
        out.parent_path().filename().c_str(),
        table->fronts[static_cast<std::size_t>(c.evidence.front)].id.c_str(),
        table->backs[static_cast<std::size_t>(c.evidence.back)].id.c_str(), f, rms,
        found->uncertainty_mm, rms / found->uncertainty_mm, shift.x(), shift.y(), shift.z(),
        tilt.x(), tilt.y(), tilt.z(), found->fracture_rms_mm, found->fracture_overlap,
        found->misfit_mm, found->reason.c_str());
    if (explain) printConstraints(t, constraints, *front_strip, *back_strip);
    std::fflush(stdout);
    ratios.error.push_back(rms);
    ratios.over_stated.push_back(rms / found->uncertainty_mm);
    ratios.flagged += found->check_failed;
    ratios.silent += rms > 0.4 && !found->check_failed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  bool explain = false;
  std::vector<fs::path> paths;
  for (int i = 1; i < argc; ++i)
    if (std::strcmp(argv[i], "--constraints") == 0)
      explain = true;
    else
      paths.emplace_back(argv[i]);
  if (paths.size() < 2 || paths.size() % 2 != 0)
    return std::fprintf(stderr, "usage: %s [--constraints] OUT TRUTH [OUT TRUTH ...]\n", argv[0]),
           2;
  Ratios ratios;
  for (std::size_t i = 0; i + 1 < paths.size(); i += 2)
    runResult(paths[i], paths[i + 1], explain, ratios);
  std::printf(
      "%zu pairs: error median %.3f 90 %% %.3f largest %.3f; error / stated median %.2f 90 %% "
      "%.2f largest %.2f; %d flagged, %d over 0.40 mm and not flagged\n",
      ratios.error.size(), quantile(ratios.error, 0.5), quantile(ratios.error, 0.9),
      quantile(ratios.error, 1), quantile(ratios.over_stated, 0.5),
      quantile(ratios.over_stated, 0.9), quantile(ratios.over_stated, 1), ratios.flagged,
      ratios.silent);
  return 0;
}
