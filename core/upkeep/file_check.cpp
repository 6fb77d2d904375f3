#include "upkeep/file_check.h"

#include <algorithm>
#include <tuple>

#include "base/message.h"
#include "catalogue/file_places.h"
#include "files/open_folder.h"
#include "files/output_place.h"
#include "sherds/sherd_columns.h"
#include "store/database.h"
#include "store/file_header.h"
#include "store/names.h"
#include "store/values.h"
#include "upkeep/file_check_log.h"
#include "upkeep/peoples_file_check.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kLongestRound_ms = 7LL * 24 * 3600 * 1000;  // then all is looked at anew

Result<void> addPeoplesFiles(const catalogue::Catalogue& catalogue, const OpenFolder& folder,
                             CheckedFiles& result) {
  Result<std::vector<DamagedFile>> more = checkPeoplesFiles(catalogue, folder);
  if (!more) return more.error();
  result.damaged.insert(result.damaged.end(), more->begin(), more->end());
  return {};
}

// One file as it lies there now. No link is followed: what it leads to is not the project's, and
// goes along in no archive.
Result<std::optional<Damage>> lookAt(const KnownFile& file, const OpenFolder& folder,
                                     CheckDepth depth, const std::stop_token& stop) {
  std::error_code code;
  if (fs::symlink_status(folder.path() / file.path, code).type() == fs::file_type::not_found)
    return std::optional(Damage::Missing);
  const Result<ContainedPath> path = ContainedPath::parse(file.path);
  if (!path) return path.error();
  Result<OpenFile> open = folder.read(*path);
  if (!open) return std::optional(Damage::Unreadable);
  if (depth == CheckDepth::NamesAndSizes || file.sha256.empty())
    return open->bytes() == file.bytes ? std::nullopt : std::optional(Damage::Changed);
  const Result<Checksum> found = checksumOf(*open, stop);
  if (found) return damageOf(file, *found);
  if (found.error().code == ErrorCode::Cancelled) return found.error();
  return std::optional(Damage::Unreadable);
}

}  // namespace

Result<std::vector<KnownFile>> knownFiles(const catalogue::Catalogue& catalogue) {
  return catalogue.database().asResult([&] {
    std::vector<KnownFile> files;
    store::Statement rows = catalogue.database().sql(
        "SELECT f.path, f.sha256, f.role, f.bytes, iif(s.number = '', s.id, s.number), b.number "
        "FROM file f LEFT JOIN sherd s ON s.row = f.sherd LEFT JOIN batch b ON b.row = f.batch "
        "WHERE NOT (f.path GLOB 'results/*' AND ifnull(b.state, '') IN ('queued', 'computed', "
        "'failed')) ORDER BY f.path");
    for (KnownFile file;
         rows.read(file.path, file.sha256, file.role, file.bytes, file.sherd, file.batch);)
      files.push_back(file);
    return files;
  });
}

std::string sentenceOf(const DamagedFile& damaged) {
  const KnownFile& file = damaged.file;
  std::string of;
  if (!file.sherd.empty()) of = "sherd " + file.sherd;
  if (!file.batch.empty()) of += (of.empty() ? "batch " : ", batch ") + file.batch;
  const std::string name = of.empty() ? file.path : file.path + " (" + of + ")";
  switch (damaged.damage) {
    case Damage::Missing:
      return name + " is missing.";
    case Damage::Changed:
      return name + " has changed since it was entered.";
    case Damage::Unreadable:
      return name + " cannot be read.";
  }
  return name;
}

std::optional<Damage> damageOf(const KnownFile& file, const Checksum& found) {
  const bool same = file.sha256.empty() ? found.bytes == file.bytes : found.sha256 == file.sha256;
  return same ? std::nullopt : std::optional(Damage::Changed);
}

Result<CheckedFiles> checkFiles(const catalogue::Catalogue& catalogue, const fs::path& folder,
                                CheckDepth depth, Progress& progress, std::stop_token stop) {
  const Result<std::vector<KnownFile>> known = knownFiles(catalogue);
  if (!known) return known.error();
  const Result<OpenFolder> opened = OpenFolder::open(folder);
  if (!opened) return opened.error();
  CheckedFiles result;
  result.files = static_cast<std::int64_t>(known->size());
  std::int64_t total = 0, done = 0;
  for (const KnownFile& file : *known) total += file.bytes;
  std::optional<FileCheckLog> log;
  if (depth == CheckDepth::Hashes) log.emplace(folder);
  // A clock that ran ahead, then or now, must not keep a file from being looked at.
  const std::int64_t now = catalogue.now();
  if (log && (log->begun_ms() < now - kLongestRound_ms || log->begun_ms() > now)) log->begin(now);
  for (const KnownFile& file : *known) {
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(done, total);
    done += file.bytes;
    const FileCheckLog::Seen* seen = log ? log->seen(file) : nullptr;
    // Before it is read: what is written meanwhile shows the next time.
    const std::string stamp = log ? FileCheckLog::stampOf(folder / file.path) : std::string();
    if (seen && !seen->damage && seen->at_ms >= log->begun_ms() && seen->at_ms <= now &&
        !stamp.empty() && seen->stamp == stamp)
      continue;
    const Result<std::optional<Damage>> damage = lookAt(file, *opened, depth, stop);
    if (!damage) return damage.error();
    ++result.checked;
    if (log) log->note(file, catalogue.now(), *damage, stamp);
    if (*damage) result.damaged.push_back({file, **damage});
  }
  if (log) log->end(catalogue.now());
  if (Result<void> added = addPeoplesFiles(catalogue, *opened, result); !added)
    return added.error();
  return result;
}

Result<CheckedFiles> checkShare(const catalogue::Catalogue& catalogue, const fs::path& folder,
                                std::int64_t most_bytes, Progress& progress, std::stop_token stop) {
  // Reads each page that is in use; unlike checkIntegrity it keeps nobody from writing.
  const Result<std::string> pages = catalogue.database().asResult(
      [&] { return catalogue.database().sql("PRAGMA integrity_check(1)").one<std::string>(); });
  if (!pages) return pages.error();
  if (*pages != "ok") return store::damagedCatalogue(*pages, catalogue.database().file());
  const Result<std::vector<KnownFile>> known = knownFiles(catalogue);
  if (!known) return known.error();
  const Result<OpenFolder> opened = OpenFolder::open(folder);
  if (!opened) return opened.error();
  CheckedFiles result;
  result.files = static_cast<std::int64_t>(known->size());
  FileCheckLog log(folder);
  const std::int64_t now = catalogue.now();
  std::vector<std::tuple<bool, std::int64_t, std::size_t>> order;
  for (std::size_t i = 0; i < known->size(); ++i) {
    const FileCheckLog::Seen* seen = log.seen((*known)[i]);
    // A clock that ran ahead must not keep a file from its turn for ever.
    const std::int64_t at_ms = seen && seen->at_ms <= now ? seen->at_ms : 0;
    order.emplace_back(!(seen && seen->damage), at_ms, i);
  }
  std::sort(order.begin(), order.end());
  std::int64_t done = 0;
  for (const auto& [is_whole, at_ms, i] : order) {
    const KnownFile& file = (*known)[i];
    if (stop.stop_requested()) return Error::cancelled();
    if (done >= most_bytes) break;
    progress.report(done, most_bytes);
    done += std::max<std::int64_t>(file.bytes, 1);
    const std::string stamp = FileCheckLog::stampOf(folder / file.path);
    const Result<std::optional<Damage>> damage = lookAt(file, *opened, CheckDepth::Hashes, stop);
    if (!damage) return damage.error();
    ++result.checked;
    log.note(file, catalogue.now(), *damage, stamp);
    if (*damage) result.damaged.push_back({file, **damage});
  }
  if (Result<void> added = addPeoplesFiles(catalogue, *opened, result); !added)
    return added.error();
  return result;
}

Result<void> checkPaths(const catalogue::Catalogue& catalogue) {
  return catalogue.database().asResult([&] {
    store::Statement rows = catalogue.database().sql(
        "SELECT path FROM file UNION ALL SELECT path FROM photograph UNION ALL SELECT path FROM "
        "scan UNION ALL SELECT model_path FROM sherd UNION ALL SELECT preview_path FROM sherd");
    for (std::string path; rows.read(path);)
      if (!path.empty()) store::valueOrThrow(catalogue::recordedPath(path));
    store::Statement batches = catalogue.database().sql("SELECT number FROM batch");
    for (std::string number; batches.read(number);) {
      if (!store::isFolderName(number))
        store::refuse(
            message(
                "The number of a batch is also the name of its folder; use letters and digits."),
            number);
    }
  });
}

Result<void> checkNoLinkInCluster(const fs::path& project) {
  constexpr std::string_view kNames[] = {"cluster"};
  return checkNoLinkedFolder(project, kNames, LinkedFolders::AndLinksToFiles);
}

}  // namespace ostraka::upkeep
