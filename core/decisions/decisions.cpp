#include "decisions/decisions.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <unordered_set>

#include "base/limits.h"
#include "base/message.h"
#include "base/text.h"
#include "base/uuid.h"
#include "batch/peoples_files.h"
#include "decisions/candidate_table.h"
#include "decisions/change_peoples_file.h"
#include "files/files.h"
#include "files/json.h"
#include "files/json_numbers.h"

namespace ostraka::decisions {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr double kSamePose = 1e-9;  // relative: what was written and read again

struct KindName {
  DecisionKind kind;
  const char* name;
};
constexpr std::array<KindName, 6> kKinds = {{{DecisionKind::Pair, "pair"},
                                             {DecisionKind::Aside, "aside"},
                                             {DecisionKind::Reshoot, "reshoot"},
                                             {DecisionKind::Join, "join"},
                                             {DecisionKind::Split, "split"},
                                             {DecisionKind::Withdraw, "withdraw"}}};

const char* nameOf(DecisionKind kind) {
  for (const KindName& k : kKinds)
    if (k.kind == kind) return k.name;
  return "";
}

std::optional<DecisionKind> kindOf(const std::string& name) {
  for (const KindName& k : kKinds)
    if (name == k.name) return k.kind;
  return {};
}

fs::path fileIn(const fs::path& output) {
  return output / batch::kDecisionsFile;
}

ordered_json toJson(const Eigen::Vector2d& p) {
  return {p.x(), p.y()};
}

Eigen::Vector2d pointFrom(const json& value) {
  return {numberIn(value.at(0), "place_mm"), numberIn(value.at(1), "place_mm")};
}

ordered_json toJson(const PairDecision& d) {
  ordered_json scans = ordered_json::array();
  for (const ScanRef& scan : d.scans) {
    scans.push_back(
        {{"side", batch::name(scan.side)}, {"id", scan.id}, {"place_mm", toJson(scan.place_mm)}});
    if (!scan.photographs.empty()) scans.back()["photographs"] = scan.photographs;
  }
  ordered_json out = {
      {"id", d.id}, {"replaces", d.replaces}, {"kind", nameOf(d.kind)}, {"at", d.at},
      {"by", d.by}, {"note", d.note},         {"scans", scans}};
  if (d.kind == DecisionKind::Pair) {
    if (d.front_from_back) out["T_front_from_back"] = ostraka::toJson(*d.front_from_back);
    out["settle"] = d.settle == Settle::AsGiven ? "as_given" : "by_fractures";
  }
  if (d.kind == DecisionKind::Split) out["cut_mm"] = {toJson(d.cut_mm[0]), toJson(d.cut_mm[1])};
  return out;
}

Result<PairDecision> decisionFrom(const json& value, const std::string& where) {
  PairDecision d;
  const std::optional<DecisionKind> kind = kindOf(value.at("kind").get<std::string>());
  if (!kind)
    return Error::unusable(
        message("A decision is of an unknown kind; a newer version of Ostraka wrote it."), where);
  d.kind = *kind;
  d.id = value.at("id").get<std::string>();
  d.replaces = value.at("replaces").get<std::vector<std::string>>();
  d.at = value.at("at").get<std::string>();
  d.by = value.at("by").get<std::string>();
  d.note = value.value("note", "");
  for (const json& scan : value.at("scans"))
    d.scans.push_back(
        {scan.at("side").get<std::string>() == "back" ? batch::Side::Back : batch::Side::Front,
         scan.at("id").get<std::string>(), pointFrom(scan.at("place_mm")),
         scan.value("photographs", "")});
  if (value.contains("T_front_from_back")) {
    const Result<Eigen::Isometry3d> pose = isometryFromJson(value["T_front_from_back"], where);
    if (!pose) return pose.error();
    d.front_from_back = *pose;
  }
  d.settle =
      value.value("settle", "by_fractures") == "as_given" ? Settle::AsGiven : Settle::ByFractures;
  if (value.contains("cut_mm"))
    d.cut_mm = {pointFrom(value["cut_mm"].at(0)), pointFrom(value["cut_mm"].at(1))};
  return d;
}

auto withId(const std::string& id) {
  return [&id](const PairDecision& d) { return d.id == id; };
}

bool aboutPartners(DecisionKind kind) {
  return kind == DecisionKind::Pair || kind == DecisionKind::Aside || kind == DecisionKind::Reshoot;
}

// By their places alone: what was said about earlier photographs is replaced, too.
bool shareAScan(const PairDecision& a, const PairDecision& b) {
  for (const ScanRef& x : a.scans)
    for (const ScanRef& y : b.scans)
      if (resolved({x.side, x.id, x.place_mm, {}}, {y}) == 0) return true;
  return false;
}

// Both sides of a sherd were taken out of the pairs: what is said of one of them is said of the
// other, which would be without a partner otherwise.
void takeAlong(PairDecision& decision, const PairDecision& replaced, const CandidateTable& now) {
  if (decision.kind == DecisionKind::Pair || replaced.kind == DecisionKind::Pair) return;
  for (const ScanRef& scan : replaced.scans)
    if (resolved(scan, scan.side == batch::Side::Front ? now.fronts : now.backs) >= 0 &&
        std::ranges::none_of(decision.scans,
                             [&](const ScanRef& other) { return other.side == scan.side; }))
      decision.scans.push_back(scan);
}

Error tooMany(const std::string& where) {
  return Error::unusable(message("A batch can have at most %1 decisions; move this file elsewhere, "
                                 "or restore a copy of it.",
                                 limits::kDecisions.most),
                         where);
}

Decisions replacedAmong(const Decisions& holding, const PairDecision& decision) {
  Decisions replaced;
  for (const PairDecision& other : holding)
    if (aboutPartners(decision.kind) && aboutPartners(other.kind) && shareAScan(decision, other))
      replaced.push_back(other);
  return replaced;
}

// It would bring back what contradicts a decision that was made since.
Result<void> checkWithdrawal(const Decisions& all, const PairDecision& withdrawal,
                             const std::string& where) {
  const Decisions holding = standing(all);
  const std::unordered_set<std::string_view> withdrawn(withdrawal.replaces.begin(),
                                                       withdrawal.replaces.end());
  std::unordered_set<std::string_view> back;
  for (const std::string& id : withdrawal.replaces) {
    const auto held = std::find_if(holding.begin(), holding.end(), withId(id));
    if (held == holding.end())
      return Error::unusable(message("This decision is no longer in effect."), where);
    back.insert(held->replaces.begin(), held->replaces.end());
  }
  for (const PairDecision& d : all) {
    if (!back.contains(d.id)) continue;
    for (const PairDecision& other : replacedAmong(holding, d))
      if (!withdrawn.contains(other.id))
        return Error::changedMeanwhile(nameOf(DecisionKind::Pair), where);
  }
  return {};
}

using Places = std::unordered_map<std::string_view, std::size_t>;  // in the list, by id

// A list grows at its end: what is replaced stands above, and once is enough.
Result<void> checkedIn(const Places& earlier, const PairDecision& d) {
  if (!isUuid(d.id) || earlier.contains(d.id))
    return Error::unusable(message("Its id is missing or used twice."));
  std::unordered_set<std::string_view> replaced;
  for (const std::string& id : d.replaces)
    if (!earlier.contains(id) || !replaced.insert(id).second)
      return Error::unusable(message(
          "It replaces a decision twice, or one that does not come before it in the file."));
  return {};
}

Result<void> checked(const PairDecision& d) {
  const auto bad = [](Message what) { return Error::unusable(std::move(what)); };
  if (d.by.empty()) return bad(message("A decision needs the name of the person who makes it."));
  if (d.replaces.size() > limits::kDecisionReplaces.most)
    return Error::unusable(
        message("It replaces more than %1 decisions.", limits::kDecisionReplaces.most));
  for (const std::string* text : {&d.by, &d.at, &d.note})
    if (Result<void> good = checkText(*text); !good) return good;
  for (const ScanRef& scan : d.scans)
    if (Result<void> good = checkText(scan.id); !good) return good;
  const std::size_t n = d.scans.size();
  const auto side = [&](std::size_t i) { return d.scans[i].side; };
  switch (d.kind) {
    case DecisionKind::Pair:
      if (n != 2 || side(0) != batch::Side::Front || side(1) != batch::Side::Back)
        return bad(message("A pair needs one front and one back."));
      break;
    case DecisionKind::Aside:
    case DecisionKind::Reshoot:
      if (n == 0) return bad(message("Nothing is selected to set aside or reshoot."));
      break;
    case DecisionKind::Join:
      if (n < 2 || side(0) != side(1))
        return bad(message("Fragments to merge must be of one side."));
      break;
    case DecisionKind::Split:
      if (n != 1 || (d.cut_mm[0] - d.cut_mm[1]).norm() < 1)
        return bad(message("A split needs one fragment and a line of at least 1 mm."));
      break;
    case DecisionKind::Withdraw:
      if (d.replaces.empty()) return bad(message("Nothing is selected to withdraw."));
      break;
  }
  return {};
}

// With what it replaces, its id and its time.
Result<void> appendWhileHeld(const fs::path& output, PairDecision& decision) {
  std::error_code failed;
  if (!fs::is_directory(output, failed))  // a decision alone would stand in the way of new results
    return Error{ErrorCode::Missing,
                 message("The results of this batch no longer exist; reprocess it, then decide."),
                 output.string()};
  Result<Decisions> decisions = readDecisions(output);
  if (!decisions) return decisions.error();
  if (decisions->size() >= limits::kDecisions.most) return tooMany(fileIn(output).string());
  if (decision.kind == DecisionKind::Withdraw) {
    const Result<void> valid = checkWithdrawal(*decisions, decision, fileIn(output).string());
    if (!valid) return valid;
  } else {
    decision.replaces.clear();
    const Result<CandidateTable> now = readCandidatesOf(output);
    for (const PairDecision& other : replacedAmong(standing(*decisions), decision)) {
      decision.replaces.push_back(other.id);
      if (now) takeAlong(decision, other, *now);
    }
    if (const Result<void> valid = checked(decision); !valid) return valid;
  }
  using namespace std::chrono;
  decision.id = newId(duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count());
  decision.at = utcNow();
  decisions->push_back(decision);
  return writeFileAtomically(fileIn(output), textOf(*decisions));
}

}  // namespace

std::string momentOf(const PairDecision& decision) {
  if (decision.at.size() < 16) return decision.at;
  return decision.at.substr(0, 10) + " " + decision.at.substr(11, 5) + " UTC";
}

Decisions followed(const Decisions& all, const fs::path& output) {
  const Result<json> report = readJson(output / "report.json");
  if (!report) return {};
  const auto ids = report->find("decisions");
  if (ids == report->end() || !ids->is_array()) return {};
  std::unordered_set<std::string_view> named;
  for (const json& id : *ids)
    if (id.is_string()) named.insert(id.get_ref<const std::string&>());
  Decisions found;
  for (const PairDecision& d : all)
    if (named.contains(d.id)) found.push_back(d);
  return found;
}

bool equivalent(const PairDecision& a, const PairDecision& b) {
  const bool posed = a.front_from_back.has_value();
  return a.kind == b.kind && a.settle == b.settle &&
         (a.kind != DecisionKind::Split || a.cut_mm == b.cut_mm) &&
         std::equal(a.scans.begin(), a.scans.end(), b.scans.begin(), b.scans.end(),
                    [](const ScanRef& x, const ScanRef& y) {
                      return x.side == y.side && x.place_mm == y.place_mm &&
                             x.photographs == y.photographs;
                    }) &&
         posed == b.front_from_back.has_value() &&
         (!posed || a.front_from_back->isApprox(*b.front_from_back, kSamePose));
}

bool equivalent(const Decisions& a, const Decisions& b) {
  return a.size() == b.size() &&
         std::all_of(a.begin(), a.end(), [&](const PairDecision& d) { return containedIn(b, d); });
}

bool containedIn(const Decisions& list, const PairDecision& d) {
  return std::ranges::any_of(list, [&](const PairDecision& other) { return equivalent(other, d); });
}

Decisions changedSince(const Decisions& all, const Decisions& followed) {
  Decisions changed;
  const Decisions now = standing(all);
  for (const PairDecision& d : now)
    if (!containedIn(followed, d)) changed.push_back(d);
  for (const PairDecision& d : followed)
    if (!containedIn(now, d)) changed.push_back(d);
  return changed;
}

int resolved(const ScanRef& ref, const std::vector<ScanRef>& scans) {
  int nearest = -1;
  double least = kSamePiece_mm;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (scans[i].side != ref.side) continue;
    if (!ref.photographs.empty() && !scans[i].photographs.empty() &&
        ref.photographs != scans[i].photographs)
      continue;
    const double distance = (scans[i].place_mm - ref.place_mm).norm();
    if (distance < least) least = distance, nearest = static_cast<int>(i);
  }
  return nearest;
}

Decisions standing(const Decisions& all) {
  Places places;
  std::vector<std::vector<std::size_t>> replaced(all.size());
  std::vector<bool> holds(all.size(), false);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const std::string& id : all[i].replaces)
      if (const auto found = places.find(id); found != places.end())
        replaced[i].push_back(found->second);
    places.emplace(all[i].id, i);
    const bool withdrawal = all[i].kind == DecisionKind::Withdraw;
    holds[i] = !withdrawal;
    for (const std::size_t j : replaced[i]) {
      holds[j] = false;
      if (!withdrawal) continue;
      for (const std::size_t k : replaced[j]) holds[k] = all[k].kind != DecisionKind::Withdraw;
    }
  }
  Decisions kept;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (holds[i]) kept.push_back(all[i]);
  return kept;
}

Result<Decisions> readDecisions(const fs::path& output) {
  const fs::path file = fileIn(output);
  std::error_code failed;
  if (!fs::exists(file, failed)) return Decisions{};
  const Result<std::string> text = readFile(file);
  if (!text) return text.error();
  return parseDecisions(*text, file.string());
}

Result<Decisions> parseDecisions(std::string_view text, const std::string& where) {
  const Result<json> value = parseJson(text, where);
  if (!value) return value.error();
  Decisions decisions;
  Places places;
  try {
    if (wholeAt(*value, "format") > kFormat)
      return Error::unusable(
          message("A newer version of Ostraka wrote these decisions; use that version."), where);
    const json& entries = value->at("decisions");
    if (entries.size() > limits::kDecisions.most) return tooMany(where);
    decisions.reserve(entries.size());  // their ids stay in place
    for (const json& entry : entries) {
      Result<PairDecision> decision = decisionFrom(entry, where);
      if (!decision) return decision.error();
      Result<void> valid = checked(*decision);
      if (valid) valid = checkedIn(places, *decision);
      if (!valid)
        return Error::unusable(
            inOne(inOne(message("Decision %1 cannot be used.", decisions.size() + 1),
                        valid.error().what),
                  message("Correct it, or restore a copy of the file.")),
            where);
      decisions.push_back(std::move(*decision));
      places.emplace(decisions.back().id, decisions.size() - 1);
    }
  } catch (const json::exception& refused) {
    return unusableJson(
        refused,
        message("Not a decisions file of Ostraka; move it elsewhere, or restore a copy of it."),
        where);
  }
  return decisions;
}

ordered_json toJson(const Decisions& decisions) {
  ordered_json list = ordered_json::array();
  for (const PairDecision& d : decisions) list.push_back(toJson(d));
  return list;
}

std::string textOf(const Decisions& decisions) {
  return jsonText({{"format", kFormat}, {"unit", "mm"}, {"decisions", toJson(decisions)}});
}

Result<PairDecision> appendDecision(const fs::path& output, PairDecision decision) {
  if (const Result<void> valid = checked(decision); !valid) return valid.error();
  const Result<void> appended =
      changePeoplesFile(output, [&] { return appendWhileHeld(output, decision); });
  if (!appended) return appended.error();
  return decision;
}

Result<Decisions> replacedBy(const PairDecision& decision, const fs::path& output) {
  const Result<Decisions> all = readDecisions(output);
  if (!all) return all.error();
  return replacedAmong(standing(*all), decision);
}

}  // namespace ostraka::decisions
