#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "batch/photographs.h"
#include "files/files.h"

namespace ostraka::catalogue {

/// The checksums that a run leaves beside its results.
class NotedResults {
 public:
  /// A run read what lies in the batch's folder now.
  static void noteInputs(const std::filesystem::path& out, const std::filesystem::path& batch) {
    const batch::PhotographHashes photographs = *batch::photographsNow(batch, {});
    if (!photographs.empty())
      put(out / "work/batch.json", nlohmann::ordered_json(photographs).dump());
  }

  /// A run wrote the reports as they lie there now.
  static void noteReports(const std::filesystem::path& out) {
    nlohmann::ordered_json files;
    for (const char* name : {"report.json", "report.html", "pairs.json"})
      files[name] = sha256(*readFile(out / name));
    put(out / "work/reports.json", nlohmann::ordered_json({{"files", files}}).dump());
  }

  /// The stages that made this sherd's model and its texture left them as they lie there now.
  static void noteModel(const std::filesystem::path& out, const std::string& number) {
    const auto note = [&](const std::string& stage, const std::vector<std::string>& names) {
      nlohmann::ordered_json files;
      for (const std::string& file : names)
        files[file] = sha256(*readFile(out / "sherds" / number / file));
      put(out / "work" / (stage + number) / "stage.json",
          nlohmann::ordered_json({{"files", files}}).dump());
    };
    note("model_", {"model.ply"});
    note("texture_", {"model.glb", "preview.png"});
  }

 protected:
  static void put(const std::filesystem::path& path, const std::string& bytes) {
    if (!writeFileAtomically(path, bytes)) throw std::runtime_error(path.string());
  }
};

}  // namespace ostraka::catalogue
