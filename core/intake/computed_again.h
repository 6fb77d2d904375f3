#pragma once
#include <filesystem>
#include <string>

#include "base/progress.h"
#include "base/result.h"

namespace ostraka::catalogue {
class Catalogue;
}  // namespace ostraka::catalogue

namespace ostraka::records {
struct Provenance;
}  // namespace ostraka::records

namespace ostraka::intake {

/// The batch is to be computed again; the queue sees it. Where it is being computed just now it is
/// queued once more when that ends, for what was decided meanwhile. Errors: UnusableInput while it
/// is being photographed.
Result<void> queueAgain(catalogue::Catalogue& catalogue, const std::string& batch_number,
                        const records::Provenance& provenance);

/// `ostraka process` is about to write into OUT. Where that is PROJECT/results/NUMBER and the
/// results of that batch were entered, the batch is queued again, so that what the run replaces
/// does not count as damaged until it is entered, and a warning says how to enter it. Not on a
/// network share, where the nodes of a cluster must leave the catalogue alone. Errors: those of
/// Project::open.
Result<void> queueOwnerOf(const std::filesystem::path& output, Progress& progress);

/// What was asked so far is done by the computation that begins now.
Result<void> beginComputing(catalogue::Catalogue& catalogue, const std::string& batch_number);
/// At its end, when the results are entered: the batch is queued again if that was asked since.
/// Returns whether.
Result<bool> queueIfAsked(catalogue::Catalogue& catalogue, const std::string& batch_number,
                          const records::Provenance& provenance);

/// A batch that waits to be computed again is not to be: it is what it was before, for its review
/// or done. False, and nothing changes, where it is not as it was: it does not wait, it was
/// photographed (again) since, had failed, or its results in OUT are not whole any more.
Result<bool> takeOutOfQueue(catalogue::Catalogue& catalogue, const std::string& batch_number,
                            const std::filesystem::path& output,
                            const records::Provenance& provenance);

}  // namespace ostraka::intake
