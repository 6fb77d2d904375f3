#include "stages/publish.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "batch/peoples_files.h"
#include "files/files.h"
#include "files/json.h"
#include "stages/output_folder.h"

namespace ostraka::stages {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kSherdFiles[] = {"front.ply", "back.ply",    "model.ply",
                                            "model.glb", "preview.png", "merged.ply"};

// Also one that a killed run left before it had its last name.
bool isOfASherd(const std::string& name) {
  for (const std::string_view file : kSherdFiles)
    if (name == file ||
        (name.starts_with("." + std::string(file) + ".") && name.ends_with(".partial")))
      return true;
  return false;
}

// People may have put files of their own beside the program's: those stay, and so does the folder.
void removeSherd(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> ours;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (isOfASherd(entry.path().filename().string())) ours.push_back(entry.path());
  for (const fs::path& file : ours) fs::remove(file, ignored);
  fs::remove(folder, ignored);  // only if it is empty
}

bool isSherdNumber(const std::string& name) {
  return name.size() >= 2 && name.find_first_not_of("0123456789") == std::string::npos;
}

constexpr std::string_view kFilesOfOut[] = {
    "report.json",
    "report.html",
    "pairs.json",
    "log.txt",
    "plate.json",  // of a sheet that was found in the photographs
    kReportsRecord,
    kInputsRecord,
    "work/scans.json",
    "work/lock",
    kLockFile,  // of who decides or paints
    "work/more_candidates.json",
    batch::kDecisionsFile,
    batch::kMaskStrokesFile};

bool isOfAStage(const fs::path& stage, const std::string& file) {
  if (file == "stage.json" || file == "begun.json") return true;
  const Result<nlohmann::json> record = readJson(stage / "stage.json");
  return record && record->is_object() &&
         record->value("files", nlohmann::json::object()).contains(file);
}

bool isOfARun(const fs::path& output, const fs::path& file) {
  if (std::find(std::begin(kFilesOfOut), std::end(kFilesOfOut), file.generic_string()) !=
      std::end(kFilesOfOut))
    return true;
  const std::vector<fs::path> parts(file.begin(), file.end());
  if (parts.size() == 2) return parts[0] == "unpaired" && isUnpairedScan(parts[1].string());
  if (parts.size() < 3) return false;
  if (parts[0] == "sherds")
    return parts.size() == 3 && isSherdNumber(parts[1].string()) && isOfASherd(parts[2].string());
  const fs::path stage = parts[0] / parts[1];
  return parts[0] == "work" &&
         isOfAStage(output / stage, file.lexically_relative(stage).generic_string());
}

}  // namespace

Result<void> publish(const FolderLock& held, const std::string& number, bool has_model) {
  const fs::path output = held.folder().parent_path(), to = output / "sherds" / number;
  struct Left {
    const char *stage, *name;
    bool is_there;
  };
  if (!held.stands()) return outputGone(output);
  for (const Left& left :
       {Left{"model_", "front.ply", true}, Left{"model_", "back.ply", true},
        Left{"model_", "model.ply", has_model}, Left{"texture_", "model.glb", has_model},
        Left{"texture_", "preview.png", has_model}}) {
    std::error_code failed;
    if (!left.is_there) {
      fs::remove(to / left.name, failed);
      continue;
    }
    const Result<std::string> bytes = readFile(held.folder() / (left.stage + number) / left.name);
    if (!bytes) return bytes.error();
    if (const Result<void> written = writeFileAtomically(to / left.name, *bytes); !written)
      return written;
  }
  if (held.stands()) return {};
  removeSherd(to);
  return outputGone(output);
}

Result<void> publishReports(const fs::path& output, const nlohmann::ordered_json& pairs,
                            const std::string& html, const nlohmann::ordered_json& report) {
  const std::string table = jsonText(pairs), figures = jsonText(report);
  const Result<std::string> inputs = readFile(output / kInputsRecord);
  if (!inputs) return inputs.error();
  const nlohmann::ordered_json hashes = {{kInputsRecord, sha256(*inputs)},
                                         {"pairs.json", sha256(table)},
                                         {"report.html", sha256(html)},
                                         {"report.json", sha256(figures)}};
  if (Result<void> r = writeFileAtomically(output / "pairs.json", table); !r) return r;
  if (Result<void> r = writeFileAtomically(output / "report.html", html); !r) return r;
  if (Result<void> r = writeJson(output / kReportsRecord, {{"files", hashes}}); !r) return r;
  return writeFileAtomically(output / "report.json", figures);
}

std::vector<std::string> filesOfOthers(const fs::path& output) {
  std::vector<std::string> others;
  std::error_code failed;
  for (fs::recursive_directory_iterator at(output, failed), end; !failed && at != end;
       at.increment(failed)) {
    const fs::path file = at->path().lexically_relative(output);
    const fs::file_type type = at->symlink_status(failed).type();
    const bool is_ours = type == fs::file_type::regular && isOfARun(output, file);
    if (type != fs::file_type::directory && !is_ours) others.push_back(file.generic_string());
  }
  std::sort(others.begin(), others.end());
  return others;
}

void removeStaleSherds(const fs::path& output, const std::set<std::string>& numbers) {
  std::error_code ignored;
  std::vector<fs::path> stale;
  for (const fs::directory_entry& entry : fs::directory_iterator(output / "sherds", ignored)) {
    const std::string name = entry.path().filename().string();
    if (isSherdNumber(name) && !numbers.contains(name)) stale.push_back(entry.path());
  }
  for (const fs::path& folder : stale) removeSherd(folder);
  fs::remove(output / "sherds", ignored);  // only if it is empty
}

}  // namespace ostraka::stages
