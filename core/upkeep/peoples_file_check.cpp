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

std::optional<Damage> lookAtPeoplesFile(const std::string& path, const std::set<std::string>& ids,
                                        const OpenFolder& project) {
  const Result<ContainedPath> place = ContainedPath::parse(path);
  if (!place) return Damage::Unreadable;
  if (!project.has(*place)) return ids.empty() ? std::nullopt : std::optional(Damage::Missing);
  Result<OpenFile> file = project.read(*place);
  const Result<std::string> text = file ? file->readAll(limits::kJsonBytes.most) : file.error();
  if (!text) return Damage::Unreadable;
  if (path.ends_with(batch::kDecisionsFile)) return damageOfDecisions(*text, path, ids);
  return decisions::parseMaskStrokes(*text, path) ? std::nullopt
                                                  : std::optional(Damage::Unreadable);
}

}  // namespace

Result<std::vector<DamagedFile>> checkPeoplesFiles(const catalogue::Catalogue& catalogue,
                                                   const OpenFolder& project) {
  store::Database& database = catalogue.database();
  return database.asResult([&] {
    std::vector<DamagedFile> damaged;
    store::Statement batches = database.sql(
        "SELECT b.row, b.number FROM batch b WHERE EXISTS (SELECT 1 FROM file f WHERE f.batch = "
        "b.row AND f.path GLOB 'results/' || b.number || '/*') ORDER BY b.number");
    store::BatchRow row;
    for (std::string number; batches.read(row, number);) {
      // Decisions that came with an export are older than their batch is here; no file has them.
      const auto decided =
          database
              .sql(
                  "SELECT decision FROM (SELECT batch, decision, at FROM pair_decision UNION "
                  "SELECT batch, decision, at FROM piece_decision) d JOIN batch b ON b.row = "
                  "d.batch WHERE b.row = ? AND decision <> '' AND at >= b.created_at",
                  row)
              .all<std::string>();
      for (const std::string name : batch::kPeoplesFiles) {
        KnownFile file;
        file.path = "results/" + number + "/" + name;
        file.role = "report";
        file.batch = number;
        std::set<std::string> ids;
        if (name == batch::kDecisionsFile) ids.insert(decided.begin(), decided.end());
        if (const std::optional<Damage> damage = lookAtPeoplesFile(file.path, ids, project))
          damaged.push_back({file, *damage});
      }
    }
    return damaged;
  });
}

}  // namespace ostraka::upkeep
