#include "merge/staged_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "catalogue/settings.h"
#include "files/checksum.h"
#include "files/files.h"
#include "files/folder_lock.h"
#include "files/json_text.h"
#include "store/database.h"

namespace ostraka::merge {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "merge.partial";
constexpr const char* kJournal = "merge.files";

Error unlikeInB(const std::string& path) {
  return Error::unusable(
      message("This file of project B differs from what its catalogue records; nothing was merged. "
              "Restore it from a copy ('ostraka catalogue check' lists all such files)."),
      path);
}

// Nothing is there, or what may go. An error: a file that nobody gave up.
Result<bool> isToBeWritten(const OpenFolder& project, const ContainedPath& place,
                           const FileCopy& file, const std::string& sha256,
                           const std::stop_token& stop) {
  if (file.replaces || !project.has(place)) return true;
  Result<OpenFile> there = project.read(place);
  if (!there) return there.error();
  const Result<Checksum> sum = checksumOf(*there, stop);
  if (!sum) return sum.error();
  if (sum->sha256 == sha256) return false;
  return Error::unusable(message("Project A has another file with this name, which its catalogue "
                                 "does not list; nothing was merged. Move that file elsewhere."),
                         there->name());
}

}  // namespace

Error notAPlaceOfFiles(const std::string& path) {
  return Error::unusable(
      message("Not a location of photographs, results, models or imported files, "
              "the only files that a merge writes; nothing was merged."),
      path);
}

bool isPlaceOfFiles(const std::string& path) {
  return path.starts_with("imported/") ||
         std::any_of(std::begin(kFoldersOfBatches), std::end(kFoldersOfBatches),
                     [&](const char* folder) { return path.starts_with(folder); });
}

Result<StagedFiles> StagedFiles::begin(catalogue::Catalogue& catalogue, const fs::path& project) {
  StagedFiles files(project);
  const Result<std::string> journal = catalogue::Settings(catalogue).value(kJournal);
  if (!journal) return journal.error();
  const nlohmann::json json = jsonOrDiscarded(*journal);
  if (json.is_object())
    for (const auto& [to, name] : json.items())
      if (name.is_string()) files.staged_[to] = name.get<std::string>();
  if (Result<void> done = files.finish(catalogue); !done) return done.error();
  return StagedFiles(project);
}

std::string StagedFiles::nextName() {
  return std::to_string(++names_);
}

Result<void> StagedFiles::copy(const fs::path& b, const std::vector<FileCopy>& files,
                               Progress& progress, const std::stop_token& stop) {
  if (files.empty()) return {};
  if (const Result<void> made = makeFolder(project_ / kFolder); !made) return made;
  const Result<OpenFolder> from = OpenFolder::open(b), to = OpenFolder::open(project_ / kFolder),
                           project = OpenFolder::open(project_);
  if (!from) return from.error();
  if (!to) return to.error();
  if (!project) return project.error();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(static_cast<std::int64_t>(i), static_cast<std::int64_t>(files.size()));
    const Result<ContainedPath> path = ContainedPath::parse(files[i].from),
                                place = ContainedPath::parse(files[i].to);
    if (!path) return path.error();
    if (!place) return place.error();
    if (!from->has(*path)) {
      missing_.push_back(files[i].from);
      continue;
    }
    Result<OpenFile> file = from->read(*path);
    if (!file) return file.error();
    const std::string name = nextName();
    const ContainedPath staged = *ContainedPath::parse(name);
    Result<NewFile> copy = to->create(staged);
    if (!copy) return copy.error();
    const Result<Checksum> sum =
        checksumOf(*file, stop, [&](std::string_view bytes) { return copy->write(bytes); });
    if (!sum) return sum.error();
    if (!files[i].sha256.empty() && files[i].sha256 != sum->sha256)
      return unlikeInB((b / files[i].from).string());
    const Result<bool> needed = isToBeWritten(*project, *place, files[i], sum->sha256, stop);
    if (!needed) return needed.error();
    if (!*needed) continue;
    if (const Result<void> whole = copy->finish(); !whole) return whole;
    Result<OpenFile> written = to->read(staged);
    if (!written) return written.error();
    const Result<Checksum> back = checksumOf(*written, stop);
    if (!back) return back.error();
    if (back->sha256 != sum->sha256)
      return Error{ErrorCode::CannotWrite,
                   message("The disk does not return what was written to it; nothing was merged. "
                           "Check the disk."),
                   (project_ / kFolder / name).string()};
    staged_[files[i].to] = name;
    bytes_ += sum->bytes;
  }
  return {};
}

Result<void> StagedFiles::put(const std::string& to, const std::string& bytes) {
  const std::string name = nextName();
  if (const Result<void> written = writeFileAtomically(project_ / kFolder / name, bytes); !written)
    return written;
  staged_[to] = name;
  bytes_ += static_cast<std::int64_t>(bytes.size());
  return {};
}

Result<void> StagedFiles::note(catalogue::Catalogue& catalogue) const {
  if (staged_.empty()) return {};
  return catalogue::Settings(catalogue).setValue(kJournal, nlohmann::json(staged_).dump());
}

Result<void> StagedFiles::finish(catalogue::Catalogue& catalogue) {
  // The journal may have come with a stranger's project.
  const Result<OpenFolder> project = OpenFolder::open(project_);
  if (!project) return project.error();
  for (const auto& [to, name] : staged_) {
    const Result<ContainedPath> place = ContainedPath::parse(to),
                                from = ContainedPath::parse(std::string(kFolder) + "/" + name);
    if (!place) return place.error();
    if (!from) return from.error();
    if (!isPlaceOfFiles(to)) return notAPlaceOfFiles(to);
    if (!project->has(*from)) continue;  // it has its place
    if (const Result<void> moved = project->move(*from, *place); !moved) return moved;
  }
  if (!staged_.empty())
    if (const Result<void> forgotten = catalogue.database().inTransaction(
            [&] { catalogue.database().run("DELETE FROM setting WHERE key = ?", kJournal); });
        !forgotten)
      return forgotten;
  drop();
  return {};
}

void StagedFiles::drop() {
  std::error_code ignored;
  fs::remove_all(project_ / kFolder, ignored);
}

Result<std::vector<FileCopy>> filesToCopy(const fs::path& b, const Outcome& outcome) {
  std::map<std::string, FileCopy> all = outcome.copies;
  const Result<OpenFolder> folder = OpenFolder::open(b);
  if (!folder) return folder.error();
  for (const auto& [from, to] : outcome.files_of) {
    const Result<ContainedPath> path = ContainedPath::parse(from);
    if (!path) return path.error();
    std::error_code failed;
    if (!fs::is_directory(b / from, failed)) continue;
    const Result<std::vector<OpenFolder::Entry>> entries = folder->filesBelow(*path);
    if (!entries) return entries.error();
    for (const OpenFolder::Entry& entry : *entries) {
      const std::string name = fs::path(entry.path).filename().string();
      if (name == kLockFile || name.ends_with(".partial")) continue;
      if (!entry.is_regular)
        return Error::unusable(
            message(
                "A link or a device cannot be merged; nothing was merged. Move what it leads to "
                "into project B."),
            (b / entry.path).string());
      const std::string below =
          entry.path.starts_with(from + "/") ? entry.path.substr(from.size() + 1) : entry.path;
      const std::string place = to + "/" + below;
      if (outcome.peoples_files.contains(place)) continue;
      all.emplace(place, FileCopy{from + "/" + below, place, {}});
    }
  }
  std::vector<FileCopy> files;
  for (auto& [to, file] : all) {
    for (const auto& [theirs, place] : outcome.files_of)
      file.replaces |= to.starts_with(place + "/");
    files.push_back(file);
  }
  return files;
}

}  // namespace ostraka::merge
