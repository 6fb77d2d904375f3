#include "stages/output_folder.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "base/message.h"
#include "batch/peoples_files.h"
#include "files/files.h"
#include "files/json.h"
#include "files/json_text.h"
#include "files/output_place.h"

namespace ostraka::stages {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kScansFile = "scans.json";  // in OUT/work, of register
constexpr const char* kRegister = "register";
constexpr std::string_view kFolders[] = {"work", "sherds", "unpaired"};

std::string nameOf(const fs::path& file, const batch::Batch& batch) {
  return file.lexically_proximate(batch.folder).generic_string();
}

enum class PeoplesFiles { None, Kept };

// New, empty, or as a run leaves it that was killed before it could name what its results are of:
// with the lock and files that have no last name yet, if it came that far. Of a batch whose results
// were deleted to be computed anew, what people decided is kept, and who decides holds it. Other
// names prove no owner.
bool isUntouched(const fs::path& output, PeoplesFiles peoples) {
  std::error_code failed;
  if (!fs::exists(output, failed)) return true;
  for (const fs::directory_entry& entry : fs::directory_iterator(output, failed)) {
    const std::string name = entry.path().filename().string();
    const bool kept = peoples == PeoplesFiles::Kept &&
                      (name == kLockFile ||
                       std::find(std::begin(batch::kPeoplesFiles), std::end(batch::kPeoplesFiles),
                                 name) != std::end(batch::kPeoplesFiles));
    if (!kept && (name != "work" || !entry.is_directory(failed))) return false;
  }
  if (failed || !fs::exists(output / "work", failed)) return !failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(output / "work", failed)) {
    const std::string name = entry.path().filename().string();
    if (name != kLockFile && !name.starts_with('.')) return false;
  }
  return !failed;
}

// An OUT belongs to one batch. It is the same one while a third of its photographs are the same:
// one side may have been shot again. Plate and calibration are those of many batches.
Result<void> mayUseOutput(const fs::path& output, const fs::path& file, const batch::Batch& batch,
                          const ordered_json& hashes) {
  std::error_code failed;
  if (!fs::exists(file, failed)) {
    if (!isUntouched(output, PeoplesFiles::Kept))
      return Error::unusable(
          message("The output folder contains files that Ostraka did not write; choose another or "
                  "an empty one."),
          output.string());
  } else if (const Result<std::string> text = readFile(file)) {
    const ordered_json earlier = orderedJsonOrDiscarded(*text);
    std::size_t same = 0;
    for (const batch::Shot& shot : batch.shots) {
      const std::string name = nameOf(shot.file, batch);
      if (earlier.is_object() && earlier.contains(name) && earlier[name] == hashes[name]) ++same;
    }
    if (3 * same < batch.shots.size())
      return Error::unusable(
          message("The output folder contains another batch; choose another folder."),
          output.string());
  } else {
    return text.error();
  }
  return {};
}

bool holds(const fs::path& file, const char* key, const std::string& value) {
  const Result<nlohmann::json> earlier = readJson(file);
  return earlier && earlier->is_object() && earlier->contains(key) && earlier->at(key) == value;
}

// file: names what the results are of.
Result<FolderLock> claimed(const fs::path& output, const fs::path& file,
                           const ordered_json& content) {
  Result<FolderLock> held = FolderLock::take(output / "work");
  if (!held && held.error().where == (output / "work").string())  // a person named OUT
    return Error{held.error().code, held.error().what, output.string()};
  if (!held) return held;
  if (const Result<void> written = writeJson(file, content); !written) return written.error();
  return held;
}

}  // namespace

std::string photographsHash(const batch::Batch& batch, const ordered_json& hashes,
                            batch::Side side) {
  std::string all;
  for (const batch::Shot& shot : batch.shots)
    if (shot.side == side) {
      const std::string name = nameOf(shot.file, batch);
      all += name + ":" + hashes[name].get<std::string>() + "\n";
    }
  return sha256(all);
}

Result<FolderLock> claimOutput(const fs::path& output, const batch::Batch& batch,
                               const ordered_json& hashes) {
  if (const Result<void> own = checkNoLinkedFolder(output, kFolders, LinkedFolders::AndBelow); !own)
    return own.error();
  const fs::path file = output / kInputsRecord;
  if (const Result<void> may = mayUseOutput(output, file, batch, hashes); !may) return may.error();
  return claimed(output, file, hashes);
}

Result<FolderLock> claimOutput(const fs::path& output, const std::string& scans_hash) {
  if (const Result<void> own = checkNoLinkedFolder(output, kFolders, LinkedFolders::AndBelow); !own)
    return own.error();
  const fs::path file = output / "work" / kScansFile;
  if (!isUntouched(output, PeoplesFiles::None) && !holds(file, "inputs_hash", scans_hash) &&
      !holds(output / "report.json", "inputs_hash", scans_hash))
    return Error::unusable(
        holds(file, "command", kRegister)
            ? message("The output folder contains the results of other scans, or of these before a "
                      "file was changed, renamed, added or removed; choose another folder.")
            : message("The output folder contains other files; choose a new or empty folder."),
        output.string());
  return claimed(output, file, {{"command", kRegister}, {"inputs_hash", scans_hash}});
}

Error outputGone(const fs::path& output) {
  return {
      ErrorCode::CannotWrite,
      message(
          "The output folder is gone: it was moved or deleted while Ostraka was writing to it. The "
          "photographs are untouched; run the same command again."),
      output.string()};
}

void leaveGoneOutput(const fs::path& output) {
  withdrawResults(output);
  std::error_code ignored;
  for (const fs::path& folder : {output / "work", output / "sherds", output})
    fs::remove(folder, ignored);  // only what is empty
}

bool isUnpairedScan(const std::string& name) {
  const std::size_t digits = name.find_first_not_of("0123456789", 1);
  return (name.starts_with('f') || name.starts_with('b')) && digits > 3 &&
         digits != std::string::npos && name.substr(digits) == ".ply";
}

void withdrawResults(const fs::path& output) {
  std::error_code ignored;
  for (const char* name : {"report.json", "report.html", "pairs.json", kReportsRecord})
    fs::remove(output / name, ignored);
  std::vector<fs::path> scans;  // people may have put other files beside them
  for (const fs::directory_entry& entry : fs::directory_iterator(output / "unpaired", ignored)) {
    const std::string name = entry.path().filename().string();
    const bool partial = name.starts_with('.') && name.ends_with(".partial") &&
                         isUnpairedScan(name.substr(1, name.find(".ply") + 3));
    if (isUnpairedScan(name) || partial) scans.push_back(entry.path());
  }
  for (const fs::path& scan : scans) fs::remove(scan, ignored);
  fs::remove(output / "unpaired", ignored);  // only if it is empty
}

}  // namespace ostraka::stages
