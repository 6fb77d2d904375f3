#include "upkeep/peoples_file_check.h"

#include <set>

#include "base/limits.h"
#include "batch/peoples_files.h"
#include "decisions/decisions.h"
#include "decisions/mask_strokes.h"
#include "store/database.h"

namespace ostraka::upkeep {
namespace {

std::optional<Damage> damageOfDecisions(const std::string& text, const std::string& path,
                                        std::set<std::string> ids) {
  const Result<decisions::Decisions> all = decisions::parseDecisions(text, path);
  if (!all) return Damage::Unreadable;
  for (const decisions::PairDecision& one : *all) ids.erase(one.id);
  return ids.empty() ? std::nullopt : std::optional(Damage::Changed);
}

std::optional<Damage> damageOfStrokes(const std::string& text, const std::string& path,
                                      const std::string& known) {
  const auto strokes = decisions::parseMaskStrokes(text, path);
  if (!strokes) return Damage::Unreadable;
  return decisions::haveKnown(*strokes, known) ? std::nullopt : std::optional(Damage::Changed);
}

// What the catalogue knows of a batch's files.
struct Known {
  std::set<std::string> decisions;
  std::string strokes;
  bool hasAnyIn(const std::string& file) const {
    return file == batch::kDecisionsFile ? !decisions.empty() : !decisions::haveKnown({}, strokes);
  }
};

std::optional<Damage> lookAtPeoplesFile(const std::string& path, const std::string& name,
                                        const Known& known, const OpenFolder& project) {
  const Result<ContainedPath> place = ContainedPath::parse(path);
  if (!place) return Damage::Unreadable;
  if (!project.has(*place))
    return known.hasAnyIn(name) ? std::optional(Damage::Missing) : std::nullopt;
  Result<OpenFile> file = project.read(*place);
  const Result<std::string> text = file ? file->readAll(limits::kJsonBytes.most) : file.error();
  if (!text) return Damage::Unreadable;
  return name == batch::kDecisionsFile ? damageOfDecisions(*text, path, known.decisions)
                                       : damageOfStrokes(*text, path, known.strokes);
}

}  // namespace

Result<std::vector<DamagedFile>> checkPeoplesFiles(const catalogue::Catalogue& catalogue,
                                                   const OpenFolder& project) {
  store::Database& database = catalogue.database();
  return database.asResult([&] {
    std::vector<DamagedFile> damaged;
    store::Statement batches = database.sql(
        "SELECT b.row, b.number, ifnull(s.value, '') FROM batch b LEFT JOIN setting s ON s.key = "
        "? || b.number WHERE s.value <> '' OR EXISTS (SELECT 1 FROM file f WHERE f.batch = b.row "
        "AND f.path GLOB 'results/' || b.number || '/*') ORDER BY b.number",
        std::string(decisions::kKnownStrokes));
    store::BatchRow row;
    Known known;
    for (std::string number; batches.read(row, number, known.strokes);) {
      const auto decided =
          database
              .sql(
                  "SELECT decision FROM (SELECT batch, decision, came_alone FROM pair_decision "
                  "UNION SELECT batch, decision, came_alone FROM piece_decision) WHERE batch = ? "
                  "AND decision <> '' AND came_alone = 0",
                  row)
              .all<std::string>();
      known.decisions = {decided.begin(), decided.end()};
      for (const std::string name : batch::kPeoplesFiles) {
        KnownFile file;
        file.path = "results/" + number + "/" + name;
        file.role = "report";
        file.batch = number;
        if (const auto damage = lookAtPeoplesFile(file.path, name, known, project))
          damaged.push_back({file, *damage});
      }
    }
    return damaged;
  });
}

}  // namespace ostraka::upkeep
