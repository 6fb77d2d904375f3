#include "pairing/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "base/median.h"
#include "base/message.h"
#include "base/parallel.h"
#include "batch/batch.h"
#include "pairing/assignment.h"
#include "pairing/planar_alignment.h"
#include "pairing/turning_angles.h"
#include "scan/fracture.h"

namespace ostraka::pairing {
namespace {

/// One scan's outline with all that comparing needs; the back's is mirrored.
struct Outline {
  Contour contour;
  std::optional<OutlineField> field;
  std::vector<double> heights;  ///< as field->line()
  std::vector<double> angles;   ///< 200 turning angles
};

constexpr int kAngleSamples = 200;  // the paper's number

Result<Outline> outlineOf(const scan::Scan& scan, batch::Side side) {
  Result<Contour> contour = traceContour(scan.cloud, scan::estimateUp(scan.cloud));
  if (!contour) return contour.error();
  Outline outline{std::move(*contour), std::nullopt, {}, {}};
  std::vector<Eigen::Vector2d> line = outline.contour.points;
  outline.heights = outline.contour.heights;
  if (side == batch::Side::Back) {
    line = mirrored(line);
    std::reverse(outline.heights.begin(), outline.heights.end());
  }
  Result<std::vector<double>> angles = turningAngles(line, kAngleSamples);
  if (!angles) return angles.error();
  outline.angles = std::move(*angles);
  outline.field.emplace(std::move(line));
  return outline;
}

/// Logarithm of the ratio of likelihoods of the distances between two aligned outlines.
///
/// One sherd: half-normal of a sigma that all of the pair's distances share and that is not known
/// (0.05 mm for clean scans, 0.4 mm for another program's ragged strips), averaged over its range;
/// kMissing of the outline lies anywhere within a few millimetres (hidden strip).
/// Two sherds at random after their best alignment: heavy tails in proportion to the size.
/// Neighbouring distances tell the same thing: one independent figure per kCorrelation.
double outlineLogLikelihood(const PlanarFit& fit, double perimeter_mm) {
  constexpr std::array<double, 8> kSigmas = {0.05, 0.07, 0.10, 0.14, 0.20, 0.28, 0.40, 0.56};  // mm
  constexpr double kMissing = 0.08, kHidden = 2.0;  // share of hidden strip, its usual depth in mm
  constexpr double kOther = 0.015;  // of the perimeter: half of a non-match's distances exceed it
  constexpr double kCorrelation = 6.0;  // mm, about a wall's thickness
  constexpr double kPi = std::numbers::pi;
  constexpr double kLeast = 1e-300;  // metres apart (a wrong unit) both terms below would vanish
  const double other = kOther * perimeter_mm;
  const double independent =
      perimeter_mm / kCorrelation / static_cast<double>(fit.distances_mm.size());
  std::array<double, kSigmas.size()> sums{};
  for (const double d : fit.distances_mm) {
    const double random = 2 / (kPi * other * (1 + d * d / (other * other)));
    const double hidden = kMissing / kHidden * std::exp(-d / kHidden);
    for (std::size_t k = 0; k < kSigmas.size(); ++k) {
      const double u = d / kSigmas[k];
      const double same = (1 - kMissing) * std::sqrt(2 / kPi) / kSigmas[k] * std::exp(-0.5 * u * u);
      sums[k] += independent * std::log(std::max(same + hidden, kLeast) / random);
    }
  }
  const double best = *std::max_element(sums.begin(), sums.end());
  double total = 0;
  for (const double sum : sums) total += std::exp(sum - best) / kSigmas.size();
  return best + std::log(total);
}

/// Rigid least squares of the samples matched one to one at a start point (Kabsch in the plane).
PlanarPose poseOfShift(const Outline& front, const Outline& back, int shift, double scale) {
  const std::vector<Eigen::Vector2d> f = resampled(front.field->line(), kAngleSamples);
  const std::vector<Eigen::Vector2d> b = resampled(back.field->line(), kAngleSamples);
  Eigen::Vector2d mean_f = Eigen::Vector2d::Zero(), mean_b = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : f) mean_f += p / kAngleSamples;
  for (const Eigen::Vector2d& p : b) mean_b += p / kAngleSamples;
  double along = 0, across = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const Eigen::Vector2d p = f[i] - mean_f;
    const Eigen::Vector2d q = b[(i + static_cast<std::size_t>(shift)) % b.size()] - mean_b;
    along += q.dot(p);
    across += q.x() * p.y() - q.y() * p.x();
  }
  PlanarPose pose;
  pose.angle_rad = std::atan2(across, along);
  pose.scale = scale;
  pose.shift = mean_f - pose.apply(mean_b);
  return pose;
}

/// Nothing is moved: the pose as it is, judged.
PlanarFit asItStands(const Outline& front, const Outline& back, const PlanarPose& pose) {
  PlanarAlignOptions none;
  none.rounds = 0;
  return alignOutlines(*front.field, *back.field, pose, none);
}

/// The start points whose turning angles fit better than their neighbours', best first.
std::vector<int> bestShifts(const std::vector<double>& costs, int max_count) {
  const int n = static_cast<int>(costs.size());
  const auto at = [&](int i) { return costs[static_cast<std::size_t>((i + n) % n)]; };
  std::vector<int> valleys;
  for (int i = 0; i < n; ++i) {
    if (at(i) <= at(i - 1) && at(i) < at(i + 1)) valleys.push_back(i);
  }
  std::stable_sort(valleys.begin(), valleys.end(), [&](int a, int b) { return at(a) < at(b); });
  if (valleys.size() > static_cast<std::size_t>(max_count))
    valleys.resize(static_cast<std::size_t>(max_count));
  return valleys;
}

/// Largest distance that a point of the back's outline lies apart under the two poses, mm.
double apart(const PlanarPose& a, const PlanarPose& b, const OutlineField& back) {
  double largest = 0;
  const std::vector<Eigen::Vector2d>& line = back.line();
  for (std::size_t i = 0; i < line.size(); i += std::max<std::size_t>(1, line.size() / 16)) {
    largest = std::max(largest, (a.apply(line[i]) - b.apply(line[i])).norm());
  }
  return largest;
}

StartPose startPose(const Outline& front, const Outline& back, const PlanarFit& fit) {
  StartPose start;
  start.contour_rms_mm = fit.rms_mm;
  start.scale = fit.pose.scale;
  const std::vector<Eigen::Vector2d>& line = back.field->line();
  std::vector<double> sums;
  for (std::size_t i = 0; i < line.size(); i += std::max<std::size_t>(1, line.size() / 200)) {
    const OutlineField::Foot foot = front.field->nearest(fit.pose.apply(line[i]));
    sums.push_back(front.heights[static_cast<std::size_t>(foot.index)] +
                   fit.pose.scale * back.heights[i]);
  }
  const double height = medianOf(sums);
  const Eigen::Vector2d origin = fit.pose.unapply(front.field->line()[0]);
  start.shift = back.field->nearest(origin).index * kAngleSamples / static_cast<int>(line.size());
  Eigen::Isometry3d planar = Eigen::Isometry3d::Identity();
  planar.linear() = (Eigen::AngleAxisd(fit.pose.angle_rad, Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitY()))
                        .toRotationMatrix();
  planar.translation() << fit.pose.shift, height;
  Eigen::Isometry3d plane_from_back = back.contour.plane_from_scan;
  plane_from_back.translation() *= fit.pose.scale;  // the pose acts on the back brought to size
  start.front_from_back = front.contour.plane_from_scan.inverse() * planar * plane_from_back;
  start.log_likelihood = outlineLogLikelihood(fit, front.field->perimeter());
  return start;
}

/// Distinct fits, best first: turns of centroid on centroid and start points of the turning angles
/// are aligned coarsely, the better half finely.
std::vector<PlanarFit> alignedFits(const Outline& front, const Outline& back,
                                   const CandidateOptions& options) {
  constexpr int kTurns = 16, kShifts = 6;  // a regular polygon has fewer; a disc's relief decides
  const bool free_scale = options.scale == Scale::Free;
  const double scale = free_scale ? std::sqrt(front.contour.area_mm2 / back.contour.area_mm2) : 1.0;
  std::vector<PlanarPose> poses = bestTurns(*front.field, *back.field, scale, kTurns);
  for (const int shift : bestShifts(shiftCosts(front.angles, back.angles, Offset::Free), kShifts)) {
    poses.push_back(poseOfShift(front, back, shift, scale));
  }
  PlanarAlignOptions coarse;
  coarse.scale = free_scale ? FreeScale::Yes : FreeScale::No;
  PlanarAlignOptions fine = coarse;
  coarse.rounds = 6, coarse.samples = 80, coarse.last_reach_mm = 1.0;
  fine.rounds = 8, fine.first_reach_mm = 1.0;
  const auto sortedDistinct = [&](std::vector<PlanarFit> fits, double min_apart_mm) {
    std::ranges::stable_sort(fits, {}, &PlanarFit::rms_mm);
    std::vector<PlanarFit> kept;
    for (PlanarFit& fit : fits) {
      const bool known = std::ranges::any_of(kept, [&](const PlanarFit& other) {
        return apart(fit.pose, other.pose, *back.field) < min_apart_mm;
      });
      if (!known) kept.push_back(std::move(fit));
    }
    return kept;
  };
  std::vector<PlanarFit> fits;
  for (const PlanarPose& pose : poses)
    fits.push_back(alignOutlines(*front.field, *back.field, pose, coarse));
  fits = sortedDistinct(std::move(fits), 0.5);
  const std::size_t most = static_cast<std::size_t>(options.max_starts) + 2;
  if (fits.size() > most) fits.resize(most);
  for (PlanarFit& fit : fits) fit = alignOutlines(*front.field, *back.field, fit.pose, fine);
  fits = sortedDistinct(std::move(fits), 1.0);
  if (fits.size() > static_cast<std::size_t>(options.max_starts)) {
    fits.resize(static_cast<std::size_t>(options.max_starts));
  }
  return fits;
}

PairCandidate defaultCandidate(const Outline& front, const Outline& back,
                               const CandidateOptions& options) {
  PairCandidate candidate;
  for (const PlanarFit& fit : alignedFits(front, back, options)) {
    candidate.starts.push_back(startPose(front, back, fit));
  }
  std::ranges::stable_sort(candidate.starts, std::greater(), &StartPose::log_likelihood);
  candidate.log_likelihood = candidate.starts.empty() ? -1e9 : candidate.starts[0].log_likelihood;
  return candidate;
}

// Wang et al., section 3.1: the least distance over all start points, and the pose of that one.
PairCandidate paperCandidate(const Outline& front, const Outline& back,
                             const CandidateOptions& options) {
  const std::vector<double> costs = shiftCosts(front.angles, back.angles, Offset::None);
  const auto least = std::min_element(costs.begin(), costs.end());
  const double scale = options.scale == Scale::Free
                           ? std::sqrt(front.contour.area_mm2 / back.contour.area_mm2)
                           : 1.0;
  const PlanarPose pose = poseOfShift(front, back, static_cast<int>(least - costs.begin()), scale);
  PairCandidate candidate;
  candidate.distance_rad = *least;
  candidate.starts.push_back(startPose(front, back, asItStands(front, back, pose)));
  candidate.starts.front().log_likelihood = 0;
  return candidate;
}

/// Of each front the back at the least distance; the first of equals.
std::vector<PairCandidate> rowMinima(std::vector<PairCandidate> by_front) {
  std::vector<PairCandidate> nearest;
  for (PairCandidate& candidate : by_front) {
    if (candidate.starts.empty()) continue;  // a scan without an outline
    if (nearest.empty() || nearest.back().front != candidate.front) {
      nearest.push_back(std::move(candidate));
    } else if (candidate.distance_rad < nearest.back().distance_rad) {
      nearest.back() = std::move(candidate);
    }
  }
  return nearest;
}

std::vector<std::optional<Outline>> outlinesOf(std::span<const scan::Scan> scans, batch::Side side,
                                               const CandidateOptions& options,
                                               Progress& progress) {
  std::vector<std::optional<Outline>> outlines(scans.size());
  std::vector<Message> notes(scans.size());
  parallelFor(scans.size(), options.threads, [&](std::size_t i) {
    Result<Outline> outline = outlineOf(scans[i], side);
    if (outline) {
      outlines[i] = std::move(*outline);
    } else {
      notes[i] = message("pairing: %1 stays unpaired: %2", scans[i].id, outline.error().sentence());
    }
  });
  for (const Message& text : notes) {
    if (!text.empty()) progress.note(NoteLevel::Warning, text);
  }
  return outlines;
}

/// Pairs that can still be part of the right assignment.
Result<std::vector<PairCandidate>> withinReach(std::vector<PairCandidate> all, int n_front,
                                               int n_back, double reach) {
  std::vector<Evidence> evidence;
  for (const PairCandidate& candidate : all) {
    Evidence e;
    e.front = candidate.front, e.back = candidate.back;
    e.log_likelihood = candidate.log_likelihood;
    evidence.push_back(e);
  }
  const Result<std::vector<double>> regret = regrets(evidence, n_front, n_back, 0);
  if (!regret) return regret.error();
  std::vector<PairCandidate> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].starts.empty() && (*regret)[i] <= reach) kept.push_back(std::move(all[i]));
  }
  return kept;
}

}  // namespace

Result<std::vector<PairCandidate>> findCandidates(std::span<const scan::Scan> fronts,
                                                  std::span<const scan::Scan> backs,
                                                  const CandidateOptions& options,
                                                  Progress& progress, std::stop_token stop) {
  const auto front = outlinesOf(fronts, batch::Side::Front, options, progress);
  const auto back = outlinesOf(backs, batch::Side::Back, options, progress);
  std::vector<PairCandidate> all(fronts.size() * backs.size());
  for (std::size_t f = 0; f < fronts.size(); ++f) {  // a row at a time, to answer a stop
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(static_cast<std::int64_t>(f), static_cast<std::int64_t>(fronts.size()));
    parallelFor(backs.size(), options.threads, [&](std::size_t b) {
      PairCandidate& candidate = all[f * backs.size() + b];
      if (front[f] && back[b]) {
        candidate = options.method == Method::Paper
                        ? paperCandidate(*front[f], *back[b], options)
                        : defaultCandidate(*front[f], *back[b], options);
      }
      candidate.front = static_cast<int>(f);
      candidate.back = static_cast<int>(b);
    });
  }
  progress.report(static_cast<std::int64_t>(fronts.size()),
                  static_cast<std::int64_t>(fronts.size()));
  if (options.method == Method::Paper) return rowMinima(std::move(all));
  return withinReach(std::move(all), static_cast<int>(fronts.size()),
                     static_cast<int>(backs.size()), options.reach);
}

Result<StartPose> startPoseAt(const scan::Scan& front, const scan::Scan& back, int shift) {
  const Result<Outline> f = outlineOf(front, batch::Side::Front);
  if (!f) return f.error();
  const Result<Outline> b = outlineOf(back, batch::Side::Back);
  if (!b) return b.error();
  const int around = (shift % kAngleSamples + kAngleSamples) % kAngleSamples;
  StartPose start = startPose(*f, *b, asItStands(*f, *b, poseOfShift(*f, *b, around, 1.0)));
  start.shift = around;
  return start;
}

}  // namespace ostraka::pairing
