#pragma once
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"

namespace ostraka::intake {

struct EnteredResults {
  int scans = 0, decisions = 0, new_sherds = 0, models = 0, measurements = 0, files = 0;
  int kept_decisions = 0;          ///< pairs where the person's word stayed above the program's
  int open = 0;                    ///< pairs and scans that want a person
  bool decided_meanwhile = false;  ///< what the computation did not know is to be computed
  std::vector<std::string> numbers_left;     ///< typed on the plate, but no sherd lies there
  std::optional<Message> other_photographs;  ///< single ones differ; the batch is to be reviewed
  std::optional<Message> more_photographs;   ///< the batch has more than they were made from
};

/// Reads OUT of `ostraka process` (pairs.json, report.json, the models) into the catalogue: scans,
/// the program's pair decisions, draft sherds, measurements, files with their hashes. Doing it
/// twice changes nothing; what a person decided is kept. `out` lies in the project's folder.
/// The photographs that they were made from are recorded, too, where they are whole (as
/// enterPhotographs does). The batch's state becomes Review when something wants a person, else
/// Done. Errors: also UnusableInput for results of another batch's or earlier photographs
/// (checkResultsAreOf), and for photographs that another batch has, too (checkNotShared).
Result<EnteredResults> enterResults(catalogue::Catalogue& catalogue,
                                    const std::filesystem::path& project, store::BatchRow batch,
                                    const std::filesystem::path& out,
                                    const records::Provenance& provenance, Progress& progress,
                                    std::stop_token stop);

/// Enters the results of a batch again if a sherd with both sides has no model in the catalogue, as
/// after a pair was given up and taken back; the batch's own state stays what it is. False: none
/// lacks one, or there are no whole results.
Result<bool> enterLostModels(const std::filesystem::path& project, const std::string& batch,
                             Progress& progress, std::stop_token stop);

/// The photographs of a batch folder as rows, with their files and hashes; idempotent.
Result<int> enterPhotographs(catalogue::Catalogue& catalogue, const std::filesystem::path& project,
                             store::BatchRow batch, const records::Provenance& provenance,
                             Progress& progress, std::stop_token stop);

}  // namespace ostraka::intake
