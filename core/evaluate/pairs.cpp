#include "evaluate/pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "cloud/nearest.h"

namespace ostraka::evaluate {
namespace {

constexpr double kGoodRms_mm = 0.10;      // metrics.md, 'share <= 0.10 mm'
constexpr float kSeenFromBoth_mm = 0.6f;  // metrics.md, 'slipped'
constexpr std::size_t kFewStripPoints = 50;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

// The smallest value that reaches this share of the sorted values.
double reaching(const std::vector<double>& sorted, double percent) {
  const double rank = std::ceil(percent / 100 * static_cast<double>(sorted.size()));
  const auto index = static_cast<std::size_t>(std::max(1.0, rank)) - 1;
  return sorted[std::min(index, sorted.size() - 1)];
}

std::optional<double> acrossShare(const std::vector<Eigen::Vector3d>& true_places,
                                  const std::vector<Eigen::Vector3d>& errors,
                                  const PointCloud& front) {
  if (!front.hasNormals()) return {};
  const KdTree tree(front.points);
  double across = 0, whole = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < true_places.size(); ++i) {
    const Neighbour near = tree.nearest(true_places[i].cast<float>(), kSeenFromBoth_mm);
    if (near.index < 0) continue;
    ++count;
    const double along = errors[i].dot(front.normals[near.index].cast<double>());
    across += along * along;
    whole += errors[i].squaredNorm();
  }
  if (count <= kFewStripPoints) return {};
  const auto n = static_cast<double>(count);
  return std::sqrt(across / n / std::max(1e-30, whole / n));
}

struct Names {
  std::map<std::string, const TruePair*> of_front;
  std::set<std::string> fronts, backs, lone_fronts, lone_backs;
};

Names namesOf(const PairsTruth& truth) {
  Names names;
  for (const TruePair& pair : truth.pairs) {
    names.of_front[pair.front] = &pair;
    names.fronts.insert(pair.front);
    names.backs.insert(pair.back);
  }
  names.lone_fronts.insert(truth.unpaired_front.begin(), truth.unpaired_front.end());
  names.lone_backs.insert(truth.unpaired_back.begin(), truth.unpaired_back.end());
  return names;
}

Result<PairVerdict> judge(const ProposedPair& pair, const Names& names,
                          const ScanReader& read_scan) {
  PairVerdict verdict;
  verdict.pair = pair;
  const auto found = names.of_front.find(pair.front);
  const TruePair* truth = found == names.of_front.end() ? nullptr : found->second;
  verdict.right = truth && truth->back == pair.back;
  verdict.silent_error = !verdict.right && !pair.ambiguous;
  if (!verdict.right) {
    verdict.truth_among_alternatives =
        truth &&
        std::count(pair.alternative_backs.begin(), pair.alternative_backs.end(), truth->back);
    return verdict;
  }
  if (pair.transform_not_rigid) verdict.transform = TransformState::NotRigid;
  if (!pair.has_transform) return verdict;
  const Result<PointCloud> front = read_scan(truth->front_file);
  if (!front) return front.error();
  const Result<PointCloud> back = read_scan(truth->back_file);
  if (!back) return back.error();
  verdict.transform = TransformState::Measured;
  verdict.error = registrationError(pair.front_from_back, truth->front_from_back, *back, *front);
  return verdict;
}

void addForgotten(const std::set<std::string>& paired_or_named,
                  const std::set<std::string>& true_names, const std::set<std::string>& lone,
                  std::vector<std::string>& forgotten) {
  std::set<std::string> all = true_names;
  all.insert(lone.begin(), lone.end());
  for (const std::string& name : all)
    if (!paired_or_named.contains(name)) forgotten.push_back(name);
}

}  // namespace

RegistrationError registrationError(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth,
                                    const PointCloud& back, const PointCloud& front) {
  RegistrationError error;
  if (back.empty()) return error;
  std::vector<Eigen::Vector3d> places, errors;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squared = 0;
  for (const Eigen::Vector3f& point : back.points) {
    const Eigen::Vector3d p = point.cast<double>();
    places.push_back(truth * p);
    errors.push_back(found * p - places.back());
    sum += errors.back();
    squared += errors.back().squaredNorm();
  }
  const auto n = static_cast<double>(back.size());
  error.rms_mm = std::sqrt(squared / n);
  error.shift_mm = (sum / n).norm();
  const double trace = (truth.inverse() * found).linear().trace();
  error.rotation_deg = std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
  error.across_share = acrossShare(places, errors, front);
  error.slipped = error.rms_mm > kGoodRms_mm && error.across_share && *error.across_share < 0.5;
  return error;
}

Result<PairsEvaluation> evaluatePairs(const Proposal& proposal, const PairsTruth& truth,
                                      const ScanReader& read_scan) {
  const Names names = namesOf(truth);
  PairsEvaluation evaluation;
  evaluation.set = truth.set;
  evaluation.unseen = truth.unseen_pairs;
  evaluation.true_pairs = static_cast<int>(truth.pairs.size()) + truth.unseen_pairs;
  std::set<std::string> seen_fronts, seen_backs;
  for (const ProposedPair& pair : proposal.pairs) {
    const bool known =
        (names.fronts.contains(pair.front) || names.lone_fronts.contains(pair.front)) &&
        (names.backs.contains(pair.back) || names.lone_backs.contains(pair.back));
    if (!known)
      return Error::unusable("Scan " + pair.front + " or " + pair.back +
                                 " is not in the truth; is this the result of another batch?",
                             truth.set);
    const bool again = !seen_backs.insert(pair.back).second && !pair.ambiguous;
    if (!seen_fronts.insert(pair.front).second || again)  // who shares a back must say so
      return Error::unusable("Scan " + pair.front + " or " + pair.back + " occurs in two pairs.",
                             truth.set);
    Result<PairVerdict> verdict = judge(pair, names, read_scan);
    if (!verdict) return verdict.error();
    evaluation.verdicts.push_back(std::move(*verdict));
  }
  for (const TruePair& pair : truth.pairs)
    if (!seen_fronts.contains(pair.front) && !seen_backs.contains(pair.back))
      evaluation.missed.push_back(pair.front);
  const auto alone = [](const std::set<std::string>& lone, const std::set<std::string>& seen) {
    return static_cast<int>(std::count_if(
        lone.begin(), lone.end(), [&](const std::string& name) { return !seen.contains(name); }));
  };
  evaluation.lone = static_cast<int>(names.lone_fronts.size() + names.lone_backs.size());
  evaluation.lone_right =
      alone(names.lone_fronts, seen_fronts) + alone(names.lone_backs, seen_backs);
  seen_fronts.insert(proposal.unpaired_front.begin(), proposal.unpaired_front.end());
  seen_backs.insert(proposal.unpaired_back.begin(), proposal.unpaired_back.end());
  addForgotten(seen_fronts, names.fronts, names.lone_fronts, evaluation.forgotten);
  addForgotten(seen_backs, names.backs, names.lone_backs, evaluation.forgotten);
  return evaluation;
}

PairsSummary summarise(const std::vector<PairsEvaluation>& sets) {
  PairsSummary sum;
  std::vector<double> rms, rotations, shifts;
  for (const PairsEvaluation& set : sets) {
    sum.true_pairs += set.true_pairs;
    sum.missed += static_cast<int>(set.missed.size()) + set.unseen;
    sum.forgotten += static_cast<int>(set.forgotten.size());
    sum.lone += set.lone;
    sum.lone_right += set.lone_right;
    for (const PairVerdict& verdict : set.verdicts) {
      sum.right += verdict.right;
      sum.wrong += !verdict.right;
      sum.silent_errors += verdict.silent_error;
      sum.flagged += verdict.pair.ambiguous;
      sum.flagged_wrong += verdict.pair.ambiguous && !verdict.right;
      if (!verdict.right) continue;
      const bool measured = verdict.transform == TransformState::Measured;
      sum.not_registered += !measured;
      rms.push_back(measured ? verdict.error.rms_mm : std::numeric_limits<double>::infinity());
      if (!measured) continue;
      sum.slipped += verdict.error.slipped;
      rotations.push_back(verdict.error.rotation_deg);
      shifts.push_back(verdict.error.shift_mm);
    }
  }
  std::sort(rms.begin(), rms.end());
  const auto within = [&](double limit) {
    return 100.0 *
           static_cast<double>(std::upper_bound(rms.begin(), rms.end(), limit) - rms.begin());
  };
  const auto share = [](double hundredfold, double of) { return of > 0 ? hundredfold / of : 0; };
  sum.right_percent = share(100.0 * sum.right, sum.true_pairs);
  sum.rotation_median_deg = median(rotations);
  sum.shift_median_mm = median(shifts);
  if (rms.empty()) return sum;
  sum.rms_median_mm = reaching(rms, 50);
  sum.rms_p95_mm = reaching(rms, 95);
  sum.rms_max_mm = rms.back();
  sum.share_within_0_10_percent = share(within(kGoodRms_mm), static_cast<double>(rms.size()));
  sum.share_within_0_05_percent = share(within(0.05), static_cast<double>(rms.size()));
  sum.share_of_true_within_0_10_percent = share(within(kGoodRms_mm), sum.true_pairs);
  sum.goals_met = sum.right_percent >= 98 && sum.silent_errors == 0 &&
                  sum.share_of_true_within_0_10_percent >= 95 && sum.rms_median_mm <= 0.05;
  return sum;
}

}  // namespace ostraka::evaluate
