#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "decisions/decisions.h"
#include "intake/plate_sherds.h"
#include "sherds/photographed_again.h"

namespace ostraka::intake {

/// What a decision did, for whoever shows it.
struct AppliedDecision {
  decisions::PairDecision decision;  ///< as it stands in OUT/decisions.json
  std::string split_number;          ///< Split: the number that goes to one of the two; or empty
  JoinedNumbers joined;              ///< Join: which number is kept, which is left over
  /// A sherd that stands in the catalogue twice now: with what it was photographed again as, and
  /// with what the decision made.
  struct Twice {
    decisions::ScanRef scan;
    sherds::PhotographedAgain again;
  };
  std::vector<Twice> twice;
  /// The results do not follow it yet, or it cannot be told whether they do.
  bool wants_computing = false;
  /// Why the catalogue could not follow. The decision holds all the same: it stands in the file,
  /// and is entered when the batch is opened or computed.
  std::vector<Error> errors;
};

/// Takes a person's decision about a batch, from the first file to the last row: it is written to
/// decisions.json of its results (`output`), entered into the catalogue so that its sherds follow,
/// fragments that it takes back lose their models, and the batch's figures and state follow.
/// Errors: those of decisions::appendDecision; nothing is changed then.
Result<AppliedDecision> applyDecision(catalogue::Catalogue& catalogue,
                                      const std::string& batch_number,
                                      const std::filesystem::path& output,
                                      decisions::PairDecision decision);
/// The same where there is no catalogue: results in a folder of their own.
Result<AppliedDecision> applyToFileAlone(const std::filesystem::path& output,
                                         decisions::PairDecision decision);

}  // namespace ostraka::intake
