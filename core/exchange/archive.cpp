// A whole project as one bag, and back.
#include <algorithm>
#include <ctime>

#include "exchange/bagit.h"
#include "exchange/read_back.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;

// All files of the project but the catalogue itself, whose copy is made by SQLite.
Result<std::vector<fs::path>> filesOf(const fs::path& project) {
  std::vector<fs::path> files;
  std::error_code code;
  for (auto it = fs::recursive_directory_iterator(project, code);
       it != fs::recursive_directory_iterator(); it.increment(code)) {
    const bool own =
        it.depth() == 0 && it->path().filename().string().starts_with("catalogue.sqlite");
    const bool half = it->path().filename().string().ends_with(".partial");
    if (it->is_regular_file() && !it->is_symlink() && !own && !half) files.push_back(it->path());
  }
  if (code)
    return Error::unusable("A folder of the project cannot be read (" + code.message() +
                               "); check its permissions, and archive it again.",
                           project.string());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Result<std::int64_t> archiveProject(const catalogue::Project& project, const fs::path& target,
                                    const std::string& program, Progress& progress,
                                    std::stop_token stop) {
  const std::string inside =
      fs::absolute(target).lexically_normal().lexically_relative(project.folder()).generic_string();
  if (!inside.starts_with(".."))
    return Error{ErrorCode::UnusableInput, "An archive must not lie in the project itself.",
                 target.string()};
  Result<BagWriter> bag = BagWriter::begin(target);
  if (!bag) return bag.error();
  const fs::path copy = folderNamed(target).string() + ".sqlite.partial";
  const auto removed = [&](const Error& error) {
    std::error_code ignored;
    fs::remove(copy, ignored);
    return error;
  };
  if (const auto made = project.catalogue().backup(copy); !made) return removed(made.error());
  const Result<BagFile> catalogue = bag->addFile("catalogue.sqlite", copy, stop);
  std::error_code ignored;
  fs::remove(copy, ignored);
  if (!catalogue) return catalogue.error();
  const Result<std::vector<fs::path>> files = filesOf(project.folder());
  if (!files) return files.error();
  std::map<std::string, std::string> hashes;
  for (std::size_t i = 0; i < files->size(); ++i) {
    progress.report(static_cast<std::int64_t>(i), static_cast<std::int64_t>(files->size()));
    const fs::path& file = (*files)[i];
    const std::string name = file.lexically_relative(project.folder()).generic_string();
    const Result<BagFile> added = bag->addFile(name, file, stop);
    if (!added) return added.error();
    hashes[name] = added->sha256;
  }
  const auto entered = project.catalogue().files();
  if (!entered) return entered.error();
  for (const catalogue::FileRecord& file : *entered) {
    const auto copied = hashes.find(file.path);
    if (copied == hashes.end())
      progress.note(NoteLevel::Warning, file.path + " is in the catalogue and not in the folder.");
    else if (copied->second != file.sha256)
      progress.note(NoteLevel::Warning, file.path + " changed since it was entered.");
  }
  const auto record = project.catalogue().project();
  if (!record) return record.error();
  const Result<void> finished = bag->finish({{"External-Description", record->title},
                                             {"External-Identifier", record->code},
                                             {"Bag-Software-Agent", program},
                                             {"Ostraka-Content", "project"}});
  if (!finished) return finished.error();
  return bag->bytes();
}

Result<void> restoreProject(const fs::path& archive, const fs::path& folder, Progress& progress,
                            std::stop_token stop) {
  std::error_code code;
  if (fs::exists(folder, code) && (!fs::is_directory(folder, code) || !fs::is_empty(folder, code)))
    return Error{ErrorCode::UnusableInput,
                 "A project is restored into a new or an empty folder; choose another name.",
                 folder.string()};
  const Result<std::vector<BagFile>> files = checkBag(archive, progress, stop);
  if (!files) return files.error();
  if (!fs::exists(archive / "data" / "catalogue.sqlite", code))
    return Error{ErrorCode::UnusableInput,
                 "This is no archive of a whole project; read it as an export instead.",
                 archive.string()};
  const fs::path partial = folderNamed(folder).string() + ".partial";
  fs::remove_all(partial, code);
  const auto failed = [&](const Error& error) {
    std::error_code ignored;
    fs::remove_all(partial, ignored);
    return error;
  };
  for (const BagFile& file : *files) {
    if (stop.stop_requested()) return failed(Error::cancelled());
    const fs::path to = partial / fs::path(file.path).lexically_relative("data");
    fs::create_directories(to.parent_path(), code);
    if (!fs::copy_file(archive / file.path, to, code)) return failed(cannotWrite(to));
  }
  for (const char* name : {"batches", "results", "backups"})
    fs::create_directories(partial / name, code);
  {
    const Result<catalogue::Project> opened = catalogue::Project::open(partial);
    if (!opened) return failed(opened.error());
    if (const auto whole = opened->catalogue().checkIntegrity(); !whole)
      return failed(whole.error());
  }
  fs::remove(folder, code);  // empty, or not there
  fs::rename(partial, folderNamed(folder), code);
  if (code) return failed(cannotWrite(folder));
  return {};
}

}  // namespace ostraka::exchange
