// Batches: their numbers, bags, scans, decisions and files; terms and settings.
#include <algorithm>

#include "base/text.h"
#include "catalogue/batches.h"
#include "catalogue/file_places.h"
#include "catalogue/settings.h"
#include "merge/merging.h"
#include "merge/staged_files.h"
#include "merge/told.h"
#include "sherds/sherd_columns.h"
#include "store/database.h"

namespace ostraka::merge {
namespace {

namespace fs = std::filesystem;

// "de: Rand, fr: bord"
std::string labelsIn(const std::string& json) {
  std::vector<std::string> labels;
  for (const auto& [language, label] : customFields(json))
    labels.push_back(language + ": " + textOf(label));
  return joined(labels, ", ");
}

}  // namespace

// The number that it has in B, or the project's next one, as for a batch that is imported.
void Merging::numberBatch(const Table& table, const Row& theirs, Values& values) {
  Value& number = values[table.column("number")];
  const std::string there = number.value_or("");
  bool taken = database_.sql("SELECT 1 FROM batch WHERE number = ?", there).next();
  for (const char* folder : catalogue::kFoldersOfBatches) {
    std::error_code failed;
    taken |= fs::exists(fs::symlink_status(projects_.a_folder / folder / there, failed));
  }
  if (taken) number = store::valueOrThrow(catalogue::Batches(projects_.a).nextNumber());
  folder_of_[there] = *number;
  if (*number != there) outcome_.renumbered[there] = *number;
  fresh_batches_.insert(theirs.id);
}

std::string Merging::placed(const std::string& path) const {
  for (const std::string folder : catalogue::kFoldersOfBatches) {
    if (!path.starts_with(folder)) continue;
    const std::size_t end = path.find('/', folder.size());
    if (end == std::string::npos) break;
    const auto found = folder_of_.find(path.substr(folder.size(), end - folder.size()));
    if (found != folder_of_.end()) return folder + found->second + path.substr(end);
  }
  return path;
}

// Batches of which A has scans that B does not know.
void Merging::noteOwnComputations() {
  std::set<std::string> known;
  const Table& scans = a_.table("scan");
  for (const Row& scan : b_.table("scan").rows) known.insert(canonicalId(scan.id));
  for (const Row& scan : scans.rows)
    if (!known.contains(scan.id))
      computed_in_a_.insert(scan.values[scans.column("batch")].value_or(""));
}

// A plate that each project computed for itself: the scans of A stay those of its results, those of
// B enter as of an earlier computation, and so do the sherds that were made from them.
void Merging::placeScan(const Table& table, const Row& theirs, Values& values) {
  const std::string batch = values[table.column("batch")].value_or("");
  const auto value = [&](const char* name) { return values[table.column(name)]; };
  if (fresh_batches_.contains(batch)) return;
  if (!computed_in_a_.contains(batch)) {
    computed_in_b_.insert(batch);
    return;
  }
  const auto row = database_.sql("SELECT ifnull(max(row), 0) + 1 FROM scan").one<std::int64_t>();
  const Table &batches = a_.table("batch"), &others = b_.table("batch");
  const Row* of_a = batches.find(batch);
  const Row* of_b = others.find(theirs.values[table.column("batch")].value_or(""));
  settle({"batch/" + batch + "/results",
          "batch",
          labelOf(batch),
          "results",
          of_a ? computed(batches, of_a->values) : Version(),
          of_b ? computed(others, of_b->values) : Version(),
          {Take::A}});
  demoted_[theirs.id] = value("name").value_or("");
  values[table.column("position")] = std::to_string(-row);
  values[table.column("name")] = value("name").value_or("") + "-earlier" + std::to_string(row);
}

// A bag that is one with another of the same batch is not there twice.
std::vector<std::string> Merging::bagsNow(const std::vector<std::string>& bags) const {
  std::vector<std::string> now;
  for (const std::string& bag : bags) {
    const std::string one = canonicalId(bag);
    const bool own = std::ranges::any_of(
        bags, [&](const std::string& other) { return other != bag && sameId(other) == one; });
    if (!own && std::ranges::find(now, one) == now.end()) now.push_back(one);
  }
  return now;
}

void Merging::mergeBags() {
  for (const Row& batch : b_.table("batch").rows) {
    const std::string id = canonicalId(batch.id);
    std::vector<std::string> theirs, mine = bagsNow(a_.bags[id]);
    if (const auto found = b_.bags.find(batch.id); found != b_.bags.end())
      theirs = bagsNow(found->second);
    if (theirs == mine) continue;
    const auto words = [&](const std::vector<std::string>& bags) {
      std::vector<std::string> rows;
      for (const std::string& bag : bags) rows.push_back(std::to_string(rows_.at(bag)));
      return joined(rows, "; ");
    };
    const auto version = [&](const std::vector<std::string>& bags) {
      Version named;
      for (const std::string& bag : bags)
        named.values.emplace_back("bag", wholeName(a_.table("bag"), bag));
      return named;
    };
    const Said said{"bags",          id,     {"bags"},    version(mine),
                    version(theirs), "bags", words(mine), words(theirs)};
    if (!fresh_batches_.contains(id) && decide(&a_.table("batch"), said) != Take::B) continue;
    database_.run("DELETE FROM batch_bag WHERE batch = ?", rows_.at(id));
    for (std::size_t i = 0; i < theirs.size(); ++i)
      database_.run("INSERT INTO batch_bag VALUES (?, ?, ?)", rows_.at(id),
                    static_cast<std::int64_t>(i), rows_.at(theirs[i]));
  }
}

FileCopy& Merging::addFile(const Table& table, const Values& values, const std::string& from) {
  const std::string to = values[table.column("path")].value_or("");
  const Value& batch = values[table.column("batch")];
  if (!catalogue::isRecordedPlace(to, batch ? labelOf(*batch) : std::string()))
    throw store::Refused(upkeep::notAPlaceOfFiles(to));
  FileCopy& copy = outcome_.copies[to];
  copy = {from, to, values[table.column("sha256")].value_or("")};
  return copy;
}

// Of a merge in which B lacked it, for example: the rows came, and the file did not.
void Merging::restoreFile(const Table& table, const Row& mine, const Row& theirs) {
  const std::size_t hash = table.column("sha256"), path = table.column("path");
  const std::string place = mine.values[path].value_or("");
  std::error_code failed;
  const Value& batch = mine.values[table.column("batch")];
  if (mine.values[hash] != theirs.values[hash] ||
      !catalogue::isRecordedPlace(place, batch ? labelOf(*batch) : std::string()) ||
      fs::exists(fs::symlink_status(projects_.a_folder / place, failed)))
    return;
  FileCopy& copy = outcome_.copies[place];
  copy = {theirs.values[path].value_or(""), place, theirs.values[hash].value_or("")};
  copy.restores = true;
}

// A term that one project took away goes, unless a sherd has it or the other project took it up
// again; one that it described otherwise is settled.
void Merging::mergeTerms() {
  compareHistories("vocabulary");
  copyEvents("vocabulary#0");
  const auto toldIn = [](const std::vector<const Event*>& since) {
    Told told;
    for (const Event* event : since) {
      if (event->field.find('/') != std::string::npos) continue;  // how one term is called
      tellMembers(*event, [&](const std::string& term, bool added) {
        told[{event->field, term}] = added;
      });
    }
    return told;
  };
  const Told in_a = toldIn(since_a_["vocabulary"]), in_b = toldIn(since_b_["vocabulary"]);
  const auto isUnused = [&](const std::pair<std::string, std::string>& term) {
    return store::valueOrThrow(
               catalogue::Settings(projects_.a).sherdsWith(term.first, term.second)) == 0;
  };
  std::map<std::pair<std::string, std::string>, const std::vector<std::string>*> mine;
  for (const std::vector<std::string>& term : a_.terms) mine[{term[0], term[1]}] = &term;
  std::set<std::pair<std::string, std::string>> theirs;
  for (const std::vector<std::string>& term : b_.terms) {
    theirs.emplace(term[0], term[1]);
    const auto found = mine.find({term[0], term[1]});
    if (found != mine.end()) {
      const std::vector<std::string>& own = *found->second;
      if (own[2] == term[2] && own[3] == term[3]) continue;
      const std::string name = term[0] + "/" + term[1];
      const std::string a = catalogue::toldTerm(own[2], own[3]),
                        b = catalogue::toldTerm(term[2], term[3]);
      const auto version = [](const std::vector<std::string>& said) {
        return Version{{{"labels", labelsIn(said[2])}, {"uri", said[3]}}};
      };
      if (decide(nullptr,
                 {name, "vocabulary#0", {name}, version(own), version(term), name, a, b}) ==
          Take::B)
        database_.run("UPDATE vocabulary SET labels = ?, uri = ? WHERE name = ? AND term = ?",
                      term[2], term[3], term[0], term[1]);
    } else if (!isGone(in_a, in_b, {term[0], term[1]}) || !isUnused({term[0], term[1]})) {
      database_.run(
          "INSERT INTO vocabulary SELECT ?1, ?2, ifnull(max(position), -1) + 1, ?3, ?4 FROM "
          "vocabulary WHERE name = ?1",
          term[0], term[1], term[2], term[3]);
    }
  }
  for (const auto& [term, row] : mine)
    if (!theirs.contains(term) && isGone(in_b, in_a, term) && isUnused(term))
      database_.run("DELETE FROM vocabulary WHERE name = ? AND term = ?", term.first, term.second);
}

void Merging::mergeProject() {
  if (a_.project_id != b_.project_id) return;  // two projects: each has a name of its own
  compareHistories("project");
  copyEvents("project#1");
  const records::ProjectRecord mine =
                                   store::valueOrThrow(catalogue::Settings(projects_.a).project()),
                               theirs =
                                   store::valueOrThrow(catalogue::Settings(projects_.b).project());
  records::ProjectRecord merged = mine;
  bool differs = false;
  struct Field {
    const char* name;
    std::string records::ProjectRecord::*value;
  };
  using P = records::ProjectRecord;
  Table project;
  project.name = "project";
  for (const Field& field :
       {Field{"code", &P::code}, Field{"title", &P::title}, Field{"institution", &P::institution},
        Field{"licence", &P::licence}, Field{"rights_holder", &P::rights_holder},
        Field{"numbering", &P::numbering}, Field{"word_for_context", &P::word_for_context}}) {
    const std::string &a = mine.*field.value, &b = theirs.*field.value;
    if (a != b && decide(&project, saidText(field.name, "project#1", a, b)) == Take::B) {
      merged.*field.value = b;
      differs = true;
    }
  }
  if (outcome_.unsettled() || !differs) return;
  store::valueOrThrow(catalogue::Settings(projects_.a).setProject(merged, provenance_));
}

// Settings are those of a house and its computer, but for what people said of a batch: the numbers
// that they typed on its plate, and that they keep it beside one of the same photographs.
void Merging::mergeSettings() {
  for (const auto& [key, value] : b_.settings) {
    if (key.starts_with(kSameRow) && rows_.contains(sameId(value)) &&
        key != kSameRow + sameId(value))
      database_.run("INSERT OR IGNORE INTO setting VALUES (?, ?)", key, sameId(value));
    for (const std::string of_batch : {sherds::kTypedNumbers, catalogue::kKeptTwice}) {
      if (!key.starts_with(of_batch)) continue;
      const auto batch = folder_of_.find(key.substr(of_batch.size()));
      if (batch == folder_of_.end()) continue;
      const std::string own = of_batch + batch->second;
      if (!database_.sql("SELECT 1 FROM setting WHERE key = ?", own).next())
        store::valueOrThrow(catalogue::Settings(projects_.a).setValue(own, value, provenance_));
    }
  }
}

bool Merging::isOfResults(const Table& table, const Values& values,
                          const std::set<std::string>& batches) {
  return table.name == "file" && batches.contains(values[table.column("batch")].value_or("")) &&
         values[table.column("path")].value_or("").starts_with("results/");
}

void Merging::finishBatches() {
  const Table& batches = b_.table("batch");
  std::string incomplete;  // numbers of A
  for (const auto& [key, value] : a_.settings)
    if (key == kIncompleteBatches) incomplete = value;
  for (const Row& batch : batches.rows) {
    const std::string& id = batch.id;
    const std::string there = batch.values[batches.column("number")].value_or(""),
                      here = labelOf(id);
    if (fresh_batches_.contains(id)) {
      for (const std::string folder : {"batches/", "results/"})
        outcome_.files_of[folder + there] = folder + here;
      continue;
    }
    if ((incomplete + " ").find(here + " ") != std::string::npos) {
      outcome_.incomplete["batches/" + there] = "batches/" + here;
      if (!computed_in_a_.contains(id)) outcome_.incomplete["results/" + there] = "results/" + here;
    }
    if (computed_in_b_.contains(id) && !computed_in_a_.contains(id))
      outcome_.files_of["results/" + there] = "results/" + here;
    if (decided_in_b_.contains(id) && !outcome_.unsettled())
      sherds::settleSherds(projects_.a, store::BatchRow{rows_.at(id)}, provenance_);
  }
}

}  // namespace ostraka::merge
