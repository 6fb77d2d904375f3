#pragma once
#include <filesystem>
#include <set>
#include <string>

#include "base/result.h"
#include "decisions/decisions.h"
#include "records/records.h"

namespace ostraka::catalogue {
class Catalogue;
}  // namespace ostraka::catalogue

namespace ostraka::intake {

/// Enters what a person decided into the catalogue's append-only list, so that the sherds follow.
/// A decision about several scans becomes a row each; joins and cuts go into the list of pieces.
/// Errors: Missing when the batch or its scans are not entered yet, and when the decision has no
/// effect on the results in OUT: it is about earlier photographs, or about a piece that is gone.
Result<void> enterDecision(catalogue::Catalogue& catalogue, const std::string& batch_number,
                           const decisions::PairDecision& decision,
                           const std::filesystem::path& output);

/// What the catalogue holds of OUT/decisions.json follows the file and these results: rows are
/// added for decisions that hold in them and are not there (taken while the batch was computed,
/// without a catalogue, or when it was busy), and for the end of those that hold no more: taken
/// back, about a piece that is gone, or about earlier photographs. What the file does not name
/// stays: persons decide in the catalogue, too, and on other computers. Returns the rows added.
/// Errors: a file that cannot be read, the batch is not there.
Result<int> followDecisions(catalogue::Catalogue& catalogue, const std::string& batch_number,
                            const std::filesystem::path& output);

/// The same for a batch that is opened again: whoever decides writes the file first, and may not
/// come to the catalogue (a crash, a full disk). Opens the project by itself: callable in any
/// thread. Nothing for one that is not in the catalogue, or neither done nor to be reviewed: what
/// computes it enters them, too.
Result<int> catchUp(const std::filesystem::path& project, const std::string& batch_number,
                    const std::filesystem::path& output);

/// The pieces that were made by joins and cuts which the results of OUT followed, and which hold no
/// more: they were taken back since, or while it was computed.
Result<std::set<store::ScanRow>> piecesTakenBack(const catalogue::Catalogue& catalogue,
                                                 store::BatchRow batch,
                                                 const std::filesystem::path& output);
/// The sherds of these pieces lose the models and measures that were made of them.
Result<void> forgetModelsOf(catalogue::Catalogue& catalogue, store::BatchRow batch,
                            const std::set<store::ScanRow>& pieces,
                            const records::Provenance& provenance);
/// Both, after a withdrawal. Nothing where what it ended was not computed.
Result<void> forgetPiecesOf(catalogue::Catalogue& catalogue, const std::string& batch_number,
                            const decisions::PairDecision& withdrawal,
                            const std::filesystem::path& output);

}  // namespace ostraka::intake
