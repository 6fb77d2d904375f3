#include "intake/settle_batch.h"

#include <algorithm>

#include "catalogue/batches.h"
#include "catalogue/history.h"
#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "intake/batch_figures.h"
#include "review/review.h"
#include "store/database.h"
#include "upkeep/project.h"

namespace ostraka::intake {

namespace fs = std::filesystem;

namespace {

// Nothing of results that are no batch's.
Result<void> knowStrokes(const catalogue::Catalogue& catalogue, const std::string& batch_number,
                         const std::vector<decisions::MaskStroke>& strokes) {
  if (const auto batch = catalogue::Batches(catalogue).byNumber(batch_number); !batch)
    return batch.error();
  const std::string key = decisions::kKnownStrokes + batch_number;
  catalogue::Settings settings(catalogue);
  const Result<std::string> known = settings.value(key);
  if (!known) return known.error();
  if (strokes.empty() && known->empty()) return {};
  const std::string text = decisions::knownText(strokes);
  return text == *known ? Result<void>() : settings.setValue(key, text);
}

}  // namespace

Result<void> settleBatch(catalogue::Catalogue& catalogue, const std::string& batch_number,
                         const std::string& person, bool nothing_to_do) {
  // In one step: the queue may take the batch meanwhile.
  return catalogue.database().inTransaction([&] {
    const records::BatchRecord batch =
        store::valueOrThrow(catalogue::Batches(catalogue).byNumber(batch_number));
    if (batch.state != records::BatchState::Review && batch.state != records::BatchState::Done)
      return;
    const records::BatchState state = nothing_to_do && batch.scale_doubts.empty()
                                          ? records::BatchState::Done
                                          : records::BatchState::Review;
    if (state == batch.state) return;
    records::Provenance provenance{{}, "window", {}};
    if (!person.empty())
      provenance.person = store::valueOrThrow(catalogue::People(catalogue).byInitials(person, {}));
    store::valueOrThrow(catalogue::Batches(catalogue).setState(batch.row, state, provenance));
  });
}

Result<bool> settleByResults(catalogue::Catalogue& catalogue, const std::string& batch_number,
                             const fs::path& output, const std::string& person) {
  const Result<review::Review> review = review::loadReview(output);
  if (!review) return review.error();
  const bool wants_computing = review::wantsComputing(output);
  BatchFigures figures = keptFigures(catalogue, batch_number).value_or(BatchFigures{});
  figures.take(review::countsOf(*review));
  return catalogue.database().inTransaction([&] {
    store::valueOrThrow(keepFigures(catalogue, batch_number, figures));
    store::valueOrThrow(
        settleBatch(catalogue, batch_number, person, figures.ask == 0 && !wants_computing));
    return wants_computing;
  });
}

Result<bool> settleByResults(const fs::path& project, const std::string& batch_number,
                             const std::string& person) {
  Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(project);
  if (!catalogue) return catalogue.error();
  return settleByResults(*catalogue, batch_number, project / "results" / batch_number, person);
}

Result<void> rememberTakenStrokes(const catalogue::Catalogue& catalogue,
                                  const std::string& batch_number,
                                  const std::vector<decisions::MaskStroke>& before,
                                  const std::vector<decisions::MaskStroke>& after,
                                  const records::Provenance& provenance) {
  return catalogue.database().inTransaction([&] {
    const records::BatchRecord batch =
        store::valueOrThrow(catalogue::Batches(catalogue).byNumber(batch_number));
    auto now = decisions::byPhotograph(after);
    for (const auto& [photograph, strokes] : decisions::byPhotograph(before)) {
      const std::vector<decisions::MaskStroke>& rest = now[photograph];
      const auto same = std::mismatch(strokes.begin(), strokes.end(), rest.begin(), rest.end());
      // Each list that there was on the way to this one: the other project may have it still.
      for (auto end = same.first; end != strokes.end(); ++end)
        catalogue::remember(catalogue, provenance, "batch", batch.row.value,
                            decisions::kStrokesField + photograph.name(),
                            decisions::hashOf({strokes.begin(), std::next(end)}),
                            decisions::hashOf(rest));
    }
  });
}

Result<void> saveStrokes(const catalogue::Catalogue& catalogue, const std::string& batch_number,
                         const std::vector<decisions::MaskStroke>& before,
                         const std::vector<decisions::MaskStroke>& after,
                         const records::Provenance& provenance,
                         const std::function<Result<void>()>& write) {
  const Result<std::string> known =
      catalogue::Settings(catalogue).value(decisions::kKnownStrokes + batch_number);
  // Of a file that lost some of them, these are still missed afterwards.
  const bool whole = known && decisions::haveKnown(before, *known);
  if (whole) (void)knowStrokes(catalogue, batch_number, decisions::commonStart(before, after));
  if (Result<void> written = write(); !written) return written;
  (void)rememberTakenStrokes(catalogue, batch_number, before, after, provenance);
  if (whole) (void)knowStrokes(catalogue, batch_number, after);
  return {};
}

Result<void> followStrokes(const catalogue::Catalogue& catalogue, const std::string& batch_number,
                           const fs::path& output) {
  const auto strokes = decisions::readMaskStrokes(output);
  if (!strokes) return strokes.error();
  const Result<std::string> known =
      catalogue::Settings(catalogue).value(decisions::kKnownStrokes + batch_number);
  if (!known) return known.error();
  return decisions::haveKnown(*strokes, *known) ? knowStrokes(catalogue, batch_number, *strokes)
                                                : Result<void>();
}

}  // namespace ostraka::intake
