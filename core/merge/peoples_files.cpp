// What people said of a batch that both projects have: it is nowhere but in its files.
#include "batch/peoples_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "base/text.h"
#include "catalogue/settings.h"
#include "decisions/decisions.h"
#include "decisions/mask_strokes.h"
#include "files/open_folder.h"
#include "merge/merging.h"
#include "store/database.h"

namespace ostraka::merge {
namespace {

namespace fs = std::filesystem;
using decisions::Decisions, decisions::MaskStroke;
using Strokes = std::vector<MaskStroke>;

constexpr const char* kStrokes = "mask_strokes";  // what of a batch the conflict is about

using Text = std::optional<std::string>;  // none: there is no such file, or it stays as it is

// No link is followed.
Text textIn(const fs::path& project, const std::string& name) {
  const ContainedPath path = store::valueOrThrow(ContainedPath::parse(name));
  const OpenFolder folder = store::valueOrThrow(OpenFolder::open(project));
  if (!folder.has(path)) return {};
  OpenFile file = store::valueOrThrow(folder.read(path));
  return store::valueOrThrow(file.readAll(limits::kJsonBytes.most));
}

// Both lists; of what stands, the lost ones are withdrawn.
Decisions joinedDecisions(Decisions all, const Decisions& theirs,
                          const std::map<std::string, std::string>& withdrawn) {
  std::set<std::string> known;
  for (const decisions::PairDecision& decision : all) known.insert(decision.id);
  for (const decisions::PairDecision& decision : theirs)
    if (known.insert(decision.id).second) all.push_back(decision);
  for (const decisions::PairDecision& decision : decisions::standing(all)) {
    const auto lost = withdrawn.find(decision.id);
    if (lost == withdrawn.end()) continue;
    decisions::PairDecision withdrawal;
    withdrawal.id = lost->second;
    withdrawal.replaces = {decision.id};
    withdrawal.kind = decisions::DecisionKind::Withdraw;
    withdrawal.at = utcNow();
    withdrawal.by = "merge";
    all.push_back(std::move(withdrawal));
  }
  return all;
}

// How many there are, who painted last, and when.
Version strokesSeen(const Strokes& strokes) {
  Version version;
  version.values = {{kStrokes, std::to_string(strokes.size()) + ", " + strokes.back().at}};
  version.by = strokes.back().by;
  return version;
}

// What is refused when it is read is not written, either.
Text joinedLists(const Text& mine, const fs::path& here, const Text& theirs, const fs::path& there,
                 const std::map<std::string, std::string>& withdrawn) {
  const auto read = [](const Text& text, const fs::path& file) {
    return text ? store::valueOrThrow(decisions::parseDecisions(*text, file.string()))
                : Decisions();
  };
  const Decisions own = read(mine, here);
  const Decisions all = joinedDecisions(own, read(theirs, there), withdrawn);
  if (all.size() == own.size()) return {};
  Text text = decisions::textOf(all);
  (void)read(text, here);
  return text;
}

// The lists of strokes that a project once had and left, as its history tells.
class LeftLists {
 public:
  template <class Canonical>
  LeftLists(const std::vector<Event>& events, Canonical canonical) {
    for (const Event& event : events)
      if (event.table == "batch" && event.field.starts_with(decisions::kStrokesField))
        left_.insert(key(canonical(event.row), event.field, event.old_value));
  }
  bool has(const std::string& batch, const std::string& photograph, const Strokes& list) const {
    return left_.contains(
        key(batch, decisions::kStrokesField + photograph, decisions::hashOf(list)));
  }

 private:
  static std::string key(const std::string& batch, const std::string& field,
                         const std::string& hash) {
    return batch + " " + field + " " + hash;
  }
  std::set<std::string> left_;
};

// Photograph by photograph: a list that the other project had and left gives way; else the one
// holds that goes on where the other ends. None is lost unless a person took it away or settles it.
template <class Left, class Settle>
Text joinedStrokes(const Text& mine, const fs::path& here, const Text& theirs,
                   const fs::path& there, Left left, Settle settle) {
  const auto read = [](const Text& text, const fs::path& file) {
    return text ? store::valueOrThrow(decisions::parseMaskStrokes(*text, file.string()))
                : Strokes();
  };
  Strokes all = read(mine, here);
  auto in_a = decisions::byPhotograph(all), in_b = decisions::byPhotograph(read(theirs, there));
  for (const auto& [photograph, strokes] : in_a) in_b[photograph];  // all may be taken away
  bool changed = false;
  for (const auto& [photograph, of_b] : in_b) {
    const Strokes& of_a = in_a[photograph];
    if (of_a == of_b) continue;
    const std::string name = photograph.name();
    const bool a_left = left(Take::A, name, of_b), b_left = left(Take::B, name, of_a);
    const bool known = a_left != b_left;
    if (known ? a_left : decisions::goesOn(of_a, of_b)) continue;
    if (!known && !decisions::goesOn(of_b, of_a) && settle(name, of_a, of_b) != Take::B) continue;
    std::erase_if(
        all, [&, &on = photograph](const MaskStroke& s) { return decisions::paintedOn(s) == on; });
    all.insert(all.end(), of_b.begin(), of_b.end());
    changed = true;
  }
  if (!changed) return {};
  Text text = decisions::textOf(all);
  (void)read(text, here);
  return text;
}

// So that they are missed in A, too, when they are gone.
void knowStrokes(const catalogue::Catalogue& a, const std::string& batch,
                 const std::string& known) {
  store::valueOrThrow(catalogue::Settings(a).setValue(decisions::kKnownStrokes + batch, known));
}

}  // namespace

void Merging::mergePeoplesFiles() {
  const Table& batches = b_.table("batch");
  const LeftLists left_by_a(a_.events, [](const std::string& id) { return id; });
  const LeftLists left_by_b(b_.events, [this](const std::string& id) { return canonicalId(id); });
  for (const Row& row : batches.rows) {
    const std::string id = canonicalId(row.id);
    const std::string number = row.values[batches.column("number")].value_or("");
    if (fresh_batches_.contains(id)) {  // all of its files come
      const auto known = std::find_if(b_.settings.begin(), b_.settings.end(), [&](const auto& one) {
        return one.first == decisions::kKnownStrokes + number;
      });
      if (known != b_.settings.end()) knowStrokes(projects_.a, labelOf(id), known->second);
      continue;
    }
    const std::string from = "results/" + number + "/", to = "results/" + labelOf(id) + "/";
    for (const std::string file : batch::kPeoplesFiles) {
      Text& placed = outcome_.peoples_files[to + file];
      const Text theirs = textIn(projects_.b_folder, from + file),
                 mine = textIn(projects_.a_folder, to + file);
      if ((!theirs || mine == theirs) && outcome_.withdrawn.empty()) continue;
      const fs::path here = projects_.a_folder / (to + file),
                     there = projects_.b_folder / (from + file);
      if (file == batch::kDecisionsFile)
        placed = joinedLists(mine, here, theirs, there, outcome_.withdrawn);
      if (file == batch::kMaskStrokesFile)
        placed = joinedStrokes(
            mine, here, theirs, there,
            [&](Take by, const std::string& photograph, const Strokes& list) {
              return (by == Take::A ? left_by_a : left_by_b).has(id, photograph, list);
            },
            [&](const std::string& photograph, const Strokes& of_a, const Strokes& of_b) {
              return settleMasks({"masks/" + id + "/" + photograph,
                                  "batch",
                                  labelOf(id) + " " + photograph,
                                  kStrokes,
                                  strokesSeen(of_a),
                                  strokesSeen(of_b),
                                  {Take::A, Take::B}},
                                 id, decisions::hashOf(of_a), decisions::hashOf(of_b));
            });
      if (file == batch::kMaskStrokesFile && placed)
        knowStrokes(projects_.a, labelOf(id),
                    decisions::knownText(
                        store::valueOrThrow(decisions::parseMaskStrokes(*placed, here.string()))));
    }
  }
}

// The history names both lists by their hashes, since it does not tell of single strokes: what was
// settled holds for these two only, and in either direction.
Take Merging::settleMasks(Conflict conflict, const std::string& batch, const std::string& a,
                          const std::string& b) {
  const std::string& field = conflict.id;
  const auto said = [&](const Event* event) -> std::optional<Take> {
    if (event && event->old_value == b && event->new_value == a) return Take::A;
    if (event && event->old_value == a && event->new_value == b) return Take::B;
    return {};
  };
  const auto last = [&](const Touched& touched) -> std::optional<Take> {
    const auto row = touched.find(batch);
    if (row == touched.end()) return {};
    const auto event = row->second.find(field);
    return event == row->second.end() ? std::nullopt : said(event->second);
  };
  const std::optional<Take> in_a = last(touched_a_), in_b = last(touched_b_);
  if (in_a && (!in_b || in_a == in_b)) return *in_a;
  if (in_b && !in_a) return *in_b;
  if (!in_a)
    for (auto event = a_.events.rbegin(); event != a_.events.rend(); ++event)
      if (event->table == "batch" && event->row == batch && event->field == field)
        if (const std::optional<Take> known = said(&*event)) return *known;
  const Take take = settle(conflict);
  remember("batch", rows_.at(batch), field, take == Take::A ? b : a, take == Take::A ? a : b);
  return take;
}

}  // namespace ostraka::merge
