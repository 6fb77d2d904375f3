#include "pairing/assignment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>

#include "base/message.h"

namespace ostraka::pairing {
namespace {

constexpr double kImpossible = 1e7;  // far above any sum of log-likelihoods, far below overflow

/// A square cost matrix, its cheapest assignment and the dual prices that prove it.
class Matching {
 public:
  explicit Matching(std::vector<std::vector<double>> costs) : costs_(std::move(costs)) { solve(); }

  int columnOf(std::size_t row) const { return column_of_[row]; }

  /// By how much the total grows when this row must take each column: one shortest path per
  /// column, all found by one search backwards from the column that the row gives up. O(n^2).
  std::vector<double> forcedIncrease(std::size_t row) const {
    const std::size_t n = costs_.size();
    std::vector<double> distance(n, std::numeric_limits<double>::max());  // row to freed column
    std::vector<std::uint8_t> done(n, 0);
    const std::size_t freed = static_cast<std::size_t>(column_of_[row]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r != row) distance[r] = reduced(r, freed);
    }
    done[row] = 1;
    for (std::size_t round = 1; round < n; ++round) {
      std::size_t nearest = n;
      for (std::size_t r = 0; r < n; ++r) {
        if (!done[r] && (nearest == n || distance[r] < distance[nearest])) nearest = r;
      }
      if (nearest == n) break;
      done[nearest] = 1;
      const std::size_t column = static_cast<std::size_t>(column_of_[nearest]);
      for (std::size_t r = 0; r < n; ++r) {
        if (!done[r]) distance[r] = std::min(distance[r], reduced(r, column) + distance[nearest]);
      }
    }
    std::vector<double> increase(n, 0);
    for (std::size_t c = 0; c < n; ++c) {
      if (c != freed)
        increase[c] = reduced(row, c) + distance[static_cast<std::size_t>(row_of_[c])];
    }
    return increase;
  }

 private:
  double reduced(std::size_t r, std::size_t c) const {
    return std::max(0.0, costs_[r][c] - row_price_[r] - column_price_[c]);
  }

  /// Jonker and Volgenant's form of the Hungarian method: one shortest augmenting path per row.
  void solve() {
    const std::size_t n = costs_.size(), none = n;
    row_price_.assign(n, 0);
    column_price_.assign(n + 1, 0);
    std::vector<std::size_t> row_of(n + 1, none);
    for (std::size_t row = 0; row < n; ++row) {
      std::vector<double> least(n, std::numeric_limits<double>::max());
      std::vector<std::size_t> from(n, none);
      std::vector<std::uint8_t> used(n + 1, 0);
      std::size_t column = n;
      row_of[n] = row;
      do {
        used[column] = 1;
        const std::size_t r = row_of[column];
        double delta = std::numeric_limits<double>::max();
        std::size_t next = none;
        for (std::size_t c = 0; c < n; ++c) {
          if (used[c]) continue;
          const double slack = costs_[r][c] - row_price_[r] - column_price_[c];
          if (slack < least[c]) least[c] = slack, from[c] = column;
          if (least[c] < delta) delta = least[c], next = c;
        }
        for (std::size_t c = 0; c <= n; ++c) {
          if (used[c]) {
            row_price_[row_of[c]] += delta, column_price_[c] -= delta;
          } else if (c < n) {
            least[c] -= delta;
          }
        }
        column = next;
      } while (row_of[column] != none);
      while (column != n) {
        const std::size_t before = from[column];
        row_of[column] = row_of[before];
        column = before;
      }
    }
    column_of_.assign(n, 0);
    row_of_.assign(n, 0);
    for (std::size_t c = 0; c < n; ++c) {
      row_of_[c] = static_cast<int>(row_of[c]);
      column_of_[row_of[c]] = static_cast<int>(c);
    }
  }

  std::vector<std::vector<double>> costs_;
  std::vector<double> row_price_, column_price_;
  std::vector<int> column_of_, row_of_;
};

/// Fronts and backs, each with a place of its own to stay alone in: rows fronts then stand-ins,
/// columns backs then stand-ins.
std::vector<std::vector<double>> costsOf(std::span<const Evidence> evidence, std::size_t n_front,
                                         std::size_t n_back, double lone) {
  const std::size_t n = n_front + n_back;
  std::vector<std::vector<double>> costs(n, std::vector<double>(n, 0));
  for (std::size_t f = 0; f < n_front; ++f) {
    std::fill_n(costs[f].begin(), n_back, kImpossible);
    // Each front stays alone in its own place only, so that the choice is one column.
    for (std::size_t k = 0; k < n_front; ++k) costs[f][n_back + k] = k == f ? 0 : kImpossible;
  }
  for (std::size_t b = 0; b < n_back; ++b) {
    for (std::size_t k = 0; k < n_back; ++k) costs[n_front + b][k] = k == b ? 0 : kImpossible;
  }
  for (const Evidence& e : evidence) {
    double& cost = costs[static_cast<std::size_t>(e.front)][static_cast<std::size_t>(e.back)];
    cost = std::min(cost, lone - e.log_likelihood);
  }
  return costs;
}

/// Probabilities of each front's choices: columns 0 .. n_back-1, last = alone; and of each back's.
struct Chances {
  std::vector<std::vector<double>> of_front;  ///< [front][back], [front][n_back] = alone
  std::vector<std::vector<double>> of_back;   ///< [back][front]
};

Chances chancesOf(const Matching& matching, std::size_t n_front, std::size_t n_back) {
  Chances chances;
  chances.of_front.assign(n_front, std::vector<double>(n_back + 1, 0));
  chances.of_back.assign(n_back, std::vector<double>(n_front, 0));
  std::vector<double> back_total(n_back, 0);
  for (std::size_t f = 0; f < n_front; ++f) {
    const std::vector<double> increase = matching.forcedIncrease(f);
    double total = 0;
    for (std::size_t b = 0; b <= n_back; ++b) {
      const double weight = std::exp(-increase[b < n_back ? b : n_back + f]);
      chances.of_front[f][b] = weight;
      total += weight;
      if (b < n_back) chances.of_back[b][f] = weight, back_total[b] += weight;
    }
    for (double& p : chances.of_front[f]) p /= total;
  }
  for (std::size_t b = 0; b < n_back; ++b) {
    const double total = back_total[b] + std::exp(-matching.forcedIncrease(n_front + b)[b]);
    for (double& p : chances.of_back[b]) p /= total;
  }
  return chances;
}

std::vector<Alternative> alternativesOf(const Chances& chances, int front, int back, int n_back,
                                        int max_count) {
  constexpr double kWorthNaming = 1e-3;
  std::vector<Alternative> found;
  const std::vector<double>& row = chances.of_front[static_cast<std::size_t>(front)];
  const std::vector<double>& column = chances.of_back[static_cast<std::size_t>(back)];
  for (int b = 0; b < n_back; ++b) {
    const double p = row[static_cast<std::size_t>(b)];
    if (b != back && p > kWorthNaming) found.push_back({front, b, p});
  }
  for (int f = 0; f < static_cast<int>(column.size()); ++f) {
    const double p = column[static_cast<std::size_t>(f)];
    if (f != front && p > kWorthNaming) found.push_back({f, back, p});
  }
  std::ranges::stable_sort(found, std::greater(), &Alternative::score);
  if (found.size() > static_cast<std::size_t>(max_count)) {
    found.resize(static_cast<std::size_t>(max_count));
  }
  return found;
}

// A sentence must fit the probability beside it: at 98 % nothing else fits nearly as well.
constexpr double kNearlyAsWell = 0.1;  // of the pair's own probability, from here on
constexpr double kBarelyBetter = 0.5;  // likewise

// Of a pair that is less certain than flag_below; alone: that neither side has a partner.
Doubt whyNotSure(double partner, double pose, double rival, double alone) {
  if (rival >= alone && rival >= kNearlyAsWell * partner) return Doubt::OtherPartner;
  if (alone >= kBarelyBetter * partner) return Doubt::Unrelated;
  if (1 - pose >= kNearlyAsWell * pose) return Doubt::OtherPose;
  return Doubt::NotSure;
}

Decision decide(const Evidence& e, const Chances& chances, int n_back,
                const AssignOptions& options) {
  Decision d;
  d.front = e.front;
  d.back = e.back;
  const double of_front =
      chances.of_front[static_cast<std::size_t>(e.front)][static_cast<std::size_t>(e.back)];
  const double of_back =
      chances.of_back[static_cast<std::size_t>(e.back)][static_cast<std::size_t>(e.front)];
  const double partner = std::min(of_front, of_back);
  const double other_pose =
      std::exp(std::min(0.0, e.runner_up_start_log_likelihood - e.log_likelihood));
  const double pose = 1 / (1 + other_pose);
  const double score = partner * pose;
  d.score = score;
  d.alternatives = alternativesOf(chances, e.front, e.back, n_back, options.max_alternatives);
  const double alone = 1 - partner;
  double rival =
      std::max(partner * (1 - pose), chances.of_front[static_cast<std::size_t>(e.front)].back());
  if (!d.alternatives.empty()) rival = std::max(rival, d.alternatives[0].score);
  d.margin = score - std::min(rival, std::max(alone, partner * (1 - pose)));
  if (e.check_failed) {
    d.doubt = Doubt::SelfCheck;
  } else if (score < options.flag_below) {
    const std::vector<double>& fronts_of = chances.of_back[static_cast<std::size_t>(e.back)];
    const double front_alone = chances.of_front[static_cast<std::size_t>(e.front)].back();
    const double back_alone = 1 - std::accumulate(fronts_of.begin(), fronts_of.end(), 0.0);
    d.doubt = whyNotSure(partner, pose, d.alternatives.empty() ? 0 : d.alternatives.front().score,
                         std::min(front_alone, back_alone));
  }
  return d;
}

// Of what the best assignment leaves alone, the likeliest first; each is for a person to decide.
std::vector<Decision> leftOver(std::span<const Evidence> evidence, const Chances& chances,
                               int n_back, const AssignOptions& options) {
  const double least =
      options.lone_log_likelihood + std::log(options.ask_from / (1 - options.ask_from));
  std::vector<const Evidence*> worth_asking;
  for (const Evidence& e : evidence)
    if (!e.check_failed && e.log_likelihood >= least) worth_asking.push_back(&e);
  std::ranges::stable_sort(worth_asking, [](const Evidence* a, const Evidence* b) {
    return a->log_likelihood > b->log_likelihood;
  });
  std::vector<Decision> proposed;
  for (const Evidence* e : worth_asking) proposed.push_back(decide(*e, chances, n_back, options));
  return proposed;
}

Result<void> checkEvidence(std::span<const Evidence> evidence, int n_front, int n_back) {
  for (const Evidence& e : evidence) {
    if (e.front < 0 || e.back < 0 || e.front >= n_front || e.back >= n_back ||
        !std::isfinite(e.log_likelihood)) {
      return Error::unusable(message("The evidence for a pair has no valid scans or value."));
    }
  }
  return {};
}

}  // namespace

double jointLogLikelihood(double outline, double fracture, int n_scans) {
  constexpr double kNearDuplicate =
      0.02;  // share of non-matches that have an outline nearly the same
  const double non_match = std::log(1 - kNearDuplicate) - outline;
  const double near_duplicate = std::log(kNearDuplicate) - fracture;
  const double most = std::max(non_match, near_duplicate);
  const double either =
      most + std::log(std::exp(non_match - most) + std::exp(near_duplicate - most));
  // A match against leaving both alone: (1/n) / (lone * lone).
  constexpr double kLone = 0.1;
  return -either - std::log(kLone * kLone * std::max(1, n_scans));
}

Result<Assignment> nearestPairs(std::span<const Evidence> evidence, int n_front, int n_back) {
  if (const Result<void> valid = checkEvidence(evidence, n_front, n_back); !valid) {
    return valid.error();
  }
  std::vector<int> fronts_of(static_cast<std::size_t>(std::max(0, n_back)), 0);
  std::vector<std::uint8_t> paired(static_cast<std::size_t>(std::max(0, n_front)), 0);
  for (const Evidence& e : evidence) {
    ++fronts_of[static_cast<std::size_t>(e.back)];
    paired[static_cast<std::size_t>(e.front)] = 1;
  }
  Assignment assignment;
  for (const Evidence& e : evidence) {
    Decision d;
    d.front = e.front, d.back = e.back;
    d.score = d.margin = std::nullopt;
    d.distance_rad = e.distance_rad;
    if (fronts_of[static_cast<std::size_t>(e.back)] > 1)
      d.doubt = Doubt::SharedBack;
    else if (e.check_failed)
      d.doubt = Doubt::SelfCheck;
    assignment.pairs.push_back(d);
  }
  for (int f = 0; f < n_front; ++f) {
    if (!paired[static_cast<std::size_t>(f)]) assignment.unpaired_front.push_back(f);
  }
  for (int b = 0; b < n_back; ++b) {
    if (fronts_of[static_cast<std::size_t>(b)] == 0) assignment.unpaired_back.push_back(b);
  }
  std::ranges::sort(assignment.pairs, {}, &Decision::front);
  return assignment;
}

Result<std::vector<double>> regrets(std::span<const Evidence> evidence, int n_front, int n_back,
                                    double lone_log_likelihood) {
  if (const Result<void> valid = checkEvidence(evidence, n_front, n_back); !valid) {
    return valid.error();
  }
  const std::size_t fronts = static_cast<std::size_t>(std::max(0, n_front));
  const std::size_t backs = static_cast<std::size_t>(std::max(0, n_back));
  const std::vector<std::vector<double>> costs =
      costsOf(evidence, fronts, backs, lone_log_likelihood);
  const Matching matching(costs);
  std::vector<std::vector<double>> increase;
  for (std::size_t f = 0; f < fronts; ++f) increase.push_back(matching.forcedIncrease(f));
  std::vector<double> found;
  for (const Evidence& e : evidence) {
    const std::size_t f = static_cast<std::size_t>(e.front), b = static_cast<std::size_t>(e.back);
    // A pair may be named twice; only the better of the two stands in the matrix.
    const double worse = lone_log_likelihood - e.log_likelihood - costs[f][b];
    found.push_back(increase[f][b] + std::max(0.0, worse));
  }
  return found;
}

Result<Assignment> assignPairs(std::span<const Evidence> evidence, int n_front, int n_back,
                               const AssignOptions& options) {
  if (const Result<void> valid = checkEvidence(evidence, n_front, n_back); !valid) {
    return valid.error();
  }
  const std::size_t fronts = static_cast<std::size_t>(std::max(0, n_front));
  const std::size_t backs = static_cast<std::size_t>(std::max(0, n_back));
  const Matching matching(costsOf(evidence, fronts, backs, options.lone_log_likelihood));
  const Chances chances = chancesOf(matching, fronts, backs);
  Assignment assignment;
  std::vector<std::uint8_t> taken(backs, 0);
  for (int f = 0; f < n_front; ++f) {
    const int b = matching.columnOf(static_cast<std::size_t>(f));
    const Evidence* best = nullptr;
    for (const Evidence& e : evidence) {
      const bool better = !best || e.log_likelihood > best->log_likelihood;
      if (e.front == f && e.back == b && better) best = &e;
    }
    if (!best) {
      assignment.unpaired_front.push_back(f);
      continue;
    }
    const Decision decision = decide(*best, chances, n_back, options);
    taken[static_cast<std::size_t>(b)] = 1;
    assignment.pairs.push_back(decision);
  }
  for (int b = 0; b < n_back; ++b) {
    if (!taken[static_cast<std::size_t>(b)]) assignment.unpaired_back.push_back(b);
  }
  for (const Decision& decision : leftOver(evidence, chances, n_back, options)) {
    std::vector<int>& lone_fronts = assignment.unpaired_front;
    std::vector<int>& lone_backs = assignment.unpaired_back;
    const auto front = std::find(lone_fronts.begin(), lone_fronts.end(), decision.front);
    const auto back = std::find(lone_backs.begin(), lone_backs.end(), decision.back);
    if (front == lone_fronts.end() || back == lone_backs.end()) continue;
    lone_fronts.erase(front);
    lone_backs.erase(back);
    assignment.pairs.push_back(decision);
  }
  std::ranges::sort(assignment.pairs, {}, &Decision::front);
  return assignment;
}

}  // namespace ostraka::pairing
