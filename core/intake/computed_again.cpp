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
#include "store/network_share.h"
#include "upkeep/project.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;

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
  const auto queued = std::ranges::find_if(
      history, [](const records::HistoryEntry& e) { return e.field == "state"; });
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

Result<void> queueOwnerOf(const fs::path& output, Progress& progress) {
  std::error_code failed;
  fs::path out = fs::weakly_canonical(output, failed);
  if (!out.has_filename()) out = out.parent_path();
  const fs::path project = out.parent_path().parent_path();
  const std::string number = out.filename().string();
  if (failed || out.parent_path().filename() != "results" ||
      !fs::exists(project / "catalogue.sqlite", failed) || !store::networkShareOf(project).empty())
    return {};
  Result<upkeep::Project> opened = upkeep::Project::open(project);
  if (!opened) return opened.error();
  catalogue::Batches batches(opened->catalogue());
  return opened->catalogue().database().inTransaction([&] {
    for (const records::BatchRecord& batch : store::valueOrThrow(batches.all())) {
      if (batch.number != number || !isComputed(batch.state)) continue;
      store::valueOrThrow(
          batches.setState(batch.row, records::BatchState::Queued, {{}, "process", {}}));
      progress.note(
          NoteLevel::Warning,
          message("The catalogue has earlier results of %1, and the batch is queued again. Enter "
                  "the new ones with 'ostraka catalogue enter', or reprocess it in the window.",
                  number));
    }
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
