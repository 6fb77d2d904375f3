#include "merge/staged_files.h"

#include <algorithm>
#include <sstream>

#include "archive/distinct_paths.h"
#include "base/message.h"
#include "catalogue/settings.h"
#include "files/checksum.h"
#include "files/files.h"
#include "files/folder_lock.h"

namespace ostraka::merge {
namespace {

namespace fs = std::filesystem;

Error unlikeInB(const std::string& path) {
  return Error::unusable(
      message("This file of project B differs from what its catalogue records; nothing was merged. "
              "Restore it from a copy ('ostraka catalogue check' lists all such files)."),
      path);
}

Error takenInA(const std::string& path) {
  return Error::unusable(message("Project A has another file with this name, which its catalogue "
                                 "does not list; nothing was merged. Move that file elsewhere."),
                         path);
}

}  // namespace

Result<void> StagedFiles::copy(const fs::path& b, const std::vector<FileCopy>& files,
                               Progress& progress, const std::stop_token& stop) {
  if (files.empty()) return {};
  const fs::path staging = project_ / upkeep::kStagingFolder;
  if (const Result<void> made = makeFolder(staging); !made) return made;
  const Result<OpenFolder> from = OpenFolder::open(b), to = OpenFolder::open(staging),
                           project = OpenFolder::open(project_);
  if (!from) return from.error();
  if (!to) return to.error();
  if (!project) return project.error();
  archive::DistinctPaths distinct;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(static_cast<std::int64_t>(i), static_cast<std::int64_t>(files.size()));
    const Result<ContainedPath> path = ContainedPath::parse(files[i].from),
                                place = ContainedPath::parse(files[i].to);
    if (!path) return path.error();
    if (!place) return place.error();
    const auto miss = [&] {
      missing_.push_back(files[i].from);
      if (place->parts().size() > 2 && !place->text().starts_with("imported/"))
        incomplete_.insert(place->parts()[1]);
    };
    if (!from->has(*path)) {
      miss();
      continue;
    }
    Result<OpenFile> file = from->read(*path);
    if (!file) return file.error();
    const Result<void> own_name = distinct.add(files[i].to);
    if (!own_name && to->has(*place)) return own_name;  // on this disk, too, it is another's
    Result<NewFile> copy = to->create(*place);
    if (!copy && copy.error().code == ErrorCode::UnusableInput)
      return Error::unusable(copy.error().what, (b / files[i].from).string());
    if (!copy) return copy.error();
    const Result<Checksum> sum =
        checksumOf(*file, stop, [&](std::string_view bytes) { return copy->write(bytes); });
    if (!sum) return sum.error();
    if (!files[i].sha256.empty() && files[i].sha256 != sum->sha256) {
      if (!files[i].restores) return unlikeInB((b / files[i].from).string());
      miss();
      continue;
    }
    const Result<std::string> there = upkeep::sha256At(*project, *place, stop);
    if (!there) return there.error();
    if (!files[i].replaces && *there == sum->sha256) continue;
    if (!files[i].replaces && !there->empty()) return takenInA((project_ / files[i].to).string());
    if (const Result<void> whole = copy->finish(); !whole) return whole;
    Result<OpenFile> written = to->read(*place);
    if (!written) return written.error();
    const Result<Checksum> back = checksumOf(*written, stop);
    if (!back) return back.error();
    if (back->sha256 != sum->sha256)
      return Error{ErrorCode::CannotWrite,
                   message("The disk does not return what was written to it; nothing was merged. "
                           "Check the disk."),
                   (staging / files[i].to).string()};
    staged_[files[i].to] = {files[i].to, *there};
    bytes_ += sum->bytes;
  }
  return {};
}

Result<void> StagedFiles::expect(const std::string& to, const std::stop_token& stop) {
  const Result<OpenFolder> project = OpenFolder::open(project_);
  if (!project) return project.error();
  const Result<ContainedPath> place = ContainedPath::parse(to);
  if (!place) return place.error();
  Result<std::string> there = upkeep::sha256At(*project, *place, stop);
  if (!there) return there.error();
  expected_[to] = std::move(*there);
  return {};
}

Result<void> StagedFiles::put(const std::string& to, const std::string& bytes) {
  const fs::path at = project_ / upkeep::kStagingFolder / to;
  if (const Result<void> made = makeFolder(at.parent_path()); !made) return made;
  if (const Result<void> written = writeFileAtomically(at, bytes); !written) return written;
  staged_[to] = {to, expected_[to]};
  bytes_ += static_cast<std::int64_t>(bytes.size());
  return {};
}

Result<void> StagedFiles::note(catalogue::Catalogue& catalogue, const Outcome& outcome) const {
  catalogue::Settings settings(catalogue);
  const Result<std::string> before = settings.value(kIncompleteBatches);
  if (!before) return before.error();
  // Those that this B does not have wait for another.
  std::set<std::string> batches = incomplete_;
  std::istringstream words(*before);
  for (std::string batch; words >> batch;)
    if (std::none_of(outcome.incomplete.begin(), outcome.incomplete.end(),
                     [&](const auto& folder) { return folder.second == "batches/" + batch; }))
      batches.insert(batch);
  std::string after;
  for (const std::string& batch : batches) after += batch + " ";
  if (after != *before)
    if (const Result<void> noted = settings.setValue(kIncompleteBatches, after); !noted)
      return noted;
  return staged_.empty() ? Result<void>() : upkeep::noteStaged(catalogue, staged_);
}

void StagedFiles::drop() {
  std::error_code ignored;
  fs::remove_all(project_ / upkeep::kStagingFolder, ignored);
}

Result<std::vector<FileCopy>> filesToCopy(const fs::path& a, const fs::path& b,
                                          const Outcome& outcome) {
  std::map<std::string, FileCopy> all = outcome.copies;
  const Result<OpenFolder> folder = OpenFolder::open(b);
  if (!folder) return folder.error();
  std::map<std::string, std::string> folders = outcome.files_of;
  folders.insert(outcome.incomplete.begin(), outcome.incomplete.end());
  for (const auto& [from, to] : folders) {
    const Result<ContainedPath> path = ContainedPath::parse(from);
    if (!path) return path.error();
    std::error_code failed;
    if (!fs::is_directory(b / from, failed)) continue;
    const Result<std::vector<OpenFolder::Entry>> entries = folder->filesBelow(*path);
    if (!entries) return entries.error();
    for (const OpenFolder::Entry& entry : *entries) {
      const std::string name = fs::path(entry.path).filename().string();
      if (name == kLockFile || name.starts_with('.') || name.ends_with(".partial")) continue;
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
      if (!outcome.files_of.contains(from) && fs::exists(fs::symlink_status(a / place, failed)))
        continue;
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
