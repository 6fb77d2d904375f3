#include "stages/stage.h"

#include <algorithm>
#include <chrono>

#include "base/memory.h"
#include "base/message.h"
#include "files/files.h"
#include "files/json.h"
#include "files/json_message.h"
#include "files/json_numbers.h"
#include "files/json_text.h"
#include "stages/output_folder.h"

namespace ostraka::stages {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr int kFormat = 1;  // of stage.json and the artefacts beside it
constexpr const char* kProgram =
    OSTRAKA_VERSION;  // a new version computes anew: results may differ
constexpr const char* kWhole = "stage.json";
constexpr const char* kBegun = "begun.json";  // before the first file

// Names (relative) and SHA-256 of all files of a stage but its records, in the order of names.
Result<ordered_json> hashesOf(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      names.push_back(fs::relative(entry.path(), folder).generic_string());
  std::sort(names.begin(), names.end());
  ordered_json hashes = ordered_json::object();
  for (const std::string& name : names) {
    if (name == kWhole || name == kBegun) continue;
    const Result<std::string> bytes = readFile(folder / name);
    if (!bytes) return bytes.error();
    hashes[name] = sha256(*bytes);
  }
  return hashes;
}

std::string outputsHash(const ordered_json& files, const ordered_json& figures) {
  return sha256(files.dump() + figures.dump());
}

std::optional<StageRecord> wholeRecord(const fs::path& folder, const std::string& key_hash) {
  const Result<std::string> text = readFile(folder / kWhole);
  if (!text) return {};
  const ordered_json stage = orderedJsonOrDiscarded(*text);
  if (!stage.is_object() || !stage.contains("key") || stage["key"] != key_hash) return {};
  const Result<ordered_json> files = hashesOf(folder);
  if (!files || !stage.contains("files") || *files != stage["files"]) return {};
  StageRecord record;
  try {
    record.notes.figures = stage.at("figures");
    Result<std::vector<Message>> warnings =
        messagesFromJson(stage.at("warnings"), (folder / kWhole).string());
    if (!warnings) return {};
    record.notes.warnings = *warnings;
    record.seconds = numberAt(stage, "seconds");
    record.peak_memory_mb = numberAt(stage, "peak_memory_mb");
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  record.outputs_hash = outputsHash(*files, record.notes.figures);
  return record;
}

bool isNamedBy(const fs::path& record, const std::string& name) {
  const Result<nlohmann::json> read = readJson(record);
  return read && read->is_object() && read->value("stage", nlohmann::json()) == name;
}

// A run that was killed before its first record leaves at most that record's unfinished file.
bool isOurs(const fs::path& folder, const std::string& name) {
  if (isNamedBy(folder / kWhole, name) || isNamedBy(folder / kBegun, name)) return true;
  std::error_code failed;
  if (!fs::exists(folder, failed)) return !failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed))
    if (!at->path().filename().string().starts_with("." + std::string(kBegun) + ".")) return false;
  return !failed;
}

// Empty but for its record. The record of a whole stage goes first, so that nothing half removed
// looks whole.
Result<void> begin(const fs::path& folder, const std::string& name) {
  if (!isOurs(folder, name))
    return Error::unusable(
        message("Ostraka needs this folder for its own files, but it contains others. They are "
                "unchanged; move them elsewhere, then start again."),
        folder.string());
  if (const Result<void> r = writeJson(folder / kBegun, {{"stage", name}}); !r) return r;
  std::error_code failed;
  fs::remove(folder / kWhole, failed);
  std::vector<fs::path> earlier;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed))
    if (at->path().filename() != kBegun) earlier.push_back(at->path());
  for (const fs::path& entry : earlier)
    if (!failed) fs::remove_all(entry, failed);
  if (failed) return cannotWrite(folder, failed.value());
  return {};
}

// What was written into an output folder that is gone; another's, put in its place, has records.
void leaveGoneStage(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / kWhole, ignored) && !fs::exists(folder / kBegun, ignored))
    fs::remove_all(folder, ignored);
}

}  // namespace

std::vector<Message> messagesAt(const ordered_json& figures, const char* key) {
  const auto list = figures.find(key);
  if (list == figures.end()) return {};
  Result<std::vector<Message>> read = messagesFromJson(*list, key);
  return read ? std::move(*read) : std::vector<Message>{Message(list->dump())};
}

Result<StageRecord> runStage(const FolderLock& held, const std::string& name,
                             const ordered_json& key, const StageWork& work, Progress& progress) {
  const fs::path folder = held.folder() / name;
  if (!held.stands()) return outputGone(held.folder().parent_path());
  const std::string key_hash =
      sha256(ordered_json{{"stage", name}, {"format", kFormat}, {"program", kProgram}, {"key", key}}
                 .dump());
  if (std::optional<StageRecord> record = wholeRecord(folder, key_hash)) {
    progress.note(NoteLevel::Info, name + ": reused from an earlier run");
    return std::move(*record);
  }
  if (const Result<void> begun = begin(folder, name); !begun) return begun.error();
  const auto start = std::chrono::steady_clock::now();
  const Result<StageNotes> notes = work(folder);
  if (!held.stands()) {
    leaveGoneStage(folder);
    return outputGone(held.folder().parent_path());
  }
  if (!notes) return notes.error();
  StageRecord record;
  record.notes = *notes;
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.peak_memory_mb = peakMemoryMb();
  const Result<ordered_json> files = hashesOf(folder);
  if (!files) return files.error();
  record.outputs_hash = outputsHash(*files, record.notes.figures);
  const Result<void> written =
      writeJson(folder / kWhole, {{"format", kFormat},
                                  {"program", kProgram},
                                  {"stage", name},
                                  {"key", key_hash},
                                  {"inputs", key},
                                  {"seconds", record.seconds},
                                  {"peak_memory_mb", record.peak_memory_mb},
                                  {"files", *files},
                                  {"figures", record.notes.figures},
                                  {"warnings", toJson(record.notes.warnings)}});
  if (!written) return written.error();
  return record;
}

}  // namespace ostraka::stages
