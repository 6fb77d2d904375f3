#include "upkeep/staged_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/limits.h"
#include "base/message.h"
#include "batch/peoples_files.h"
#include "catalogue/file_places.h"
#include "catalogue/settings.h"
#include "decisions/change_peoples_file.h"
#include "decisions/decisions.h"
#include "decisions/mask_strokes.h"
#include "files/checksum.h"
#include "files/files.h"
#include "files/folder_lock.h"
#include "files/json_text.h"
#include "files/output_place.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJournal = "merge.files";

Result<StagedFiles> notedFiles(const catalogue::Catalogue& catalogue) {
  const Result<std::string> text = catalogue::Settings(catalogue).value(kJournal);
  if (!text) return text.error();
  const nlohmann::json journal = jsonOrDiscarded(*text);
  StagedFiles files;
  if (!journal.is_object()) return files;
  for (const auto& [to, file] : journal.items())
    if (file.is_array() && file.size() == 2 && file[0].is_string() && file[1].is_string())
      files[to] = {file[0].get<std::string>(), file[1].get<std::string>()};
  return files;
}

// "results/B0031" of any file in it.
std::string folderOfPlace(const std::string& place) {
  return place.substr(0, place.find('/', place.find('/') + 1));
}

bool isPeoplesFile(const std::string& place) {
  return place.starts_with("results/") &&
         std::any_of(
             std::begin(batch::kPeoplesFiles), std::end(batch::kPeoplesFiles),
             [&](const std::string& name) { return place == folderOfPlace(place) + "/" + name; });
}

template <class List, class Same>
List joinedBehind(List mine, const List& theirs, Same same) {
  for (const auto& one : theirs)
    if (std::none_of(mine.begin(), mine.end(), [&](const auto& own) { return same(own, one); }))
      mine.push_back(one);
  return mine;
}

// Nothing that was decided or painted meanwhile is lost, nor what the merge brings.
Result<std::string> joinedTexts(catalogue::Catalogue& catalogue, const std::string& place,
                                const std::string& mine, const std::string& theirs) {
  if (place.ends_with(batch::kDecisionsFile)) {
    const auto own = decisions::parseDecisions(mine, place),
               staged = decisions::parseDecisions(theirs, place);
    if (!own) return own.error();
    if (!staged) return staged.error();
    return decisions::textOf(
        joinedBehind(*own, *staged, [](const auto& a, const auto& b) { return a.id == b.id; }));
  }
  const auto own = decisions::parseMaskStrokes(mine, place),
             staged = decisions::parseMaskStrokes(theirs, place);
  if (!own) return own.error();
  if (!staged) return staged.error();
  const auto all = joinedBehind(*own, *staged, [](const auto& a, const auto& b) { return a == b; });
  std::string text = decisions::textOf(all);
  if (const auto good = decisions::parseMaskStrokes(text, place); !good) return good.error();
  const std::string batch = fs::path(place).parent_path().filename().string();
  if (const Result<void> known = catalogue::Settings(catalogue).setValue(
          decisions::kKnownStrokes + batch, decisions::knownText(all));
      !known)
    return known.error();
  return text;
}

Result<std::string> textAt(const OpenFolder& project, const ContainedPath& place) {
  if (!project.has(place)) return std::string();
  Result<OpenFile> file = project.read(place);
  return file ? file->readAll(limits::kJsonBytes.most) : file.error();
}

struct WaitingFile {
  ContainedPath from, to;
  StagedFile staged;
  bool changed = false;  // what lies in its place
};

// The joined text takes the place of the staged one first, so that no link is followed.
Result<void> joinPeoplesFile(catalogue::Catalogue& catalogue, const OpenFolder& project,
                             const WaitingFile& file) {
  const Result<std::string> mine = textAt(project, file.to), theirs = textAt(project, file.from);
  if (!mine) return mine.error();
  if (!theirs) return theirs.error();
  const Result<std::string> joined = joinedTexts(catalogue, file.to.text(), *mine, *theirs);
  if (!joined) return joined.error();
  return writeFileAtomically(project.path() / file.from.text(), *joined);
}

// While nobody decides or paints: what was written since it was last read is joined, too. False:
// what lies there cannot be read, and is not replaced.
Result<bool> placePeoplesFile(catalogue::Catalogue& catalogue, const OpenFolder& project,
                              const WaitingFile& file) {
  const fs::path output = project.path() / folderOfPlace(file.to.text());
  if (const Result<void> own = checkNoLinkInProject(output); !own) return own.error();
  bool readable = true;
  const Result<void> placed = decisions::changePeoplesFile(output, [&]() -> Result<void> {
    const Result<std::string> there = sha256At(project, file.to, {});
    if (!there) return there.error();
    if (!there->empty() && *there != file.staged.over) {
      const Result<void> joined = joinPeoplesFile(catalogue, project, file);
      readable = joined || joined.error().code == ErrorCode::CannotWrite;
      if (!joined) return joined;
    }
    return project.move(file.from, file.to);
  });
  if (!readable) return false;
  return placed ? Result<bool>(true) : placed.error();
}

}  // namespace

Error notAPlaceOfFiles(const std::string& path) {
  return Error::unusable(
      message("Not a location of photographs, results, models or imported files, "
              "the only files that a merge writes; nothing was merged."),
      path);
}

Result<std::string> sha256At(const OpenFolder& project, const ContainedPath& place,
                             const std::stop_token& stop) {
  if (!project.has(place)) return std::string();
  Result<OpenFile> there = project.read(place);
  if (!there) return there.error();
  Result<Checksum> sum = checksumOf(*there, stop);
  if (!sum) return sum.error();
  return std::move(sum->sha256);
}

Result<void> noteStaged(catalogue::Catalogue& catalogue, const StagedFiles& files) {
  if (files.empty())
    return catalogue.database().inTransaction([&] {
      catalogue.database().sql("DELETE FROM setting WHERE key = ?").with(kJournal).run();
    });
  nlohmann::json journal = nlohmann::json::object();
  for (const auto& [to, file] : files) journal[to] = nlohmann::json::array({file.name, file.over});
  return catalogue::Settings(catalogue).setValue(kJournal, journal.dump());
}

Result<std::vector<std::string>> placeStaged(catalogue::Catalogue& catalogue,
                                             const fs::path& project, Progress& progress,
                                             const std::stop_token& stop) {
  const Result<StagedFiles> noted = notedFiles(catalogue);
  if (!noted) return noted.error();
  if (noted->empty()) return std::vector<std::string>();
  const Result<OpenFolder> folder = OpenFolder::open(project);
  if (!folder) return folder.error();
  std::vector<WaitingFile> waiting;
  StagedFiles unplaced;
  std::set<std::string> kept, left;
  const auto leave = [&](const std::string& to, const StagedFile& file, const Error& why) {
    unplaced[to] = file;
    left.insert(to);
    progress.note(
        NoteLevel::Warning,
        about(to, inOne(why.what, message("It belongs to a merge and waits in %1; moving it to its "
                                          "place is tried again whenever the project is opened.",
                                          (project / kStagingFolder / file.name).string()))));
  };
  // The journal may have come with a project from elsewhere.
  for (const auto& [to, file] : *noted) {
    const Result<ContainedPath> place = ContainedPath::parse(to),
                                from = ContainedPath::parse(std::string(kStagingFolder) + "/" +
                                                            file.name);
    if (!place) return place.error();
    if (!from) return from.error();
    if (!catalogue::isPlaceOfFiles(to)) return notAPlaceOfFiles(to);
    if (!folder->has(*from)) continue;  // it has its place
    const Result<std::string> there = sha256At(*folder, *place, stop);
    if (!there && there.error().code == ErrorCode::Cancelled) return there.error();
    if (!there) {
      leave(to, file, there.error());
      continue;
    }
    waiting.push_back({*from, *place, file, !there->empty() && *there != file.over});
    if (waiting.back().changed && !isPeoplesFile(to)) kept.insert(folderOfPlace(to));
  }
  for (const WaitingFile& file : waiting) {
    const std::string to = file.to.text();
    if (isPeoplesFile(to)) {
      const Result<bool> placed = placePeoplesFile(catalogue, *folder, file);
      if (!placed) leave(to, file.staged, placed.error());
      if (placed && !*placed) kept.insert(to);
      continue;
    }
    if (kept.contains(folderOfPlace(to))) continue;
    if (const Result<void> moved = folder->move(file.from, file.to); !moved)
      leave(to, file.staged, moved.error());
  }
  if (const Result<void> noted_again = noteStaged(catalogue, unplaced); !noted_again)
    return noted_again.error();
  std::error_code ignored;
  if (unplaced.empty()) fs::remove_all(project / kStagingFolder, ignored);
  for (const std::string& one : kept)
    progress.note(NoteLevel::Warning,
                  about(one, message("This changed while a merge was being completed, so it was "
                                     "kept, but the catalogue has what was merged. Reprocess the "
                                     "batch.")));
  kept.merge(left);
  return std::vector<std::string>(kept.begin(), kept.end());
}

Result<void> checkNoneWaits(const catalogue::Catalogue& catalogue, const fs::path& project) {
  const Result<StagedFiles> noted = notedFiles(catalogue);
  if (!noted) return noted.error();
  if (noted->empty()) return {};
  return Error::unusable(
      message("A file of an earlier merge cannot be moved to its place, %1. Make it possible (move "
              "away what lies there, or copy the project to another disk), or delete the file; "
              "then merge again.",
              noted->begin()->first),
      (project / kStagingFolder / noted->begin()->second.name).string());
}

Result<std::vector<std::string>> finishMerge(catalogue::Catalogue& catalogue,
                                             const fs::path& project,
                                             const store::Waiting& waiting) {
  const Result<StagedFiles> noted = notedFiles(catalogue);
  if (!noted) return noted.error();
  if (noted->empty()) return std::vector<std::string>();
  QuietProgress quiet;
  Progress& progress = waiting.progress != nullptr ? *waiting.progress : quiet;
  const Result<FolderLock> alone = FolderLock::waitFor(
      project,
      message("Another import into this project is running; this one waits until it has finished."),
      progress, waiting.stop);
  if (!alone) return alone.error();
  return placeStaged(catalogue, project, progress, waiting.stop);
}

}  // namespace ostraka::upkeep
