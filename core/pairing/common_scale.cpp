#include "pairing/common_scale.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/median.h"
#include "base/message.h"
#include "pairing/assignment.h"

namespace ostraka::pairing {
namespace {

/// Root mean square distance of the points from their mean, in the scan's unit.
double radiusOf(const scan::Scan& scan) {
  if (scan.cloud.empty()) return 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : scan.cloud.points) mean += p.cast<double>();
  mean /= static_cast<double>(scan.cloud.size());
  double sum = 0;
  for (const Eigen::Vector3f& p : scan.cloud.points) sum += (p.cast<double>() - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(scan.cloud.size()));
}

/// What brings a side to the size of sherds in millimetres, for which the outlines' tolerances
/// hold.
double toUsualSize(std::span<const scan::Scan> scans) {
  constexpr double kUsualRadius = 18;  // mm, of a sherd of 45 mm
  std::vector<double> radii;
  for (const scan::Scan& scan : scans) radii.push_back(radiusOf(scan));
  const double median = medianOf(radii);
  return median > 0 ? kUsualRadius / median : 1;
}

}  // namespace

scan::Scan scaled(const scan::Scan& scan, double factor) {
  scan::Scan out = scan;
  for (Eigen::Vector3f& p : out.cloud.points) p *= static_cast<float>(factor);
  return out;
}

std::vector<scan::Scan> scaled(std::span<const scan::Scan> scans, double factor) {
  std::vector<scan::Scan> out;
  for (const scan::Scan& scan : scans) out.push_back(scaled(scan, factor));
  return out;
}

Result<double> commonScale(std::span<const scan::Scan> fronts, std::span<const scan::Scan> backs,
                           const CandidateOptions& options, Progress& progress,
                           std::stop_token stop) {
  constexpr double kLikely = 5;    // logarithm of odds of 150, for pairs that confirm each other
  constexpr double kCertain = 20;  // for a pair alone: with size free, non-matches can reach 10
  if (fronts.empty() || backs.empty()) return 1.0;
  const double front_factor = toUsualSize(fronts), back_factor = toUsualSize(backs);
  CandidateOptions free = options;
  free.scale = Scale::Free;
  free.method = Method::Default;
  const Result<std::vector<PairCandidate>> candidates = findCandidates(
      scaled(fronts, front_factor), scaled(backs, back_factor), free, progress, stop);
  if (!candidates) return candidates.error();
  std::vector<Evidence> evidence;
  for (const PairCandidate& candidate : *candidates) {
    Evidence e;
    e.front = candidate.front, e.back = candidate.back;
    e.log_likelihood = candidate.log_likelihood;
    evidence.push_back(e);
  }
  const Result<Assignment> assignment =
      assignPairs(evidence, static_cast<int>(fronts.size()), static_cast<int>(backs.size()), {});
  if (!assignment) return assignment.error();
  std::vector<double> scales;
  double best = -1e9;
  for (const Decision& decision : assignment->pairs) {
    for (const PairCandidate& c : *candidates) {
      const bool own = c.front == decision.front && c.back == decision.back;
      if (!own || c.log_likelihood <= kLikely) continue;
      scales.push_back(c.starts[0].scale);
      best = std::max(best, c.log_likelihood);
    }
  }
  if (scales.size() == 1 && best < kCertain) scales.clear();
  if (scales.empty()) {
    return Error::notEnough(
        message("No two outlines match, so the sizes of the two sides cannot be compared; provide "
                "a known length."));
  }
  return medianOf(scales) * back_factor / front_factor;
}

}  // namespace ostraka::pairing
