// Which back belongs to which front: a list that is only added to, and what of it counts.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "catalogue/history.h"
#include "catalogue/kept_models.h"
#include "catalogue/restore.h"
#include "catalogue/sherd_columns.h"
#include "catalogue/typed_numbers.h"
#include "files/json.h"
#include "files/json_text.h"
#include "records/words.h"
#include "store/names.h"

namespace ostraka::catalogue {
namespace {

std::string poseText(const std::optional<Eigen::Isometry3d>& pose) {
  return pose ? toJson(*pose).dump() : std::string();
}

std::optional<Eigen::Isometry3d> poseFromText(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const nlohmann::json json = jsonOrDiscarded(text);
  const Result<Eigen::Isometry3d> pose = isometryFromJson(json, "pair_decision");
  if (!pose) return std::nullopt;
  return *pose;
}

void checkSide(Database& database, BatchRow batch, ScanRow scan, const char* side) {
  if (!scan) return;
  Statement row = database.sql("SELECT 1 FROM scan WHERE row = ? AND batch = ? AND side = ?");
  if (!row.with(scan, batch, side).next())
    refuse(std::string("The scan is not a ") + side + " of this batch.");
}

DecisionRow insertDecision(Database& database, const PairDecision& d, const std::string& id) {
  database
      .sql(
          "INSERT INTO pair_decision (id, at, person, batch, front, back, front_from_back, "
          "score, margin, ambiguous, fracture_rms_mm, fracture_overlap, verdict, replaces, note) "
          "VALUES "
          "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .with(id, d.at_ms, d.by, d.batch, d.front, d.back, poseText(d.front_from_back), d.score,
            d.margin, d.ambiguous, d.fracture_rms_mm, d.fracture_overlap, wordOf(d.verdict),
            d.replaces, d.note)
      .run();
  return {database.lastRow()};
}

using Pair = std::pair<ScanRow, ScanRow>;

// Persons before the program, later before earlier. Each scan is claimed once.
std::vector<PairDecision> counting(const std::vector<PairDecision>& all) {
  std::set<DecisionRow> withdrawn;
  std::vector<const PairDecision*> persons, program;
  for (auto it = all.rbegin(); it != all.rend(); ++it) {
    if (withdrawn.contains(it->row)) continue;
    if (it->verdict == Verdict::Withdraw)
      withdrawn.insert(it->replaces);
    else
      (it->by ? persons : program).push_back(&*it);
  }
  std::set<ScanRow> claimed;
  std::set<Pair> rejected;
  std::vector<PairDecision> counts;
  const auto free = [&](ScanRow scan) { return scan && !claimed.contains(scan); };
  for (const auto* list : {&persons, &program})
    for (const PairDecision* d : *list) {
      const Pair pair{d->front, d->back};
      if (d->verdict == Verdict::Reject) {
        const bool settled = claimed.contains(d->front) && claimed.contains(d->back);
        if (!settled) rejected.insert(pair);
        continue;
      }
      if (d->verdict == Verdict::Accept) {
        if (!free(d->front) || !free(d->back) || rejected.contains(pair)) continue;
        claimed.insert({d->front, d->back});
        counts.push_back(*d);
        continue;
      }
      PairDecision lone = *d;  // what is still free of it
      if (!free(lone.front)) lone.front = {};
      if (!free(lone.back)) lone.back = {};
      if (!lone.front && !lone.back) continue;
      if (lone.front) claimed.insert(lone.front);
      if (lone.back) claimed.insert(lone.back);
      counts.push_back(lone);
    }
  std::sort(counts.begin(), counts.end(), [](const PairDecision& a, const PairDecision& b) {
    return std::pair(a.front, a.back) < std::pair(b.front, b.back);
  });
  return counts;
}

// The context and the bag that all sherds of a batch share; none when they do not.
void placeOfBatch(const Catalogue& catalogue, BatchRow batch, SherdRecord& sherd) {
  Statement rows = catalogue.database().sql(
      "SELECT min(bag.context), min(bag.row), count(*), count(DISTINCT bag.context) FROM batch_bag "
      "JOIN bag ON bag.row = batch_bag.bag WHERE batch = ?");
  int bags = 0, contexts = 0;
  ContextRow context;
  BagRow bag;
  if (rows.with(batch).next()) rows >> context >> bag >> bags >> contexts;
  if (contexts == 1) sherd.context = context;
  if (bags == 1) sherd.bag = bag;
}

struct Followed {
  SherdRow row;
  ScanRow front, back;
  SherdState state = SherdState::Draft;
  std::string number, void_reason;
};

std::vector<Followed> sherdsOf(Database& database, BatchRow batch) {
  std::vector<Followed> all;
  Statement rows = database.sql(
      "SELECT row, front, back, state, number, void_reason FROM sherd WHERE batch = ? AND front IS "
      "NOT NULL");
  rows.with(batch);
  while (rows.next()) {
    Followed sherd;
    std::string state;
    rows >> sherd.row >> sherd.front >> sherd.back >> state >> sherd.number >> sherd.void_reason;
    sherd.state = fromWord<SherdState>(state);
    all.push_back(sherd);
  }
  return all;
}

constexpr const char* kNoPartner = "its front no longer has a back";

}  // namespace

void settleSherds(Catalogue& catalogue, BatchRow batch, const Provenance& provenance) {
  Database& database = catalogue.database();
  const std::vector<PairDecision> counts = valueOrThrow(catalogue.currentDecisions(batch));
  const auto accepted = [&](ScanRow front) -> const PairDecision* {
    for (const PairDecision& d : counts)
      if (d.verdict == Verdict::Accept && d.front == front) return &d;
    return nullptr;
  };
  std::set<ScanRow> known;
  const std::vector<Followed> sherds = sherdsOf(database, batch);
  // First the backs that were lost, so that each back belongs to one sherd at any moment.
  for (const Followed& sherd : sherds) {
    known.insert(sherd.front);
    const PairDecision* pair = accepted(sherd.front);
    const ScanRow back = pair ? pair->back : ScanRow{};
    if (sherd.back == back) continue;
    database.sql("UPDATE sherd SET back = NULL WHERE row = ?").with(sherd.row).run();
    forgetModel(catalogue, sherd.row, provenance);
  }
  for (const Followed& sherd : sherds) {
    const PairDecision* pair = accepted(sherd.front);
    const ScanRow back = pair ? pair->back : ScanRow{};
    if (back && sherd.back != back)
      database.sql("UPDATE sherd SET back = ? WHERE row = ?").with(back, sherd.row).run();
    if (sherd.back != back)
      remember(catalogue, provenance, "sherd", sherd.row.value, "back",
               sherd.back ? std::to_string(sherd.back.value) : "",
               back ? std::to_string(back.value) : "");
    // A draft comes and goes with its pair; a number stays with its front.
    const bool draft = sherd.number.empty();
    if (draft && !back && sherd.state == SherdState::Draft)
      valueOrThrow(catalogue.voidSherd(sherd.row, kNoPartner, provenance));
    if (draft && back && sherd.void_reason == kNoPartner) {
      const FieldChange revived{sherd.row, "void_reason", ""};
      valueOrThrow(catalogue.change(std::span(&revived, 1), provenance));
    }
  }
  for (const PairDecision& d : counts) {
    if (d.verdict != Verdict::Accept || known.contains(d.front)) continue;
    SherdRecord sherd;
    sherd.batch = batch;
    sherd.front = d.front;
    sherd.back = d.back;
    placeOfBatch(catalogue, batch, sherd);
    valueOrThrow(catalogue.addSherd(sherd, provenance));
  }
  database.sql("UPDATE scan SET state = 'open' WHERE batch = ? AND state <> 'open'")
      .with(batch)
      .run();
  for (const PairDecision& d : counts) {
    const bool sure = d.by || !d.ambiguous;
    const char* state = d.verdict == Verdict::Accept ? (sure ? "paired" : "open") : "aside";
    for (const ScanRow scan : {d.front, d.back})
      if (scan) database.sql("UPDATE scan SET state = ? WHERE row = ?").with(state, scan).run();
  }
  valueOrThrow(giveTypedNumbers(catalogue, batch, provenance));  // those that find no sherd wait
}

Result<DecisionRow> Catalogue::decide(const PairDecision& d, const Provenance& provenance) {
  return database_->inTransaction([&] {
    checkSide(*database_, d.batch, d.front, "front");
    checkSide(*database_, d.batch, d.back, "back");
    const bool pair = d.verdict == Verdict::Accept || d.verdict == Verdict::Reject;
    if (pair && !(d.front && d.back)) refuse("A pair needs a front and a back.");
    if (d.verdict == Verdict::Withdraw) {
      Statement row = database_->sql(
          "SELECT 1 FROM pair_decision WHERE row = ? AND batch = ? AND (person IS NULL) = ?");
      if (!row.with(d.replaces, d.batch, !provenance.person).next())
        refuse("The decision to undo is not in this batch.");
    } else if (!d.front && !d.back) {
      refuse("A decision needs a front, a back or both.");
    }
    PairDecision decided = d;
    decided.at_ms = now();
    decided.by = provenance.person;
    const DecisionRow row = insertDecision(*database_, decided, newId(now()));
    settleSherds(*this, d.batch, provenance);
    return row;
  });
}

Result<DecisionRow> restoreDecision(Catalogue& catalogue, const PairDecision& d,
                                    const std::string& id) {
  Database& database = catalogue.database();
  return database.inTransaction([&] {
    checkSide(database, d.batch, d.front, "front");
    checkSide(database, d.batch, d.back, "back");
    if (!isUuid(id)) refuse("The uuid of a decision is not well formed.", id);
    return insertDecision(database, d, id);
  });
}

Result<std::vector<PairDecision>> Catalogue::decisions(BatchRow batch) const {
  return database_->door([&] {
    std::vector<PairDecision> all;
    Statement rows = database_->sql(
        "SELECT row, batch, front, back, front_from_back, score, margin, fracture_rms_mm, "
        "fracture_overlap, "
        "ambiguous, person, verdict, replaces, note, at FROM pair_decision WHERE batch = ? "
        "ORDER "
        "BY row");
    rows.with(batch);
    while (rows.next()) {
      PairDecision d;
      std::string pose, verdict;
      rows >> d.row >> d.batch >> d.front >> d.back >> pose >> d.score >> d.margin >>
          d.fracture_rms_mm >> d.fracture_overlap >> d.ambiguous >> d.by >> verdict >> d.replaces >>
          d.note >> d.at_ms;
      d.front_from_back = poseFromText(pose);
      d.verdict = fromWord<Verdict>(verdict);
      all.push_back(std::move(d));
    }
    return all;
  });
}

Result<std::vector<PairDecision>> Catalogue::currentDecisions(BatchRow batch) const {
  Result<std::vector<PairDecision>> all = decisions(batch);
  if (!all) return all.error();
  return counting(*all);
}

}  // namespace ostraka::catalogue
