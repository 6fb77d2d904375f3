#include "intake/apply_decision.h"

#include "intake/review_decisions.h"
#include "intake/settle_batch.h"

namespace ostraka::intake {
namespace {

using decisions::DecisionKind;

// Which numbers the fragments had, before the decision is entered.
void readNumbers(const catalogue::Catalogue& catalogue, const std::string& batch_number,
                 AppliedDecision& applied) {
  const decisions::PairDecision& decision = applied.decision;
  const PlateSherds sherds(catalogue, batch_number);
  applied.joined = sherds.afterJoin(decision);
  if (decision.kind != DecisionKind::Split) return;
  const decisions::ScanRef& cut = decision.scans.front();
  if (cut.side != batch::Side::Front) return;
  if (const records::SherdRecord* sherd = sherds.at(cut.place_mm))
    applied.split_number = sherd->number;
}

void findTwice(const catalogue::Catalogue& catalogue, const std::string& batch_number,
               AppliedDecision& applied) {
  const decisions::PairDecision& decision = applied.decision;
  if (decision.kind != DecisionKind::Pair && decision.kind != DecisionKind::Withdraw) return;
  const PlateSherds sherds(catalogue, batch_number);
  for (const decisions::ScanRef& scan : decision.scans) {
    if (scan.side != batch::Side::Front || sherds.at(scan.place_mm) == nullptr) continue;
    if (const sherds::PhotographedAgain* again = sherds.again(scan.place_mm))
      applied.twice.push_back({scan, *again});
  }
}

}  // namespace

Result<AppliedDecision> applyDecision(catalogue::Catalogue& catalogue,
                                      const std::string& batch_number,
                                      const std::filesystem::path& output,
                                      decisions::PairDecision decision) {
  Result<AppliedDecision> written = applyToFileAlone(output, std::move(decision));
  if (!written) return written;
  AppliedDecision& applied = *written;
  readNumbers(catalogue, batch_number, applied);
  const Result<void> entered = catalogue.together([&]() -> Result<void> {
    const Result<void> rows = enterDecision(catalogue, batch_number, applied.decision, output);
    if (!rows || applied.decision.kind != DecisionKind::Withdraw) return rows;
    return forgetPiecesOf(catalogue, batch_number, applied.decision, output);
  });
  if (!entered) applied.errors.push_back(entered.error());
  const Result<bool> wants_computing =
      settleByResults(catalogue, batch_number, output, applied.decision.by);
  if (!wants_computing) applied.errors.push_back(wants_computing.error());
  applied.wants_computing = !wants_computing || *wants_computing;
  findTwice(catalogue, batch_number, applied);
  return written;
}

Result<AppliedDecision> applyToFileAlone(const std::filesystem::path& output,
                                         decisions::PairDecision decision) {
  Result<decisions::PairDecision> written = decisions::appendDecision(output, std::move(decision));
  if (!written) return written.error();
  AppliedDecision applied;
  applied.decision = std::move(*written);
  return applied;
}

}  // namespace ostraka::intake
