#include "intake/computed_again.h"

#include <algorithm>

#include "catalogue/catalogue.h"
#include "catalogue/sherd_columns.h"
#include "records/words.h"
#include "review/review.h"
#include "store/database.h"

namespace ostraka::catalogue {
namespace {

constexpr const char* kAsked = "yes";

std::string keyOf(const std::string& batch_number) {
  return "queue.again." + batch_number;
}

bool isComputed(BatchState state) {
  return state == BatchState::Review || state == BatchState::Done;
}

// The state that it had when it was queued; Queued when that is not known.
BatchState stateBefore(const Catalogue& catalogue, BatchRow batch) {
  const std::vector<HistoryEntry> history = valueOrThrow(catalogue.history("batch", batch.value));
  const auto queued = std::find_if(history.begin(), history.end(),
                                   [](const HistoryEntry& e) { return e.field == "state"; });
  return queued == history.end() ? BatchState::Queued : fromWord<BatchState>(queued->old_value);
}

}  // namespace

Result<void> queueAgain(Catalogue& catalogue, const std::string& batch_number,
                        const Provenance& provenance) {
  return catalogue.database().inTransaction([&] {
    const BatchRecord batch = valueOrThrow(catalogue.batchByNumber(batch_number));
    if (batch.state <= BatchState::Back)
      refuse("This batch is still being photographed; it is processed afterwards.", batch_number);
    // What waits cannot be told from what is being computed: both are so until their results are
    // entered. Where it only waits, its beginning forgets this.
    if (batch.state == BatchState::Queued || batch.state == BatchState::Computed)
      valueOrThrow(catalogue.setSetting(keyOf(batch_number), kAsked));
    valueOrThrow(catalogue.setBatchState(batch.row, BatchState::Queued, provenance));
  });
}

Result<void> beginComputing(Catalogue& catalogue, const std::string& batch_number) {
  const Result<std::string> asked = catalogue.setting(keyOf(batch_number));
  if (!asked) return asked.error();
  return asked->empty() ? Result<void>() : catalogue.setSetting(keyOf(batch_number), {});
}

Result<bool> queueIfAsked(Catalogue& catalogue, const std::string& batch_number,
                          const Provenance& provenance) {
  return catalogue.database().inTransaction([&] {
    if (valueOrThrow(catalogue.setting(keyOf(batch_number))) != kAsked) return false;
    valueOrThrow(catalogue.setSetting(keyOf(batch_number), {}));
    const BatchRecord batch = valueOrThrow(catalogue.batchByNumber(batch_number));
    if (!isComputed(batch.state)) return false;
    valueOrThrow(catalogue.setBatchState(batch.row, BatchState::Queued, provenance));
    return true;
  });
}

Result<bool> takeOutOfQueue(Catalogue& catalogue, const std::string& batch_number,
                            const std::filesystem::path& output, const Provenance& provenance) {
  return catalogue.database().inTransaction([&] {
    const BatchRecord batch = valueOrThrow(catalogue.batchByNumber(batch_number));
    if (batch.state != BatchState::Queued || !pipeline::computedToItsEnd(output)) return false;
    const BatchState before = stateBefore(catalogue, batch.row);
    if (!isComputed(before)) return false;
    valueOrThrow(catalogue.setBatchState(batch.row, before, provenance));
    return true;
  });
}

}  // namespace ostraka::catalogue
