#include "sherds/pair_decisions.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/message.h"
#include "base/uuid.h"
#include "catalogue/history.h"
#include "files/json.h"
#include "files/json_text.h"
#include "records/sherd.h"
#include "records/words.h"
#include "sherds/kept_models.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_columns.h"
#include "sherds/sherds.h"
#include "sherds/typed_numbers.h"

namespace ostraka::sherds {
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

void checkSide(store::Database& database, store::BatchRow batch, store::ScanRow scan,
               const char* side) {
  if (!scan) return;
  store::Statement row = database.sql("SELECT 1 FROM scan WHERE row = ? AND batch = ? AND side = ?",
                                      scan, batch, side);
  if (!row.next())
    store::refuse(side == std::string_view("front")
                      ? message("The scan is not a front of this batch.")
                      : message("The scan is not a back of this batch."));
}

enum class DecisionsFile { HasIt, CameWithoutIt };

store::DecisionRow insertDecision(store::Database& database, const records::PairDecision& d,
                                  DecisionsFile file) {
  database.run(
      "INSERT INTO pair_decision (id, decision, came_alone, at, person, batch, front, back, "
      "front_from_back, "
      "score, margin, ambiguous, fracture_rms_mm, fracture_overlap, verdict, replaces, note) "
      "VALUES "
      "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      d.id, d.decision, file == DecisionsFile::CameWithoutIt, d.at_ms, d.by, d.batch, d.front,
      d.back, poseText(d.front_from_back), d.score, d.margin, d.ambiguous, d.fracture_rms_mm,
      d.fracture_overlap, records::wordOf(d.verdict), d.replaces, d.note);
  return {database.lastRow()};
}

using Pair = std::pair<store::ScanRow, store::ScanRow>;

// Persons before the program, later before earlier. Each scan is claimed once.
std::vector<records::PairDecision> counting(const std::vector<records::PairDecision>& all) {
  std::set<store::DecisionRow> withdrawn;
  std::vector<const records::PairDecision*> persons, program;
  for (auto it = all.rbegin(); it != all.rend(); ++it) {
    if (withdrawn.contains(it->row)) continue;
    if (it->verdict == records::Verdict::Withdraw)
      withdrawn.insert(it->replaces);
    else
      (it->by ? persons : program).push_back(&*it);
  }
  std::set<store::ScanRow> claimed;
  std::set<Pair> rejected;
  std::vector<records::PairDecision> counts;
  const auto free = [&](store::ScanRow scan) { return scan && !claimed.contains(scan); };
  for (const auto* list : {&persons, &program})
    for (const records::PairDecision* d : *list) {
      const Pair pair{d->front, d->back};
      if (d->verdict == records::Verdict::Reject) {
        const bool settled = claimed.contains(d->front) && claimed.contains(d->back);
        if (!settled) rejected.insert(pair);
        continue;
      }
      if (d->verdict == records::Verdict::Accept) {
        if (!free(d->front) || !free(d->back) || rejected.contains(pair)) continue;
        claimed.insert({d->front, d->back});
        counts.push_back(*d);
        continue;
      }
      records::PairDecision lone = *d;  // what is still free of it
      if (!free(lone.front)) lone.front = {};
      if (!free(lone.back)) lone.back = {};
      if (!lone.front && !lone.back) continue;
      if (lone.front) claimed.insert(lone.front);
      if (lone.back) claimed.insert(lone.back);
      counts.push_back(lone);
    }
  std::ranges::sort(counts, [](const records::PairDecision& a, const records::PairDecision& b) {
    return std::pair(a.front, a.back) < std::pair(b.front, b.back);
  });
  return counts;
}

// The context and the bag that all sherds of a batch share; none when they do not.
void placeOfBatch(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                  records::SherdRecord& sherd) {
  store::Statement rows = catalogue.database().sql(
      "SELECT min(bag.context), min(bag.row), count(*), count(DISTINCT bag.context) FROM batch_bag "
      "JOIN bag ON bag.row = batch_bag.bag WHERE batch = ?",
      batch);
  int bags = 0, contexts = 0;
  store::ContextRow context;
  store::BagRow bag;
  rows.read(context, bag, bags, contexts);
  if (contexts == 1) sherd.context = context;
  if (bags == 1) sherd.bag = bag;
}

struct Followed {
  store::SherdRow row;
  store::ScanRow front, back;
  records::SherdState state = records::SherdState::Draft;
  std::string number, void_reason;
};

std::vector<Followed> sherdsOf(store::Database& database, store::BatchRow batch) {
  using F = Followed;
  return database
      .sql(
          "SELECT row, front, back, state, number, void_reason FROM sherd WHERE batch = ? AND "
          "front IS NOT NULL",
          batch)
      .all(&F::row, &F::front, &F::back, &F::state, &F::number, &F::void_reason);
}

constexpr auto kNoPartner = translatable<0>("its front no longer has a back");

}  // namespace

Message voidReason(const std::string& reason) {
  return reason == kNoPartner.words() ? message(kNoPartner) : Message(reason);
}

void settleSherds(const catalogue::Catalogue& catalogue, store::BatchRow batch,
                  const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  const std::vector<records::PairDecision> counts =
      store::valueOrThrow(PairDecisions(catalogue).current(batch));
  const auto accepted = [&](store::ScanRow front) -> const records::PairDecision* {
    for (const records::PairDecision& d : counts)
      if (d.verdict == records::Verdict::Accept && d.front == front) return &d;
    return nullptr;
  };
  std::set<store::ScanRow> known;
  const std::vector<Followed> sherds = sherdsOf(database, batch);
  // First the backs that were lost, so that each back belongs to one sherd at any moment.
  for (const Followed& sherd : sherds) {
    known.insert(sherd.front);
    const records::PairDecision* pair = accepted(sherd.front);
    const store::ScanRow back = pair ? pair->back : store::ScanRow{};
    if (sherd.back == back) continue;
    database.run("UPDATE sherd SET back = NULL WHERE row = ?", sherd.row);
    forgetModel(catalogue, sherd.row, provenance);
  }
  for (const Followed& sherd : sherds) {
    const records::PairDecision* pair = accepted(sherd.front);
    const store::ScanRow back = pair ? pair->back : store::ScanRow{};
    if (back && sherd.back != back)
      database.run("UPDATE sherd SET back = ? WHERE row = ?", back, sherd.row);
    if (sherd.back != back)
      catalogue::remember(catalogue, provenance, "sherd", sherd.row.value, "back",
                          sherd.back ? std::to_string(sherd.back.value) : "",
                          back ? std::to_string(back.value) : "");
    // A draft comes and goes with its pair; a number stays with its front.
    const bool draft = sherd.number.empty();
    if (draft && !back && sherd.state == records::SherdState::Draft)
      store::valueOrThrow(Sherds(catalogue).voidSherd(sherd.row, kNoPartner.words(), provenance));
    if (draft && back && sherd.void_reason == kNoPartner.words()) {
      const records::FieldChange revived{sherd.row, "void_reason", ""};
      store::valueOrThrow(SherdChanges(catalogue).apply(std::span(&revived, 1), provenance));
    }
  }
  for (const records::PairDecision& d : counts) {
    if (d.verdict != records::Verdict::Accept || known.contains(d.front)) continue;
    records::SherdRecord sherd;
    sherd.batch = batch;
    sherd.front = d.front;
    sherd.back = d.back;
    placeOfBatch(catalogue, batch, sherd);
    store::valueOrThrow(Sherds(catalogue).add(sherd, provenance));
  }
  database.run("UPDATE scan SET state = 'open' WHERE batch = ? AND state <> 'open'", batch);
  for (const records::PairDecision& d : counts) {
    const bool sure = d.by || !d.ambiguous;
    const char* state =
        d.verdict == records::Verdict::Accept ? (sure ? "paired" : "open") : "aside";
    for (const store::ScanRow scan : {d.front, d.back})
      if (scan) database.run("UPDATE scan SET state = ? WHERE row = ?", state, scan);
  }
  store::valueOrThrow(
      giveTypedNumbers(catalogue, batch, provenance));  // those that find no sherd wait
}

Result<store::DecisionRow> PairDecisions::add(const records::PairDecision& d,
                                              const records::Provenance& provenance) {
  return database_->inTransaction([&] {
    checkSide(*database_, d.batch, d.front, "front");
    checkSide(*database_, d.batch, d.back, "back");
    const bool pair =
        d.verdict == records::Verdict::Accept || d.verdict == records::Verdict::Reject;
    if (pair && !(d.front && d.back)) store::refuse(message("A pair needs a front and a back."));
    if (d.verdict == records::Verdict::Withdraw) {
      store::Statement row = database_->sql(
          "SELECT 1 FROM pair_decision WHERE row = ? AND batch = ? AND (person IS NULL) = ?",
          d.replaces, d.batch, !provenance.person);
      if (!row.next()) store::refuse(message("The decision to undo is not in this batch."));
    } else if (!d.front && !d.back) {
      store::refuse(message("A decision needs a front, a back or both."));
    }
    records::PairDecision decided = d;
    decided.id = newId(now());
    decided.at_ms = now();
    decided.by = provenance.person;
    const store::DecisionRow row = insertDecision(*database_, decided, DecisionsFile::HasIt);
    settleSherds(catalogue_, d.batch, provenance);
    return row;
  });
}

Result<store::DecisionRow> restoreDecision(const catalogue::Catalogue& catalogue,
                                           const records::PairDecision& d) {
  store::Database& database = catalogue.database();
  return database.inTransaction([&] {
    checkSide(database, d.batch, d.front, "front");
    checkSide(database, d.batch, d.back, "back");
    if (d.replaces &&
        !database
             .sql("SELECT 1 FROM pair_decision WHERE row = ? AND batch = ?", d.replaces, d.batch)
             .next())
      store::refuse(message("The decision to undo is not in this batch."));
    for (const std::string& given : {d.id, d.decision.empty() ? d.id : d.decision})
      if (!isUuid(given))
        store::refuse(message("The uuid of a decision is not well formed."), given);
    return insertDecision(database, d, DecisionsFile::CameWithoutIt);
  });
}

Result<std::vector<records::PairDecision>> PairDecisions::all(store::BatchRow batch) const {
  return database_->asResult([&] {
    std::vector<records::PairDecision> all;
    store::Statement rows = database_->sql(
        "SELECT row, id, decision, batch, front, back, front_from_back, score, margin, "
        "fracture_rms_mm, fracture_overlap, ambiguous, person, verdict, replaces, note, at FROM "
        "pair_decision WHERE batch = ? ORDER BY row",
        batch);
    std::string pose;
    for (records::PairDecision d;
         rows.read(d.row, d.id, d.decision, d.batch, d.front, d.back, pose, d.score, d.margin,
                   d.fracture_rms_mm, d.fracture_overlap, d.ambiguous, d.by, d.verdict, d.replaces,
                   d.note, d.at_ms);) {
      d.front_from_back = poseFromText(pose);
      all.push_back(d);
    }
    return all;
  });
}

Result<std::vector<records::PairDecision>> PairDecisions::current(store::BatchRow batch) const {
  Result<std::vector<records::PairDecision>> all = this->all(batch);
  if (!all) return all.error();
  return counting(*all);
}

}  // namespace ostraka::sherds
