#include "decisions/decided_pairs.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "registration/pose_figures.h"

namespace ostraka::decisions {
namespace {

using Eigen::Isometry3d;
using registration::Registration;

// Fractures that pull a person's pose farther than this have found another place along the break.
constexpr double kHeld_mm = 5;
constexpr double kGivenPose_mm = 0.5;

Message waiting(const PairDecision& decision, const ScanRef& scan,
                const std::vector<ScanRef>& scans) {
  const bool photographed_again = resolved({scan.side, scan.id, scan.place_mm, {}}, scans) >= 0;
  return photographed_again
             ? message(
                   "The decision of %1 by %2 concerns %3, whose side has been reshot since; "
                   "decide again.",
                   momentOf(decision), decision.by, scan.id)
             : message(
                   "The decision of %1 by %2 concerns %3, which is no longer on the plate; "
                   "decide again.",
                   momentOf(decision), decision.by, scan.id);
}

bool common(const std::vector<int>& a, const std::vector<int>& b) {
  return std::ranges::any_of(a, [&](int i) { return std::find(b.begin(), b.end(), i) != b.end(); });
}

// A decision about partners, and the scans of the table that it is about.
struct Meant {
  const PairDecision* decision = nullptr;
  std::vector<int> fronts, backs;

  bool takesEffect() const {
    return decision->kind == DecisionKind::Pair ? fronts.size() == 1 && backs.size() == 1
                                                : !fronts.empty() || !backs.empty();
  }
};

// Files can be merged, and places of two sherds can become one: the word spoken last holds.
const PairDecision* laterThan(std::size_t i, const std::vector<Meant>& all) {
  for (std::size_t j = all.size(); j-- > i + 1;)
    if (common(all[i].fronts, all[j].fronts) || common(all[i].backs, all[j].backs))
      return all[j].decision;
  return nullptr;
}

void put(const Meant& meant, Settled& settled) {
  const auto add = [](std::vector<int>& to, const std::vector<int>& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  switch (meant.decision->kind) {
    case DecisionKind::Pair:
      settled.pairs.push_back({meant.fronts[0], meant.backs[0], *meant.decision});
      break;
    case DecisionKind::Aside:
      add(settled.aside_front, meant.fronts);
      add(settled.aside_back, meant.backs);
      break;
    case DecisionKind::Reshoot:
      add(settled.reshoot_front, meant.fronts);
      add(settled.reshoot_back, meant.backs);
      break;
    case DecisionKind::Join:
    case DecisionKind::Split:
    case DecisionKind::Withdraw:
      break;
  }
}

// The program's own word on a pair: what it would give it if nobody had decided.
pairing::Decision ownWord(const PairTable& free, int front, int back) {
  pairing::Decision own;
  own.front = front;
  own.back = back;
  for (const SherdPair& pair : free.pairs) {
    const pairing::Decision& d = pair.decision;
    if (d.front == front && d.back == back) return d;
    for (const pairing::Alternative& a : d.alternatives)
      if (a.front == front && a.back == back && a.score > own.score) {
        own.score = a.score;
        own.margin = a.score - d.score.value_or(0);
      }
  }
  return own;
}

int partnerOf(const PairTable& table, int front) {
  for (const SherdPair& pair : table.pairs)
    if (pair.decision.front == front) return pair.decision.back;
  return -1;
}

SherdPair decidedPair(const CandidateTable& table, const PairTable& free,
                      const Settled::Pair& settled) {
  SherdPair pair;
  pair.decision = ownWord(free, settled.front, settled.back);
  if (table.method == pairing::Method::Paper) {
    pair.decision.score = pair.decision.margin = std::nullopt;
  }
  pair.decision.doubt = pairing::Doubt::None;
  pair.decided = settled.decision.id;
  pair.decided_by = settled.decision.by;
  pair.decided_at = settled.decision.at;
  const RegisteredCandidate* known = table.find(settled.front, settled.back);
  for (const RegisteredDecision& done : table.decided)
    if (done.front == settled.front && done.back == settled.back &&
        done.id == settled.decision.id) {
      pair.registration = done.registration;
      return pair;
    }
  const std::optional<Isometry3d>& given = settled.decision.front_from_back;
  const ScanRef& back = table.backs[static_cast<std::size_t>(settled.back)];
  if (known != nullptr) {
    pair.contour_rms_mm = known->start().contour_rms_mm;
    pair.registration = known->registration;
    if (!given || apart_mm(back, *given, known->registration.front_from_back) < kGivenPose_mm)
      return pair;
  }
  pair.registration = Registration{};
  if (given) pair.registration.front_from_back = *given;
  return pair;
}

}  // namespace

double apart_mm(const ScanRef& back, const Isometry3d& a, const Isometry3d& b) {
  constexpr double kRadius_mm = 20, kHalfWall_mm = 3;  // of a common sherd
  const Eigen::Vector3d centre(back.place_mm.x(), back.place_mm.y(), kHalfWall_mm);
  const double turn =
      Eigen::AngleAxisd(Eigen::Matrix3d(a.linear().transpose() * b.linear())).angle();
  return std::sqrt((a * centre - b * centre).squaredNorm() +
                   2.0 / 3.0 * turn * turn * kRadius_mm * kRadius_mm);
}

Settled settledBy(const Decisions& standing, const CandidateTable& table) {
  Settled settled;
  std::vector<Meant> all;
  for (const PairDecision& d : standing) {
    if (d.kind == DecisionKind::Join || d.kind == DecisionKind::Split) continue;
    Meant meant{&d, {}, {}};
    for (const ScanRef& ref : d.scans) {
      const bool front = ref.side == batch::Side::Front;
      const std::vector<ScanRef>& scans = front ? table.fronts : table.backs;
      const int index = resolved(ref, scans);
      if (index < 0) settled.warnings.push_back(waiting(d, ref, scans));
      if (index >= 0) (front ? meant.fronts : meant.backs).push_back(index);
    }
    if (meant.takesEffect()) all.push_back(std::move(meant));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (const PairDecision* later = laterThan(i, all))
      settled.warnings.push_back(
          message("The decision of %1 by %2 has no effect: the later decision of %3 by %4 concerns "
                  "the same scan; withdraw one of them.",
                  momentOf(*all[i].decision), all[i].decision->by, momentOf(*later), later->by));
    else
      put(all[i], settled);
  }
  return settled;
}

Result<PairTable> assigned(const CandidateTable& table, const Settled& settled,
                           const pairing::AssignOptions& options) {
  Result<PairTable> free = assigned(table, options);
  if (!free) return free;
  std::set<int> taken_front(settled.aside_front.begin(), settled.aside_front.end());
  std::set<int> taken_back(settled.aside_back.begin(), settled.aside_back.end());
  taken_front.insert(settled.reshoot_front.begin(), settled.reshoot_front.end());
  taken_back.insert(settled.reshoot_back.begin(), settled.reshoot_back.end());
  for (const Settled::Pair& pair : settled.pairs) {
    taken_front.insert(pair.front);
    taken_back.insert(pair.back);
  }
  if (taken_front.empty() && taken_back.empty()) return free;

  CandidateTable rest = table;
  std::erase_if(rest.candidates, [&](const RegisteredCandidate& c) {
    return taken_front.contains(c.evidence.front) || taken_back.contains(c.evidence.back);
  });
  Result<PairTable> decided = assigned(rest, options);
  if (!decided) return decided;
  std::erase_if(decided->unpaired_front, [&](int i) { return taken_front.contains(i); });
  std::erase_if(decided->unpaired_back, [&](int i) { return taken_back.contains(i); });
  for (SherdPair& pair : decided->pairs)
    if (partnerOf(*free, pair.decision.front) != pair.decision.back)
      pair.decision.doubt = pairing::Doubt::Displaced;  // nothing is taken silently
  for (const Settled::Pair& pair : settled.pairs)
    decided->pairs.push_back(decidedPair(table, *free, pair));
  std::ranges::stable_sort(decided->pairs, [](const SherdPair& a, const SherdPair& b) {
    return a.decision.front < b.decision.front;
  });
  decided->candidates = free->candidates;
  decided->aside_front = settled.aside_front;
  decided->aside_back = settled.aside_back;
  decided->reshoot_front = settled.reshoot_front;
  decided->reshoot_back = settled.reshoot_back;
  return decided;
}

Result<Registration> registerDecided(const PairDecision& decision, const scan::Scan& front,
                                     const scan::Scan& back,
                                     const registration::Constraints& constraints,
                                     const PairOptions& options, Progress& progress,
                                     std::stop_token stop) {
  std::vector<Isometry3d> starts;
  if (decision.front_from_back) {
    starts.push_back(*decision.front_from_back);
  } else {
    pairing::CandidateOptions reach = options.candidates;
    reach.reach = 1e9;  // a person said that they belong together
    const auto found = pairing::findCandidates({&front, 1}, {&back, 1}, reach, progress, stop);
    if (!found) return found.error();
    for (const pairing::PairCandidate& c : *found)
      for (const pairing::StartPose& start : c.starts) starts.push_back(start.front_from_back);
  }
  const auto front_strip =
      registration::prepareStrip(front, options.registration.strip, constraints.front);
  const auto back_strip =
      registration::prepareStrip(back, options.registration.strip, constraints.back);
  Result<Registration> found =
      !front_strip  ? Result<Registration>(front_strip.error())
      : !back_strip ? Result<Registration>(back_strip.error())
                    : registration::registerSides(*front_strip, *back_strip, starts, constraints,
                                                  options.registration, progress, stop);
  if (found) found->start = 0;
  const std::optional<Isometry3d>& given = decision.front_from_back;
  if (!given || (!found && found.error().code == ErrorCode::Cancelled)) return found;
  const ScanRef place = refOf(back, batch::Side::Back);
  const double moved = found ? apart_mm(place, *given, found->front_from_back) : 1.0;
  if (found && decision.settle == Settle::ByFractures && moved < kHeld_mm) return found;
  Registration stands = found ? *found : Registration{};
  stands.front_from_back = *given;
  stands.start = 0;
  stands.runner_up_gap = 1e9;
  stands.uncertainty_mm = std::hypot(stands.uncertainty_mm, moved);
  if (front_strip && back_strip) {
    const registration::PoseFigures figures =
        registration::figuresAt(*front_strip, *back_strip, *given);
    stands.fracture_rms_mm = figures.fracture_rms_mm;
    stands.fracture_overlap = figures.fracture_overlap;
    stands.crossing_share = figures.crossing_share;
    stands.thickness_mm = figures.thickness_mm;
  }
  return stands;
}

}  // namespace ostraka::decisions
