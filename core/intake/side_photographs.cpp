#include "intake/side_photographs.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/message.h"
#include "base/text.h"
#include "batch/photographs.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "catalogue/settings.h"
#include "files/files.h"
#include "store/database.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;
using batch::SideFile;
using store::valueOrThrow;

constexpr auto kShared = translatable<4>(
    "%1 of the %2 photographs or scans of %3 belong to %4, too: its sherds would be in the "
    "catalogue twice. Nothing was entered. Set %3 aside and use %4, or keep both: 'Keep both' in "
    "the queue, 'ostraka catalogue enter --keep-both' on the command line.");

std::string keptKey(const std::string& batch_number) {
  return catalogue::kKeptTwice + batch_number;
}

std::string hashOf(const SideFile& file) {
  const Result<std::string> bytes = file.sha256.empty() ? readFile(file.file) : std::string();
  return !file.sha256.empty() ? file.sha256 : bytes ? sha256(*bytes) : std::string();
}

using Recorded = std::map<store::BatchRow, std::vector<SideFile>>;

Recorded recordedPhotographs(const catalogue::Catalogue& catalogue) {
  Recorded photographs;
  for (const records::FileRecord& file : valueOrThrow(catalogue::Files(catalogue).all()))
    if (file.role == "photo" && file.batch)
      photographs[file.batch].push_back(
          {file.path, static_cast<std::uintmax_t>(file.bytes), file.sha256});
  return photographs;
}

// What lies in its folder is what the catalogue recorded if name and size say so.
std::vector<SideFile> filesOf(const records::BatchRecord& batch, const Recorded& recorded,
                              const fs::path& project) {
  std::vector<SideFile> files;
  if (const auto own = recorded.find(batch.row); own != recorded.end()) files = own->second;
  std::map<std::string, std::uintmax_t> known;
  for (const SideFile& file : files) known[file.file.generic_string()] = file.bytes;
  for (const SideFile& file : batch::sideFilesIn(project / "batches" / batch.number)) {
    const auto same = known.find(file.file.lexically_relative(project).generic_string());
    if (same == known.end() || same->second != file.bytes) files.push_back(file);
  }
  return files;
}

}  // namespace

bool entersItsSherds(const catalogue::Catalogue& catalogue, const records::BatchRecord& other,
                     store::BatchRow before) {
  return (other.row < before && other.state != records::BatchState::Failed) ||
         !valueOrThrow(catalogue::Batches(catalogue).scans(other.row)).empty();
}

Result<std::optional<SharedPhotographs>> sharedPhotographs(const catalogue::Catalogue& catalogue,
                                                           const fs::path& project,
                                                           std::vector<SideFile> files,
                                                           const CountsBatch& counts,
                                                           const std::stop_token& stop) {
  return catalogue.database().asResult([&]() -> std::optional<SharedPhotographs> {
    const Recorded recorded = recordedPhotographs(catalogue);
    std::set<std::uintmax_t> sizes;
    for (const SideFile& file : files)
      if (file.bytes > 0) sizes.insert(file.bytes);  // of none a copy failed
    std::optional<SharedPhotographs> most;
    std::vector<records::BatchRecord> batches = valueOrThrow(catalogue::Batches(catalogue).all());
    std::reverse(batches.begin(), batches.end());  // of equals the oldest
    for (const records::BatchRecord& batch : batches) {
      if (!counts(batch)) continue;
      std::set<std::uintmax_t> there_sizes;
      std::set<std::string> there;
      for (const SideFile& file : filesOf(batch, recorded, project)) {
        if (stop.stop_requested()) throw store::Refused(Error::cancelled());
        if (!sizes.contains(file.bytes)) continue;
        there_sizes.insert(file.bytes);
        if (const std::string hash = hashOf(file); !hash.empty()) there.insert(hash);
      }
      int shared = 0;
      for (SideFile& file : files) {
        if (stop.stop_requested()) throw store::Refused(Error::cancelled());
        if (!there_sizes.contains(file.bytes)) continue;
        file.sha256 = hashOf(file);
        shared += there.contains(file.sha256) ? 1 : 0;
      }
      if (shared > (most ? most->shared : 0))
        most = {batch.number, shared, static_cast<int>(files.size())};
    }
    return most;
  });
}

Result<void> checkNotShared(const catalogue::Catalogue& catalogue, const fs::path& project,
                            const records::BatchRecord& batch, const std::stop_token& stop) {
  return catalogue.database().asResult([&] {
    const catalogue::Batches batches(catalogue);
    if (!valueOrThrow(batches.scans(batch.row)).empty() ||
        !valueOrThrow(catalogue::Settings(catalogue).value(keptKey(batch.number))).empty())
      return;
    std::vector<SideFile> files = batch::sideFilesIn(project / "batches" / batch.number);
    if (files.empty()) files = recordedPhotographs(catalogue)[batch.row];  // on another disk
    const auto counts = [&](const records::BatchRecord& other) {
      return entersItsSherds(catalogue, other, batch.row);  // batch itself has none
    };
    const auto shared =
        valueOrThrow(sharedPhotographs(catalogue, project, std::move(files), counts, stop));
    if (shared)
      store::refuse(message(kShared, shared->shared, shared->of, batch.number, shared->batch),
                    (project / "batches" / batch.number).string());
  });
}

bool isAboutShared(const Message& sentence) {
  return sentence.templateWords() == kShared.words();
}

Result<void> keepBoth(const catalogue::Catalogue& catalogue, const std::string& batch_number,
                      const records::Provenance& provenance) {
  return catalogue::Settings(catalogue).setValue(keptKey(batch_number), "1", provenance);
}

}  // namespace ostraka::intake
