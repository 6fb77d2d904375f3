#pragma once
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cluster/task_status.h"
#include "upkeep/project.h"

namespace ostraka::cluster {

struct Collected {
  std::vector<std::string> batches;  ///< entered now
  int sherds = 0;                    ///< of these batches
  int ask = 0;                       ///< pairs and scans that want a person
  std::vector<TaskStatus> left;      ///< the others that are not entered: waiting, running, failed
  std::vector<Message> warnings;
};

/// Enters the results that are whole as those that are computed here (intake::enterComputed), each
/// once; what people decided meanwhile stays. From another computer they come with checksums
/// beside the old results and take their place when all is there. Interrupted at any moment the
/// same call goes on. One batch that cannot be entered keeps back no other; where its results
/// cannot be used the next submission hands it over again. Errors: those of statusOf, Cancelled,
/// CannotWrite (a full disk here, or another run at work in the batch's results).
Result<Collected> collect(upkeep::Project& project, Progress& progress, std::stop_token stop);

/// Results in `folder`, which came from elsewhere, take the place of those of the batch: nothing
/// but regular files of usual names, and a report. decisions.json and mask_strokes.json stay those
/// of the batch. Errors: UnusableInput, which names the file; CannotWrite.
Result<void> takePlace(const upkeep::Project& project, const std::string& batch,
                       const std::filesystem::path& folder);

}  // namespace ostraka::cluster
