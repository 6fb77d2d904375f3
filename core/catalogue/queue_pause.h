#pragma once
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"

namespace ostraka::catalogue {

/// Whether the window computes the batches that wait in the project's queue, and why not.
enum class QueuePause {
  None,
  ByPerson,
  Restored,  ///< the project came out of an archive: perhaps a copy to look at, so nothing begins
};

/// Errors: the catalogue cannot be read.
Result<QueuePause> queuePause(const Catalogue& catalogue);
/// What a person wants. Error: the catalogue cannot be written.
Result<void> setQueuePause(Catalogue& catalogue, QueuePause pause,
                           const records::Provenance& provenance);
/// How many batches are photographed and wait to be processed, or are processed now.
Result<int> batchesInQueue(const Catalogue& catalogue);
/// Of a project that was just restored; where no batch waits, its queue is left as it is.
Result<void> pauseRestoredQueue(Catalogue& catalogue);

}  // namespace ostraka::catalogue
