#include "archive/archive.h"

#include <algorithm>
#include <map>

#include "archive/bag_reader.h"
#include "archive/bagit.h"
#include "base/message.h"
#include "catalogue/queue_pause.h"
#include "files/checksum.h"
#include "files/files.h"
#include "files/folder_lock.h"
#include "files/new_folder.h"
#include "files/output_place.h"
#include "store/database.h"
#include "store/schema_check.h"
#include "upkeep/archived_project.h"
#include "upkeep/peoples_file_check.h"
#include "upkeep/project.h"
#include "upkeep/value_check.h"

namespace ostraka::archive {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCatalogue = "catalogue.sqlite";
constexpr const char* kChecks = "file-checks.txt";
constexpr const char* kCluster = "cluster";

// What belongs to the programs that have the project open, not to the project: the catalogue's
// journals, whose copy SQLite makes, the lock of the window and those of folders, what is half
// written, what was checked, and what is on a cluster, which whoever has the archive cannot reach.
bool isOfAProgram(const fs::path& name) {
  const std::string text = name.string();
  return text.starts_with(kCatalogue) || text == ".ostraka.lock" || text == kChecks ||
         text == kCluster;
}

struct ProjectFiles {
  std::vector<fs::path> regular, links;
};

Result<ProjectFiles> filesOf(const fs::path& project) {
  ProjectFiles files;
  std::error_code code;
  for (auto it = fs::recursive_directory_iterator(project, code);
       it != fs::recursive_directory_iterator(); it.increment(code)) {
    const fs::path name = it->path().filename();
    if ((it.depth() == 0 && isOfAProgram(name)) || name.extension() == ".partial") {
      it.disable_recursion_pending();
      continue;
    }
    std::error_code gone;
    const fs::file_type type = it->symlink_status(gone).type();
    // An import may have made a folder of that name.
    if (type == fs::file_type::regular && name != kLockFile) files.regular.push_back(it->path());
    if (type == fs::file_type::symlink) files.links.push_back(it->path());
  }
  if (code)
    return Error::unusable(
        message("A folder of the project cannot be read (%1); check its permissions, then archive "
                "the project again.",
                code.message()),
        project.string());
  for (std::vector<fs::path>* list : {&files.regular, &files.links})
    std::sort(list->begin(), list->end());
  return files;
}

// What an archive must contain so that it can be restored, and a restored one so that it is a
// project.
Result<void> checkContent(const catalogue::Catalogue& catalogue) {
  if (Result<void> whole = catalogue.checkIntegrity(); !whole) return whole;
  if (Result<void> inside = upkeep::checkPaths(catalogue); !inside) return inside;
  return upkeep::checkValues(catalogue);
}

// Copies the project's files into the bag and holds them against the catalogue.
class Archiving {
 public:
  Archiving(const upkeep::Project& project, BagWriter& bag, Progress& progress,
            std::stop_token stop)
      : project_(project), bag_(bag), progress_(progress), stop_(std::move(stop)) {}

  // `copy`: where SQLite's copy lies meanwhile.
  Result<void> addCatalogue(const fs::path& copy) {
    Result<void> added = project_.catalogue().backup(copy);
    if (added) added = readKnown(copy);
    if (added)
      if (const Result<BagFile> file = bag_.addFile(kCatalogue, copy, stop_); !file)
        added = file.error();
    std::error_code ignored;
    fs::remove(copy, ignored);
    return added;
  }

  Result<void> addFiles() {
    const Result<ProjectFiles> files = filesOf(project_.folder());
    if (!files) return files.error();
    const auto nameOf = [this](const fs::path& file) {
      return file.lexically_relative(project_.folder()).generic_string();
    };
    for (const fs::path& link : files->links) links_.push_back(nameOf(link));
    const auto count = static_cast<std::int64_t>(files->regular.size());
    for (const fs::path& file : files->regular) {
      progress_.report(static_cast<std::int64_t>(copied_.size()), count);
      const std::string name = nameOf(file);
      const Result<BagFile> added = bag_.addFile(name, file, stop_);
      if (!added) return added.error();
      copied_[name] = {added->sha256, added->bytes};
    }
    return {};
  }

  Result<std::vector<upkeep::DamagedFile>> damage() const {
    const Result<OpenFolder> folder = OpenFolder::open(project_.folder());
    if (!folder) return folder.error();
    auto damaged = upkeep::checkPeoplesFiles(project_.catalogue(), *folder);
    if (!damaged) return damaged;
    for (const upkeep::KnownFile& file : known_) {
      const auto copied = copied_.find(file.path);
      const auto found = copied == copied_.end() ? upkeep::Damage::Missing
                                                 : upkeep::damageOf(file, copied->second);
      if (found) damaged->push_back({file, *found});
    }
    return damaged;
  }

  const std::vector<std::string>& links() const { return links_; }

 private:
  // Of the copy: the project goes on changing while its files are copied.
  Result<void> readKnown(const fs::path& copy) {
    Result<std::unique_ptr<store::Database>> opened =
        store::Database::open(copy, store::Database::Mode::ReadWrite);
    if (!opened) return opened.error();
    const std::int64_t now = project_.catalogue().now();
    const catalogue::Catalogue copied(std::move(*opened), [now] { return now; });
    if (Result<void> good = checkContent(copied); !good) return good;
    auto known = upkeep::knownFiles(copied);
    if (!known) return known.error();
    known_ = std::move(*known);
    return {};
  }

  const upkeep::Project& project_;
  BagWriter& bag_;
  Progress& progress_;
  std::stop_token stop_;
  std::vector<upkeep::KnownFile> known_;  ///< by the catalogue that is archived
  std::map<std::string, Checksum> copied_;
  std::vector<std::string> links_;
};

// All of the bag into the folder, which is new.
Result<void> unpack(const BagReader& bag, const fs::path& folder, Progress& progress,
                    const std::stop_token& stop) {
  const Result<OpenFolder> to = OpenFolder::open(folder);
  if (!to) return to.error();
  std::int64_t done = 0;
  for (const BagFile& file : bag.files()) {
    progress.report(done++, static_cast<std::int64_t>(bag.files().size()));
    const Result<ContainedPath> path = ContainedPath::parse(file.path);
    if (!path) return path.error();
    if (path->below().text() == kChecks) continue;  // what was looked at there says nothing here
    if (Result<void> copied = bag.copy(file, *to, path->below(), stop); !copied) return copied;
  }
  return {};
}

Result<void> completeRestored(const fs::path& folder) {
  for (const char* name : {"batches", "results", "backups"})
    if (Result<void> made = makeFolder(folder / name); !made) return made;
  // Anybody may have written it: what it says is read before any of it is run.
  if (Result<void> ours = store::checkSchema(folder / kCatalogue); !ours) return ours;
  Result<upkeep::Project> opened = upkeep::Project::open(folder);
  if (!opened) return opened.error();
  if (Result<void> good = checkContent(opened->catalogue()); !good) return good;
  return catalogue::pauseRestoredQueue(opened->catalogue());
}

// For whoever finds the folder years later, perhaps without the program.
std::string readMeOf(const std::map<std::string, std::string>& info) {
  return "Archive of the Ostraka project " + info.at("External-Identifier") + ", made " +
         info.at("Bagging-Date") + " by " + info.at("Bag-Software-Agent") +
         "\n\n"
         "The folder is a bag (BagIt 1.0, RFC 8493). data/ is the whole project: the catalogue\n"
         "(catalogue.sqlite, SQLite 3), the photographs (batches/), what was computed from them\n"
         "(results/) and the models (models/). If there is a damage.txt, it lists what was "
         "missing\n"
         "or changed when the archive was made.\n\n"
         "To restore the project into a new folder, after all checksums are checked:\n\n"
         "    ostraka catalogue restore ARCHIVE --output FOLDER\n\n"
         "or 'Restore an archive' on the start screen.\n\n"
         "Change nothing in here: an archive with a changed file is rejected. To check the files\n"
         "without Ostraka:\n\n"
         "    sha256sum -c manifest-sha256.txt tagmanifest-sha256.txt\n";
}

}  // namespace

Result<Archived> archiveProject(const upkeep::Project& project, const ArchiveOptions& options,
                                Progress& progress, std::stop_token stop) {
  const fs::path target = folderNamed(options.target);
  Result<BagWriter> bag = BagWriter::begin(target);
  if (!bag) return bag.error();
  Archiving archiving(project, *bag, progress, std::move(stop));
  if (Result<void> added = archiving.addCatalogue(bag->folder() / "copy.sqlite"); !added)
    return added.error();
  if (Result<void> added = archiving.addFiles(); !added) return added.error();
  Archived archived;
  auto damage = archiving.damage();
  if (!damage) return damage.error();
  archived.damage = std::move(*damage);
  archived.links = archiving.links();
  if (!archived.whole() && options.damaged == DamagedFiles::Refuse) return archived;
  std::string list;
  for (const std::string& link : archived.links)
    list += link + " is a link; what it leads to is not in this archive.\n";
  for (const upkeep::DamagedFile& file : archived.damage) list += sentenceOf(file) + "\n";
  if (!list.empty()) bag->tag("damage.txt", list);
  auto info = bagInfo(project.catalogue(), options.program);
  if (!info) return info.error();
  bag->tag("README.txt", readMeOf(*info));
  info->emplace("Ostraka-Content", "project");
  if (const Result<void> finished = bag->finish(*info); !finished) return finished.error();
  archived.sealed = true;
  archived.bytes = bag->bytes();
  return archived;
}

Result<Restored> restoreProject(const fs::path& archive, const fs::path& folder, Progress& progress,
                                std::stop_token stop) {
  if (const Result<void> good = checkOutputPlace(folder); !good) return good.error();
  std::error_code code;
  if (fs::exists(folder, code) && (!fs::is_directory(folder, code) || !fs::is_empty(folder, code)))
    return Error::unusable(
        message("Restoring a project needs a new or empty folder; choose another name."),
        folder.string());
  if (upkeep::Project::isProject(archive) && upkeep::archiveAt(archive).empty())
    return Error::unusable(
        message("This is a project already, not an archive of one; open it as it is."),
        archive.string());
  progress.begin("checksums", 0.5);
  const Result<BagReader> bag = BagReader::open(archive, progress, stop);
  if (!bag) return bag.error();
  progress.begin("restore", 0.5);
  if (!bag->find("data/catalogue.sqlite"))
    return Error::unusable(
        message("Not an archive of a whole project; import it as an export instead."),
        archive.string());
  for (const BagFile& file : bag->files())
    // SQLite would act on a journal that lies beside the catalogue.
    if (file.path.starts_with("data/catalogue.sqlite-"))
      return Error::unusable(message("The archive contains a journal of its catalogue, which an "
                                     "Ostraka archive never contains; nothing was written."),
                             file.path);
  std::vector<fs::path> made;  // the innermost first
  for (fs::path parent = folderNamed(folder).parent_path(); !fs::exists(parent, code);
       parent = parent.parent_path())
    made.push_back(parent);
  const Result<void> restored = [&]() -> Result<void> {
    Result<NewFolder> fresh = NewFolder::begin(folder);
    if (!fresh) return fresh.error();
    if (Result<void> copied = unpack(*bag, fresh->path(), progress, stop); !copied) return copied;
    if (Result<void> whole = completeRestored(fresh->path()); !whole) return whole;
    return fresh->finish();
  }();
  if (!restored) {
    for (const fs::path& parent : made) fs::remove(parent, code);
    return restored.error();
  }
  return Restored{bag->damage()};
}

}  // namespace ostraka::archive
