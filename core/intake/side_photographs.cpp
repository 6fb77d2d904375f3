#include "intake/side_photographs.h"

#include <system_error>
#include <utility>
#include <vector>

#include "base/text.h"
#include "batch/photographs.h"
#include "files/files.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<const char*, batch::Side> kSideFolders[] = {
    {"front", batch::Side::Front},
    {"back", batch::Side::Back},
    {"top_images", batch::Side::Front},
    {"bottom_images", batch::Side::Back}};

// Photographs, or imported scans.
std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files = batch::photographsIn(folder);
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    const fs::path& file = it->path();
    if (lowerCase(file.extension().string()) == ".ply" &&
        !file.filename().string().starts_with('.'))
      files.push_back(file);
  }
  return files;
}

}  // namespace

std::optional<batch::Side> sideOf(const std::string& name) {
  for (const auto& [folder, side] : kSideFolders)
    if (fs::path(name).parent_path() == folder) return side;
  return std::nullopt;
}

Result<PhotographHashes> photographsNow(const fs::path& batch_folder, const std::stop_token& stop) {
  PhotographHashes hashes;
  for (const auto& [folder, side] : kSideFolders)
    for (const fs::path& file : filesIn(batch_folder / folder)) {
      if (stop.stop_requested()) return Error::cancelled();
      const Result<std::string> bytes = readFile(file);
      hashes[std::string(folder) + "/" + file.filename().string()] =
          bytes ? sha256(*bytes) : "unreadable";
    }
  return hashes;
}

Result<std::string> takingNow(const fs::path& batch_folder, const std::stop_token& stop) {
  const Result<PhotographHashes> hashes = photographsNow(batch_folder, stop);
  if (!hashes) return hashes.error();
  std::string all;
  for (const auto& [name, hash] : *hashes) all += name + ":" + hash + "\n";
  return sha256(all);
}

}  // namespace ostraka::intake
