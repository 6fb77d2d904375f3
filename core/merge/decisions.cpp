// Decisions of persons about pairs and pieces: all of them come together, and what two persons
// decided differently about one scan is settled by withdrawing what one of them decided.
#include <nlohmann/json.hpp>

#include "base/uuid.h"
#include "catalogue/catalogue.h"
#include "files/json_text.h"
#include "merge/merging.h"
#include "records/words.h"
#include "sherds/pair_decisions.h"
#include "store/database.h"

namespace ostraka::merge {
namespace {

using Decided = std::map<std::string, std::vector<const Row*>>;  // by batch

// Decisions of persons that only one of the projects has.
Decided onlyIn(const Table& here, const Table& there) {
  Decided decided;
  const std::size_t batch = here.column("batch"), person = here.column("person");
  for (const Row& row : here.rows)
    if (row.values[person] && !there.by_id.contains(row.id))
      decided[row.values[batch].value_or("")].push_back(&row);
  return decided;
}

// The scans that it is about; for a withdrawal those of what it withdraws.
std::set<std::string> scansOf(const Table& table, const Row& decision) {
  const Row* about = &decision;
  if (const Value& replaces = decision.values[table.column("replaces")];
      replaces && decision.values[table.column("verdict")] == "withdraw")
    if (const Row* earlier = table.find(*replaces)) about = earlier;
  std::set<std::string> scans;
  for (const char* side : {"front", "back"})
    if (const Value& scan = about->values[table.column(side)]) scans.insert(*scan);
  return scans;
}

std::map<std::string, std::vector<const Row*>> byScan(const Table& table,
                                                      const std::vector<const Row*>& decisions) {
  std::map<std::string, std::vector<const Row*>> by_scan;
  for (const Row* decision : decisions)
    for (const std::string& scan : scansOf(table, *decision)) by_scan[scan].push_back(decision);
  return by_scan;
}

std::string namesIn(const std::string& pieces) {
  std::string names;
  for (const nlohmann::json& piece : jsonOrDiscarded(pieces))
    if (piece.is_object() && piece.contains("name") && piece["name"].is_string())
      names += (names.empty() ? "" : " ") + piece["name"].get<std::string>();
  return names;
}

}  // namespace

// Who decided it last, and when.
Version Merging::decided(std::vector<std::pair<std::string, std::string>> verdicts,
                         const Table& table, const std::vector<const Row*>& rows) const {
  std::erase_if(verdicts, [](const auto& verdict) { return verdict.first.empty(); });
  Version version{std::move(verdicts)};
  for (const Row* row : rows) stampRow(version, table, row->values, "person", "at");
  return version;
}

void Merging::comparePairs() {
  const Table &mine = a_.table("pair_decision"), &theirs = b_.table("pair_decision");
  const Decided in_a = onlyIn(mine, theirs), in_b = onlyIn(theirs, mine);
  // What holds of each scan: the verdict, and the scans that it is about.
  const auto holds = [&](const catalogue::Catalogue& catalogue, const Table& scans,
                         std::int64_t batch) {
    std::map<std::string, std::pair<std::string, std::string>> words;
    const auto idOf = [&](store::ScanRow scan) {
      const auto found = scans.by_row.find(scan.value);
      return found == scans.by_row.end() ? std::string()
                                         : canonicalId(scans.rows[found->second].id);
    };
    for (const records::PairDecision& decision :
         store::valueOrThrow(sherds::PairDecisions(catalogue).current(store::BatchRow{batch}))) {
      const std::string front = idOf(decision.front), back = idOf(decision.back);
      std::string about;
      for (const std::string& scan : {front, back})
        if (!scan.empty()) about += (about.empty() ? "" : " ") + labelOf(scan);
      for (const std::string& scan : {front, back})
        if (!scan.empty()) words[scan] = {records::wordOf(decision.verdict), about};
    }
    return words;
  };
  for (const auto& [batch, decisions] : in_b) {
    if (fresh_batches_.contains(batch)) continue;
    decided_in_b_.insert(batch);
    const auto others = in_a.find(batch);
    if (others == in_a.end()) continue;
    const Table& batches = b_.table("batch");
    auto a = holds(projects_.a, a_.table("scan"), rows_.at(batch));
    auto b = holds(projects_.b, b_.table("scan"), batches.find(batch)->row);
    const auto by_a = byScan(mine, others->second);
    std::map<std::string, std::vector<const Row*>> by_b;
    for (const auto& [scan, of_b] : byScan(theirs, decisions)) by_b[canonicalId(scan)] = of_b;
    for (const auto& [scan, of_b] : by_b) {
      const auto of_a = by_a.find(scan);
      if (of_a == by_a.end() || a[scan] == b[scan]) continue;
      const Take take = settle({"pair/" + scan,
                                mine.name,
                                labelOf(batch),
                                labelOf(scan),
                                decided({a[scan]}, mine, of_a->second),
                                decided({b[scan]}, theirs, of_b),
                                {Take::A, Take::B}});
      for (const Row* loser : take == Take::A ? of_b : of_a->second)
        losers_.emplace_back("pair_decision", loser->id);
    }
  }
}

void Merging::comparePieces() {
  const Table &mine = a_.table("piece_decision"), &theirs = b_.table("piece_decision");
  const Decided in_a = onlyIn(mine, theirs), in_b = onlyIn(theirs, mine);
  const auto verdictsOf = [](const Table& table, const std::vector<const Row*>& decisions,
                             const std::string& side) {
    std::vector<std::pair<std::string, std::string>> verdicts;
    for (const Row* decision : decisions)
      if (decision->values[table.column("side")] == side)
        verdicts.emplace_back(decision->values[table.column("verdict")].value_or(""),
                              decision->values[table.column("pieces")].value_or(""));
    return verdicts;
  };
  for (const auto& [batch, decisions] : in_b) {
    if (fresh_batches_.contains(batch)) continue;
    decided_in_b_.insert(batch);
    const auto others = in_a.find(batch);
    if (others == in_a.end()) continue;
    for (const char* side : {"front", "back"}) {
      auto a = verdictsOf(mine, others->second, side), b = verdictsOf(theirs, decisions, side);
      if (a.empty() || b.empty() || a == b) continue;
      for (auto* verdicts : {&a, &b})
        for (auto& [verdict, pieces] : *verdicts) pieces = namesIn(pieces);
      const Take take = settle({"pieces/" + batch + "/" + side,
                                mine.name,
                                labelOf(batch),
                                side,
                                decided(a, mine, others->second),
                                decided(b, theirs, decisions),
                                {Take::A, Take::B}});
      for (const Row* loser : take == Take::A ? decisions : others->second)
        if (loser->values[mine.column("side")] == side)
          losers_.emplace_back("piece_decision", loser->id);
    }
  }
}

// Rows are only added: what lost is withdrawn, for everybody to see.
void Merging::withdrawLosers() {
  std::set<std::pair<std::string, std::string>> done;
  for (const auto& loser : losers_) {
    if (!done.insert(loser).second) continue;
    const auto& [table, id] = loser;
    const std::string withdrawal = newId(projects_.a.now());
    const std::string extra = table == "piece_decision" ? ", side" : "";
    const auto in_file =
        database_.sql("SELECT decision FROM " + table + " WHERE id = ?", id).one<std::string>();
    database_.run("INSERT INTO " + table +
                      " (id, decision, came_alone, at, batch, verdict, replaces, note" + extra +
                      ") SELECT ?1, CASE decision WHEN '' THEN '' ELSE ?1 END, came_alone, ?2, "
                      "batch, 'withdraw', row, 'settled when two projects were merged'" +
                      extra + " FROM " + table + " WHERE id = ?3",
                  withdrawal, projects_.a.now(), id);
    if (!in_file.empty()) outcome_.withdrawn[in_file] = withdrawal;
    ++outcome_.added;
  }
}

}  // namespace ostraka::merge
