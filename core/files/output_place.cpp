#include "files/output_place.h"

#include <algorithm>
#include <system_error>

#include "base/message.h"
#include "base/text.h"

namespace ostraka {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLinks = 40;  // as the system's own limit

bool isThere(const fs::path& path) {
  std::error_code failed;
  return fs::exists(fs::symlink_status(path, failed));
}

// A link that leads to nothing yet: what is written there makes what it names.
fs::path withoutDanglingLinks(const fs::path& path) {
  fs::path walked;
  for (auto part = path.begin(); part != path.end(); ++part) {
    walked /= *part;
    std::error_code failed;
    if (fs::exists(walked, failed)) continue;
    if (!fs::is_symlink(fs::symlink_status(walked, failed))) return path;
    fs::path leads_to = walked.parent_path() / fs::read_symlink(walked, failed);
    for (++part; part != path.end(); ++part) leads_to /= *part;
    return leads_to;
  }
  return path;
}

// Where a writer would end up: without links and '..', as far as the path is there.
fs::path resolved(const fs::path& target) {
  std::error_code failed;
  fs::path path = fs::absolute(target, failed);
  for (int links = 0; links < kMostLinks; ++links) {
    const fs::path canonical = fs::weakly_canonical(path, failed);
    if (failed) break;
    const fs::path followed = withoutDanglingLinks(canonical);
    if (followed == path) break;
    path = followed;
  }
  path = path.lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

// The nearest folder with this file in it, of the place and those above it; else empty.
fs::path nearestWith(const char* file, const fs::path& place) {
  for (fs::path folder = place; !folder.empty(); folder = folder.parent_path()) {
    if (isThere(folder / file)) return folder;
    if (folder == folder.parent_path()) break;
  }
  return {};
}

}  // namespace

Result<void> checkOutputPlace(const fs::path& target, std::string_view filled) {
  if (target.empty()) return {};
  if (!filled.empty())
    if (Result<void> own = checkNoLinkInProject(target); !own) return own;
  const fs::path place = resolved(target);
  if (const fs::path bag = nearestWith("bagit.txt", place); !bag.empty())
    return Error::unusable(message("This location belongs to the archive or export '%1', which new "
                                   "files would make invalid; choose a location outside it.",
                                   bag.string()),
                           target.string());
  const fs::path project = nearestWith("catalogue.sqlite", place);
  if (project.empty()) return {};
  if (filled.empty())
    return Error::unusable(
        message("This location belongs to the project '%1'; choose a location outside it.",
                project.string()),
        target.string());
  const fs::path folder = project / filled;
  if (place.parent_path() == folder) return {};
  return Error::unusable(message("This location belongs to the project '%1'; choose a folder "
                                 "directly in '%2', or one outside the project.",
                                 project.string(), folder.string()),
                         target.string());
}

Result<void> checkOutputFile(const fs::path& file, const std::vector<std::string>& endings,
                             const std::vector<fs::path>& inputs) {
  const std::string ending = lowerCase(file.extension().string());
  if (std::find(endings.begin(), endings.end(), ending) == endings.end())
    return Error::unusable(message("The name of this output must end in %1; choose another name.",
                                   joined(endings, ", ")),
                           file.string());
  if (Result<void> good = checkOutputPlace(file); !good) return good;
  std::error_code failed;
  if (fs::is_directory(file, failed))
    return Error::unusable(message("This is a folder, not a file; choose another name."),
                           file.string());
  for (const fs::path& input : inputs)
    if (fs::equivalent(file, input, failed))
      return Error::unusable(message("This output is one of the input files, which it would "
                                     "overwrite; choose another name."),
                             file.string());
  return {};
}

Result<void> checkNoLinkInProject(const fs::path& place) {
  std::error_code failed;
  fs::path named = fs::absolute(place, failed).lexically_normal();
  if (!named.has_filename()) named = named.parent_path();
  const fs::path project = nearestWith("catalogue.sqlite", named.parent_path());
  if (project.empty()) return {};
  std::vector<std::string> folders;  // PROJECT/results/B0001: results/B0001, and results
  for (fs::path at = named.lexically_relative(project); !at.empty(); at = at.parent_path())
    folders.push_back(at.string());
  const std::vector<std::string_view> names(folders.begin(), folders.end());
  if (Result<void> own = checkNoLinkedFolder(project, names, LinkedFolders::OfTheseNames); !own)
    return own;
  // The way to it may lead out of another project, into which a link was put.
  return fs::is_symlink(project, failed) ? checkNoLinkInProject(project) : Result<void>();
}

Result<void> checkNoLinkedFolder(const fs::path& folder, std::span<const std::string_view> names,
                                 LinkedFolders which) {
  const auto refused = [](const fs::path& link) {
    return Error::unusable(message("A link has taken the place of a folder of a project or of a "
                                   "result; what it leads to was "
                                   "not touched. Delete the link, or move the folder itself here."),
                           link.string());
  };
  for (const std::string_view name : names) {
    std::error_code failed;
    const fs::directory_entry own(folder / name, failed);
    // Also one that leads to nothing yet: what is written there makes what it names.
    if (own.is_symlink(failed)) return refused(own.path());
    if (which == LinkedFolders::OfTheseNames) continue;
    // Links are not entered.
    if (!own.is_directory(failed)) continue;
    for (fs::recursive_directory_iterator at(own.path(), failed), end; !failed && at != end;
         at.increment(failed))
      if (at->is_symlink(failed) &&
          (which == LinkedFolders::AndLinksToFiles || at->is_directory(failed)))
        return refused(at->path());
    // What another process removes meanwhile is no link.
    if (failed && failed != std::errc::no_such_file_or_directory)
      return Error::unusable(
          message("This folder cannot be read (%1); nothing was read.", failed.message()),
          own.path().string());
  }
  return {};
}

}  // namespace ostraka
