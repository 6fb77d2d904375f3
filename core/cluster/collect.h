#pragma once
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cluster/access.h"
#include "cluster/task_status.h"
#include "upkeep/project.h"

namespace ostraka::cluster {

struct Collected {
  std::vector<std::string> batches;  ///< entered now
  int sherds = 0;                    ///< of these batches
  int ask = 0;                       ///< pairs and scans that need review
  std::vector<TaskStatus> left;      ///< the others that are not entered: waiting, running, failed
  std::vector<Message> warnings;
};

/// Enters complete results like those processed here (intake::enterComputed), each once; decisions
/// that people made in the meantime are kept. Results from another computer are copied with
/// checksums beside the old ones and replace them once complete. If interrupted at any moment, the
/// same call resumes. A batch that cannot be entered does not hold up the others; if its results
/// cannot be used, or it was photographed again since it was submitted, it is not entered, and the
/// next submission includes it again. Errors: those of reach and statusOf, Cancelled,
/// CannotWrite (a full disk here, or another run at work in the batch's results).
Result<Collected> collect(upkeep::Project& project, const Access& access, Progress& progress,
                          std::stop_token stop);

/// Results in `folder`, which came from elsewhere, replace those of the batch: only regular files
/// with plain names, and a report. Files that no run writes (stages::filesOfOthers) are deleted
/// from `folder`, and a warning names them. The batch keeps its decisions.json and
/// mask_strokes.json; its results of before wait in cluster/replaced until the new ones are
/// entered. Errors: UnusableInput, which names the file; CannotWrite.
Result<void> takePlace(const upkeep::Project& project, const std::string& batch,
                       const std::filesystem::path& folder, Progress& progress);

}  // namespace ostraka::cluster
