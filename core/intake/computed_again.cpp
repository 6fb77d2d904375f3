#include "intake/computed_again.h"

#include <algorithm>

#include "base/message.h"
#include "catalogue/batches.h"
#include "catalogue/catalogue.h"
#include "catalogue/history.h"
#include "catalogue/settings.h"
#include "records/records.h"
#include "records/sherd.h"
#include "records/words.h"
#include "review/review.h"
#include "store/database.h"

namespace ostraka::intake {
namespace {

constexpr const char* kAsked = "yes";

std::string keyOf(const std::string& batch_number) {
  return "queue.again." + batch_number;
}

bool isComputed(records::BatchState state) {
  return state == records::BatchState::Review || state == records::BatchState::Done;
}

// The state that it had when it was queued; Queued when that is not known.
records::BatchState stateBefore(const catalogue::Catalogue& catalogue, store::BatchRow batch) {
  const std::vector<records::HistoryEntry> history =
      store::valueOrThrow(catalogue::History(catalogue).of("batch", batch.value));
  const auto queued =
      std::find_if(history.begin(), history.end(),
                   [](const records::HistoryEntry& e) { return e.field == "state"; });
  return queued == history.end() ? records::BatchState::Queued
                                 : records::fromWord<records::BatchState>(queued->old_value);
}

}  // namespace

Result<void> queueAgain(catalogue::Catalogue& catalogue, const std::string& batch_number,
                        const records::Provenance& provenance) {
  return catalogue.database().inTransaction([&] {
    const records::BatchRecord batch =
        store::valueOrThrow(catalogue::Batches(catalogue).byNumber(batch_number));
    if (batch.state <= records::BatchState::Back)
      store::refuse(message("This batch is still being photographed; it is processed afterwards."),
                    batch_number);
    // What waits cannot be told from what is being computed: both are so until their results are
    // entered. Where it only waits, its beginning forgets this.
    if (batch.state == records::BatchState::Queued || batch.state == records::BatchState::Computed)
      store::valueOrThrow(catalogue::Settings(catalogue).setValue(keyOf(batch_number), kAsked));
    store::valueOrThrow(
        catalogue::Batches(catalogue).setState(batch.row, records::BatchState::Queued, provenance));
  });
}

Result<void> beginComputing(catalogue::Catalogue& catalogue, const std::string& batch_number) {
  const Result<std::string> asked = catalogue::Settings(catalogue).value(keyOf(batch_number));
  if (!asked) return asked.error();
  return asked->empty() ? Result<void>()
                        : catalogue::Settings(catalogue).setValue(keyOf(batch_number), {});
}

Result<bool> queueIfAsked(catalogue::Catalogue& catalogue, const std::string& batch_number,
                          const records::Provenance& provenance) {
  return catalogue.database().inTransaction([&] {
    if (store::valueOrThrow(catalogue::Settings(catalogue).value(keyOf(batch_number))) != kAsked)
      return false;
    store::valueOrThrow(catalogue::Settings(catalogue).setValue(keyOf(batch_number), {}));
    const records::BatchRecord batch =
        store::valueOrThrow(catalogue::Batches(catalogue).byNumber(batch_number));
    if (!isComputed(batch.state)) return false;
    store::valueOrThrow(
        catalogue::Batches(catalogue).setState(batch.row, records::BatchState::Queued, provenance));
    return true;
  });
}

Result<bool> takeOutOfQueue(catalogue::Catalogue& catalogue, const std::string& batch_number,
                            const std::filesystem::path& output,
                            const records::Provenance& provenance) {
  return catalogue.database().inTransaction([&] {
    const records::BatchRecord batch =
        store::valueOrThrow(catalogue::Batches(catalogue).byNumber(batch_number));
    if (batch.state != records::BatchState::Queued || !review::computedToItsEnd(output))
      return false;
    const records::BatchState before = stateBefore(catalogue, batch.row);
    if (!isComputed(before)) return false;
    store::valueOrThrow(catalogue::Batches(catalogue).setState(batch.row, before, provenance));
    return true;
  });
}

}  // namespace ostraka::intake
