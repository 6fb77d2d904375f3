#include "intake/results_owner.h"

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>

#include "base/message.h"
#include "catalogue/batches.h"
#include "catalogue/files.h"
#include "files/files.h"
#include "files/json.h"
#include "store/database.h"
#include "store/values.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;
using store::valueOrThrow;

using Hashes = std::map<std::string, std::string>;  // SHA-256 by name, relative to the batch

// What lies in a side's folder; the board, empty plates and masks may be those of many batches.
bool isOfASide(const std::string& name) {
  for (const char* side : {"front/", "back/", "top_images/", "bottom_images/"})
    if (name.starts_with(side)) return store::checkedPath(name).has_value();
  return false;
}

Result<Hashes> readFrom(const fs::path& out) {
  const fs::path file = out / "work" / "batch.json";
  Hashes hashes;
  std::error_code failed;
  if (!fs::exists(file, failed)) return hashes;  // made by an earlier version
  const Result<nlohmann::json> all = readJson(file);
  if (!all) return all.error();
  if (!all->is_object()) return hashes;
  for (const auto& [name, hash] : all->items())
    if (hash.is_string() && isOfASide(name)) hashes[name] = hash.get<std::string>();
  return hashes;
}

bool isAThird(std::size_t same, const Hashes& all) {
  return 3 * same >= all.size();
}

class Owners {
 public:
  Owners(const fs::path& project, const Hashes& made_from, const std::stop_token& stop)
      : project_(project), made_from_(made_from), stop_(stop) {}

  // By the catalogue's word on the batch's photographs.
  bool own(const std::set<std::string>& recorded) const {
    std::size_t same = 0;
    for (const auto& [name, hash] : made_from_) same += recorded.contains(hash) ? 1 : 0;
    return same > 0 && isAThird(same, made_from_);
  }

  // By the files in the batch's folder.
  Result<bool> own(const std::string& number) const {
    std::size_t same = 0;
    for (const auto& [name, hash] : made_from_) {
      if (stop_.stop_requested()) return Error::cancelled();
      const fs::path file = project_ / "batches" / number / name;
      std::error_code failed;
      if (!fs::is_regular_file(file, failed)) continue;
      const Result<std::string> bytes = readFile(file);
      same += bytes && sha256(*bytes) == hash ? 1 : 0;
    }
    return same > 0 && isAThird(same, made_from_);
  }

 private:
  const fs::path& project_;
  const Hashes& made_from_;
  const std::stop_token& stop_;
};

std::map<store::BatchRow, std::set<std::string>> photographsAmong(
    const std::vector<records::FileRecord>& files) {
  std::map<store::BatchRow, std::set<std::string>> hashes;
  for (const records::FileRecord& file : files)
    if (file.role == "photo" && file.batch) hashes[file.batch].insert(file.sha256);
  return hashes;
}

bool hasFiles(const fs::path& folder) {
  for (const char* side : {"front", "back", "top_images", "bottom_images"}) {
    std::error_code failed;
    if (fs::directory_iterator(folder / side, failed) != fs::directory_iterator()) return true;
  }
  return false;
}

}  // namespace

Result<void> checkResultsAreOf(const catalogue::Catalogue& catalogue, const fs::path& project,
                               const records::BatchRecord& batch, const fs::path& out,
                               const std::stop_token& stop) {
  return catalogue.database().asResult([&] {
    const Hashes made_from = valueOrThrow(readFrom(out));
    if (made_from.empty()) return;
    const catalogue::Files files(catalogue);
    const Owners owners(project, made_from, stop);
    auto recorded = photographsAmong(valueOrThrow(files.of(batch.row)));
    if (owners.own(recorded[batch.row]) || valueOrThrow(owners.own(batch.number))) return;
    recorded = photographsAmong(valueOrThrow(files.all()));
    for (const records::BatchRecord& other : valueOrThrow(catalogue::Batches(catalogue).all())) {
      if (other.row == batch.row) continue;
      if (owners.own(recorded[other.row]) || valueOrThrow(owners.own(other.number)))
        store::refuse(
            message("These results were made from the photographs of %1, not of %2; process %3 "
                    "itself.",
                    other.number, batch.number, batch.number),
            out);
    }
    if (!recorded[batch.row].empty() || hasFiles(project / "batches" / batch.number))
      store::refuse(
          message("These results were not made from the photographs of %1; process it again.",
                  batch.number),
          out);
  });
}

}  // namespace ostraka::intake
