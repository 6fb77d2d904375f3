#include "sherds/kept_models.h"

#include <set>
#include <system_error>

#include "base/message.h"
#include "catalogue/catalogue.h"
#include "files/checksum.h"
#include "files/files.h"
#include "files/open_folder.h"
#include "files/output_place.h"
#include "files/scratch_folder.h"
#include "sherds/sherd_columns.h"
#include "store/database.h"
#include "store/names.h"

namespace ostraka::sherds {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModelFiles[] = {"model.ply", "model.glb", "preview.png"};
constexpr std::size_t kNameLength = 16;  // hexadecimal digits: 64 bits of the contents' checksum

fs::path folderOf(const std::string& batch) {
  return fs::path("models") / batch;
}

Result<void> checkFolderOf(const std::string& batch) {
  if (store::isFolderName(batch)) return {};
  return Error::unusable(
      message("The number of a batch is also the name of its folder; use letters and digits."),
      batch);
}

// Unfinished models lie in here, each in a folder of its own; archives leave such names out.
constexpr const char* kUnfinished = "new.partial";

// As keepModel names folders: what else lies beside them is not ours to remove.
bool isKept(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  std::error_code failed;
  return name.size() == kNameLength &&
         name.find_first_not_of("0123456789abcdef") == std::string::npos &&
         entry.symlink_status(failed).type() == fs::file_type::directory;
}

// Files are only ever replaced, never written into, so a second name keeps what is there now.
Result<void> secondName(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  fs::create_hard_link(from, to, failed);
  if (!failed) return {};
  const Result<std::string> bytes = readFile(from);
  return bytes ? writeFileAtomically(to, *bytes) : Result<void>(bytes.error());
}

// Of a whole model, none of whose files is a link, by its files' contents.
Result<std::string> nameOf(const fs::path& folder, ModelHashes& hashes) {
  const Result<OpenFolder> opened = OpenFolder::open(folder);
  if (!opened) return opened.error();
  std::string sums;
  for (const char* name : kModelFiles) {
    Result<OpenFile> file = opened->read(*ContainedPath::parse(name));
    if (!file) return file.error();
    const Result<Checksum> sum = checksumOf(*file, {});
    if (!sum) return sum.error();
    hashes[name] = sum->sha256;
    sums += name + sum->sha256;
  }
  return sha256(sums).substr(0, kNameLength);
}

}  // namespace

Result<FolderLock> holdModels(const fs::path& project, const std::string& batch, Progress& progress,
                              const std::stop_token& stop) {
  if (const Result<void> good = checkFolderOf(batch); !good) return good.error();
  const std::string folder = folderOf(batch).generic_string();
  const std::string_view names[] = {"models", folder};
  if (const Result<void> own = checkNoLinkedFolder(project, names, LinkedFolders::OfTheseNames);
      !own)
    return own.error();
  return FolderLock::waitFor(project / folderOf(batch),
                             message("Another program is entering results of this batch; this one "
                                     "waits until it has finished."),
                             progress, stop);
}

Result<std::string> keepModel(const fs::path& project, const std::string& batch,
                              const fs::path& from, const ModelHashes& made) {
  std::error_code failed;
  for (const char* name : kModelFiles)
    if (fs::symlink_status(from / name, failed).type() == fs::file_type::not_found)
      return Error{ErrorCode::Missing, message("This model is missing; reprocess its batch."),
                   (from / name).string()};
  const fs::path all = project / folderOf(batch), unfinished = all / kUnfinished;
  if (const Result<void> ready = makeFolder(unfinished); !ready) return ready.error();
  const struct Emptied {
    const fs::path& folder;
    ~Emptied() {
      std::error_code in_use;
      fs::remove(folder, in_use);  // only if nothing is left in it
    }
  } emptied{unfinished};
  const Result<ScratchFolder> scratch = ScratchFolder::make("model", unfinished);
  if (!scratch) return scratch.error();
  const fs::path partial = scratch->path() / "content";  // readable for others, unlike the folder
  if (const Result<void> ready = makeFolder(partial); !ready) return ready.error();
  for (const char* name : kModelFiles)
    if (const Result<void> named = secondName(from / name, partial / name); !named)
      return named.error();
  // Of what was kept, not of what may lie in `from` by now.
  ModelHashes kept, earlier;
  const Result<std::string> name = nameOf(partial, kept);
  if (!name) return Error{name.error().code, name.error().what, from.string()};
  for (const char* file : kModelFiles)
    if (const auto hash = made.find(file); hash == made.end() || hash->second != kept[file])
      return Error::unusable(
          message("These results of 'ostraka process' are incomplete; run it again."),
          (from / file).string());
  if (const Result<std::string> there = nameOf(all / *name, earlier); !there || *there != *name) {
    fs::remove_all(all / *name, failed);  // damaged since
    fs::rename(partial, all / *name, failed);
    if (failed) return cannotWrite(all / *name, failed.value());
    syncFolder(all / *name);
    syncFolder(all);
  }
  return (folderOf(batch) / *name).generic_string();
}

Result<void> dropUnusedModels(const catalogue::Catalogue& catalogue, const fs::path& project,
                              const std::string& batch, const std::set<std::string>& kept) {
  if (const Result<void> good = checkFolderOf(batch); !good) return good.error();
  std::set<std::string> unused;
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(project / folderOf(batch), failed))
    if (isKept(entry)) unused.insert((folderOf(batch) / entry.path().filename()).generic_string());
  fs::remove_all(project / folderOf(batch) / kUnfinished, failed);
  for (const std::string& folder : kept) unused.erase(folder);
  if (unused.empty()) return {};
  const Result<void> dropped = catalogue.database().inTransaction([&] {
    store::Statement shown = catalogue.database().sql(
        "SELECT model_path, preview_path FROM sherd WHERE model_path LIKE ?",
        folderOf(batch).generic_string() + "/%");
    for (std::string model, preview; shown.read(model, preview);) {
      for (const std::string& path : {model, preview})
        unused.erase(fs::path(path).parent_path().generic_string());
    }
    for (const std::string& folder : unused)
      catalogue.database().run("DELETE FROM file WHERE substr(path, 1, length(?)) = ?",
                               folder + "/", folder + "/");
  });
  if (!dropped) return dropped;
  for (const std::string& folder : unused) fs::remove_all(project / folder, failed);
  return {};
}

void forgetModel(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                 const records::Provenance& provenance) {
  store::Database& database = catalogue.database();
  const auto kinds =
      database
          .sql(
              "SELECT kind FROM measurement WHERE sherd = ? AND current = 1 AND person IS NULL AND "
              "method = 'program'",
              sherd)
          .all<std::string>();
  for (const std::string& kind : kinds) clearMeasure(catalogue, sherd, kind, provenance);
  database.run(
      "UPDATE file SET sherd = NULL WHERE sherd = ? AND role IN ('model', 'preview', "
      "'drawing', 'scan')",
      sherd);
  database.run("UPDATE sherd SET preview_path = '', model_path = '' WHERE row = ?", sherd);
}

}  // namespace ostraka::sherds
