#include "catalogue/queue_pause.h"

#include <algorithm>
#include <string>
#include <vector>

#include "catalogue/batches.h"
#include "catalogue/settings.h"

namespace ostraka::catalogue {
namespace {

using records::BatchState;

constexpr const char* kKey = "queue.paused";
constexpr const char* kByPerson = "yes";
constexpr const char* kRestored = "restored";

const char* wordOf(QueuePause pause) {
  return pause == QueuePause::ByPerson ? kByPerson : pause == QueuePause::Restored ? kRestored : "";
}

}  // namespace

Result<QueuePause> queuePause(const Catalogue& catalogue) {
  const Result<std::string> word = Settings(catalogue).value(kKey);
  if (!word) return word.error();
  return *word == kByPerson   ? QueuePause::ByPerson
         : *word == kRestored ? QueuePause::Restored
                              : QueuePause::None;
}

Result<void> setQueuePause(Catalogue& catalogue, QueuePause pause,
                           const records::Provenance& provenance) {
  return Settings(catalogue).setValue(kKey, wordOf(pause), provenance);
}

Result<int> batchesInQueue(const Catalogue& catalogue) {
  const Result<std::vector<records::BatchRecord>> batches = Batches(catalogue).all();
  if (!batches) return batches.error();
  return static_cast<int>(std::count_if(batches->begin(), batches->end(), [](const auto& batch) {
    return batch.state == BatchState::Queued || batch.state == BatchState::Computed;
  }));
}

Result<void> pauseRestoredQueue(Catalogue& catalogue) {
  const Result<int> waiting = batchesInQueue(catalogue);
  if (!waiting) return waiting.error();
  return *waiting > 0 ? Settings(catalogue).setValue(kKey, kRestored) : Result<void>();
}

}  // namespace ostraka::catalogue
