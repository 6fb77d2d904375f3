#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "decisions/decisions.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::intake {

struct ReadFile {
  records::FileRecord record;
  std::string sherd_front;  ///< the scan that its sherd is known by; empty: of the batch
  std::string sherd_back;
};
struct ReadSherd {
  std::string front, back, folder, model_path, preview_path, model_sha256;
  std::map<std::string, double> measures;
};
struct ReadResults {
  std::vector<records::ScanRecord> scans;
  decisions::Decisions edits;  ///< joins and cuts of these photographs, also those taken back
  std::vector<records::PairDecision> pairs;
  std::vector<std::pair<std::string, std::string>> pair_names;
  std::vector<ReadSherd> sherds;
  std::vector<ReadFile> files;
  std::optional<double> reprojection_px, scale_error_pct;
  Message scale;  ///< what makes it
  std::vector<Message> scale_doubts;
};

/// What a whole OUT of `ostraka process` holds for the catalogue. Everything is read and hashed
/// before the transaction begins, which must be short; models are kept (keepModel) if they are as
/// the stages that made them noted, and so must be scans and reports. A file that is missing, empty
/// or a link enters nothing. Throws Refused.
ReadResults readResults(const std::filesystem::path& project, const records::BatchRecord& batch,
                        const std::filesystem::path& out, Progress& progress, std::stop_token stop);

/// Relative to the project with '/', as records hold it; throws Refused outside it.
std::string relativeTo(const std::filesystem::path& project, const std::filesystem::path& file);
std::string mediaTypeOf(const std::filesystem::path& file);

}  // namespace ostraka::intake
