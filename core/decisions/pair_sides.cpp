#include "decisions/pair_sides.h"

#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/parallel.h"
#include "files/json.h"
#include "pairing/fracture_evidence.h"

namespace ostraka::decisions {
namespace {

using nlohmann::ordered_json;

struct Registered {
  const pairing::PairCandidate* candidate = nullptr;
  std::optional<registration::Registration> registration;  // absent: cancelled
};

// Where fractures cannot be compared, the outlines may still tell the pair; its pose is for a
// person.
registration::Registration outlinesAlone(const pairing::PairCandidate& candidate, std::string why) {
  registration::Registration rough;
  rough.front_from_back = candidate.starts.front().front_from_back;
  rough.start = 0;
  rough.runner_up_gap = 1e9;
  rough.uncertainty_mm = 1;  // a start's tilt and height
  rough.check_failed = true;
  rough.failed_check = registration::FailedCheck::OutlinesAlone;
  rough.reason = "Only the outlines of these sides match: " + std::move(why);
  return rough;
}

Eigen::Vector2d place(const scan::Scan& scan) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3f& p : scan.cloud.points) sum += p.head<2>().cast<double>();
  return sum / std::max<double>(1.0, static_cast<double>(scan.cloud.size()));
}

// Half of all flips leave the sherd near its place (a hand's 15 mm), the others anywhere on a plate
// of 130 mm radius. Never more than +2.5 or less than -0.7: a hint.
double placeLogLikelihood(const scan::Scan& front, const scan::Scan& back) {
  constexpr double kHand_mm = 15, kPlate_mm = 130, kPi = 3.14159265358979323846;
  const double d2 = (place(front) - place(back)).squaredNorm();
  const double near = std::exp(-0.5 * d2 / (kHand_mm * kHand_mm)) / (2 * kPi * kHand_mm * kHand_mm);
  const double anywhere = 1 / (kPi * kPlate_mm * kPlate_mm);
  return std::min(2.5, std::log(0.5 + 0.5 * near / anywhere));
}

// What the outlines say of the pose that the registration ended at: the best start that describes
// the same pose. A worse start may well have led there; its own figure would say too little.
double outlineOf(const Registered& r, const scan::Scan& back) {
  constexpr double kSamePose_mm =
      4;  // starts are off by up to 6 degrees of tilt and 1 mm in height
  const registration::Registration& found = *r.registration;
  double best =
      r.candidate->starts.at(static_cast<std::size_t>(std::max(0, found.start))).log_likelihood;
  const std::size_t step = std::max<std::size_t>(1, back.cloud.size() / 200);
  for (const pairing::StartPose& start : r.candidate->starts) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < back.cloud.size(); i += step, ++count) {
      const Eigen::Vector3d p = back.cloud.points[i].cast<double>();
      sum += (start.front_from_back * p - found.front_from_back * p).squaredNorm();
    }
    if (sum <= kSamePose_mm * kSamePose_mm * count) best = std::max(best, start.log_likelihood);
  }
  return best;
}

constexpr double kRuledOut = 12;  // logarithm: below the best start's outline by this much

bool fracturesCompared(const Registered& r) {
  return r.registration && r.registration->misfit_mm > 0;
}

/// One figure per candidate, 0 where no fractures could be compared.
std::vector<double> fracturesOf(const std::vector<Registered>& registered,
                                std::span<const scan::Scan> backs) {
  std::vector<pairing::FractureFigures> figures;
  for (const Registered& r : registered) {
    if (!fracturesCompared(r)) continue;
    const scan::Scan& back = backs[static_cast<std::size_t>(r.candidate->back)];
    figures.push_back({r.candidate->front, r.candidate->back, outlineOf(r, back),
                       r.registration->misfit_mm, r.registration->misfit_places});
  }
  const std::vector<double> known = pairing::fractureLogLikelihoods(figures);
  std::vector<double> fractures(registered.size(), 0);
  std::size_t next = 0;
  for (std::size_t i = 0; i < registered.size(); ++i) {
    if (fracturesCompared(registered[i])) fractures[i] = known[next++];
  }
  return fractures;
}

pairing::Evidence evidenceOf(const Registered& r) {
  const registration::Registration& found = *r.registration;
  pairing::Evidence evidence;
  evidence.front = r.candidate->front;
  evidence.back = r.candidate->back;
  evidence.fracture_rms_mm = found.fracture_rms_mm;
  evidence.overlap = found.fracture_overlap;
  evidence.check_failed = found.check_failed;
  evidence.distance_rad = r.candidate->distance_rad;
  return evidence;
}

// Outlines, fractures and places together. candidates: of those that are registered, in their
// order.
void weigh(const std::vector<Registered>& registered, std::span<const scan::Scan> fronts,
           std::span<const scan::Scan> backs, PlaceEvidence hints,
           std::vector<RegisteredCandidate>& candidates) {
  const std::vector<double> fractures = fracturesOf(registered, backs);
  const int n_scans = static_cast<int>(std::max(fronts.size(), backs.size()));
  auto next = candidates.begin();
  for (std::size_t i = 0; i < registered.size(); ++i) {
    const Registered& r = registered[i];
    if (!r.registration) continue;
    const scan::Scan& front = fronts[static_cast<std::size_t>(r.candidate->front)];
    const scan::Scan& back = backs[static_cast<std::size_t>(r.candidate->back)];
    const double hint = hints == PlaceEvidence::None ? 0.0 : placeLogLikelihood(front, back);
    pairing::Evidence& evidence = next++->evidence;
    evidence.log_likelihood =
        pairing::jointLogLikelihood(outlineOf(r, back), fractures[i], n_scans) + hint;
    evidence.runner_up_start_log_likelihood =
        evidence.log_likelihood - r.registration->runner_up_gap;
  }
}

struct PreparedStrip {
  std::optional<registration::Strip> strip;
  std::string why;  // there is none
};

std::vector<PreparedStrip> stripsOf(std::span<const scan::Scan> scans,
                                    const registration::StripOptions& options,
                                    std::span<const registration::SilhouetteView> views,
                                    int threads) {
  std::vector<PreparedStrip> strips(scans.size());
  parallelFor(scans.size(), threads, [&](std::size_t i) {
    Result<registration::Strip> strip = registration::prepareStrip(scans[i], options, views);
    if (strip) {
      strips[i].strip = std::move(*strip);
    } else {
      strips[i].why = strip.error().sentence().english();
    }
  });
  return strips;
}

// To find candidates takes a small part of the time that their registration takes.
class NotesOnly final : public Progress {
 public:
  explicit NotesOnly(Progress& outer) : outer_(outer) {}
  void begin(std::string_view, double) override {}
  void report(std::int64_t, std::int64_t) override {}
  void note(NoteLevel level, const Message& text) override { outer_.note(level, text); }

 private:
  Progress& outer_;
};

}  // namespace

Result<CandidateTable> compareSides(std::span<const scan::Scan> fronts,
                                    std::span<const scan::Scan> backs,
                                    const registration::Constraints& constraints,
                                    const PairOptions& options, Progress& progress,
                                    std::stop_token stop) {
  NotesOnly notes(progress);
  const Result<std::vector<pairing::PairCandidate>> candidates =
      pairing::findCandidates(fronts, backs, options.candidates, notes, stop);
  if (!candidates) return candidates.error();
  const auto front_strips =
      stripsOf(fronts, options.registration.strip, constraints.front, options.threads);
  const auto back_strips =
      stripsOf(backs, options.registration.strip, constraints.back, options.threads);

  std::vector<Registered> registered(candidates->size());
  QuietProgress quiet;
  std::atomic<std::int64_t> done = 0;
  const std::thread::id own = std::this_thread::get_id();
  parallelFor(candidates->size(), options.threads, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const std::int64_t before = done++;
    if (std::this_thread::get_id() == own)
      progress.report(before, static_cast<std::int64_t>(candidates->size()));
    const pairing::PairCandidate& candidate = (*candidates)[i];
    registered[i].candidate = &candidate;
    if (candidate.starts.empty()) return;
    const PreparedStrip& front = front_strips[static_cast<std::size_t>(candidate.front)];
    const PreparedStrip& back = back_strips[static_cast<std::size_t>(candidate.back)];
    if (!front.strip || !back.strip) {
      registered[i].registration = outlinesAlone(candidate, (front.strip ? back : front).why);
      return;
    }
    // Best first. Fractures that hardly meet may agree by chance where outlines rule the pose out.
    std::vector<Eigen::Isometry3d> starts;
    for (const pairing::StartPose& start : candidate.starts)
      if (start.log_likelihood > candidate.starts.front().log_likelihood - kRuledOut)
        starts.push_back(start.front_from_back);
    const Result<registration::Registration> found = registration::registerSides(
        *front.strip, *back.strip, starts, constraints, options.registration, quiet, stop);
    registered[i].registration =
        found ? *found : outlinesAlone(candidate, found.error().sentence().english());
  });
  if (stop.stop_requested()) return Error::cancelled();

  CandidateTable table;
  table.method = options.candidates.method;
  for (const scan::Scan& scan : fronts) table.fronts.push_back(refOf(scan, batch::Side::Front));
  for (const scan::Scan& scan : backs) table.backs.push_back(refOf(scan, batch::Side::Back));
  for (const Registered& r : registered)
    if (r.registration)
      table.candidates.push_back({evidenceOf(r), *r.registration, r.candidate->starts});
  if (table.method == pairing::Method::Default)
    weigh(registered, fronts, backs, options.place, table.candidates);
  return table;
}

Result<PairTable> assigned(const CandidateTable& candidates,
                           const pairing::AssignOptions& options) {
  std::vector<pairing::Evidence> evidence;
  for (const RegisteredCandidate& c : candidates.candidates) evidence.push_back(c.evidence);
  const int n_front = static_cast<int>(candidates.fronts.size());
  const int n_back = static_cast<int>(candidates.backs.size());
  const Result<pairing::Assignment> assignment =
      candidates.method == pairing::Method::Paper
          ? pairing::nearestPairs(evidence, n_front, n_back)
          : pairing::assignPairs(evidence, n_front, n_back, options);
  if (!assignment) return assignment.error();
  PairTable table;
  table.unpaired_front = assignment->unpaired_front;
  table.unpaired_back = assignment->unpaired_back;
  table.candidates = static_cast<int>(candidates.candidates.size());
  for (const pairing::Decision& decision : assignment->pairs) {
    const RegisteredCandidate* c = candidates.find(decision.front, decision.back);
    if (c == nullptr) continue;
    table.pairs.push_back({decision, c->registration, c->start().contour_rms_mm, {}, {}, {}});
  }
  return table;
}

Result<PairTable> pairSides(std::span<const scan::Scan> fronts, std::span<const scan::Scan> backs,
                            const registration::Constraints& constraints,
                            const PairOptions& options, Progress& progress, std::stop_token stop) {
  const Result<CandidateTable> table =
      compareSides(fronts, backs, constraints, options, progress, stop);
  if (!table) return table.error();
  return assigned(*table, options.assign);
}

std::string reasonOf(const SherdPair& pair) {
  using pairing::Doubt;
  switch (pair.decision.doubt) {
    case Doubt::None:
      return {};
    case Doubt::SelfCheck:
      return pair.registration.reason;
    case Doubt::OtherPartner:
      return "Another partner fits almost as well.";
    case Doubt::Unrelated:
      return "The two sides fit barely better than unrelated ones.";
    case Doubt::OtherPose:
      return "Another pose of the same two sides fits almost as well.";
    case Doubt::NotSure:
      return "The pair is likely, but not certain enough to be accepted unseen.";
    case Doubt::Displaced:
      return "A person assigned its back to another front.";
    case Doubt::SharedBack:
      return "Another front takes the same back.";
  }
  return {};
}

ordered_json toJson(const PairTable& table, const std::vector<ScanRef>& fronts,
                    const std::vector<ScanRef>& backs) {
  const auto front = [&](int i) { return fronts[static_cast<std::size_t>(i)].id; };
  const auto back = [&](int i) { return backs[static_cast<std::size_t>(i)].id; };
  ordered_json pairs = ordered_json::array();
  for (const SherdPair& pair : table.pairs) {
    ordered_json alternatives = ordered_json::array();
    for (const pairing::Alternative& a : pair.decision.alternatives)
      alternatives.push_back(
          {{"front", front(a.front)}, {"back", back(a.back)}, {"score", a.score}});
    pairs.push_back({{"front", front(pair.decision.front)},
                     {"back", back(pair.decision.back)},
                     {"score", orNull(pair.decision.score)},
                     {"margin", orNull(pair.decision.margin)},
                     {"ambiguous", pair.decision.ambiguous()},
                     {"reason", reasonOf(pair)},
                     {"alternatives", alternatives},
                     {"T_front_from_back", ostraka::toJson(pair.registration.front_from_back)},
                     {"fracture_rms_mm", nullptr},
                     {"fracture_misfit_mm", pair.registration.misfit_mm},
                     {"fracture_overlap", pair.registration.fracture_overlap},
                     {"uncertainty_mm", pair.registration.uncertainty_mm},
                     {"contour_rms_mm", pair.contour_rms_mm},
                     {"check_failed", pair.registration.check_failed}});
    if (pair.registration.fracture_rms_mm > 0)
      pairs.back()["fracture_rms_mm"] =
          pair.registration.fracture_rms_mm;  // null: no fractures to compare
    if (pair.decision.distance_rad) pairs.back()["distance_rad"] = *pair.decision.distance_rad;
    if (!pair.decided.empty())
      pairs.back()["decided"] = {
          {"id", pair.decided}, {"by", pair.decided_by}, {"at", pair.decided_at}};
    if (pair.registration.scale != 1) pairs.back()["scale"] = pair.registration.scale;
  }
  const auto ids = [](const std::vector<int>& indices, const std::vector<ScanRef>& scans) {
    ordered_json list = ordered_json::array();
    for (const int i : indices) list.push_back(scans[static_cast<std::size_t>(i)].id);
    return list;
  };
  ordered_json json = {{"unit", "mm"},
                       {"pairs", pairs},
                       {"unpaired_front", ids(table.unpaired_front, fronts)},
                       {"unpaired_back", ids(table.unpaired_back, backs)}};
  // Only where a person said so: without decisions the file is as ever.
  const auto add = [&](const char* key, const std::vector<int>& front_scans,
                       const std::vector<int>& back_scans) {
    if (front_scans.empty() && back_scans.empty()) return;
    ordered_json both = ids(front_scans, fronts);
    for (const ordered_json& id : ids(back_scans, backs)) both.push_back(id);
    json[key] = both;
  };
  add("set_aside", table.aside_front, table.aside_back);
  add("reshoot", table.reshoot_front, table.reshoot_back);
  return json;
}

ordered_json toJson(const PairTable& table, std::span<const scan::Scan> fronts,
                    std::span<const scan::Scan> backs) {
  std::vector<ScanRef> front_refs, back_refs;
  for (const scan::Scan& scan : fronts) front_refs.push_back(refOf(scan, batch::Side::Front));
  for (const scan::Scan& scan : backs) back_refs.push_back(refOf(scan, batch::Side::Back));
  return toJson(table, front_refs, back_refs);
}

}  // namespace ostraka::decisions
