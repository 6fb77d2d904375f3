#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/catalogue.h"
#include "decisions/mask_strokes.h"
#include "records/records.h"

namespace ostraka::intake {

/// A computed batch is done when nobody needs to look, nothing needs to be computed and its scale
/// is not in doubt, and wants a person otherwise. One that is being shot, waits or failed is left
/// as it is.
Result<void> settleBatch(catalogue::Catalogue& catalogue, const std::string& batch_number,
                         const std::string& person, bool nothing_to_do);

/// The same by what OUT of the batch says now, with the figures that are shown of it. Returns
/// whether it wants to be computed. Errors: results that cannot be read.
Result<bool> settleByResults(catalogue::Catalogue& catalogue, const std::string& batch_number,
                             const std::filesystem::path& output, const std::string& person);
/// Opens the project by itself: callable in any thread.
Result<bool> settleByResults(const std::filesystem::path& project, const std::string& batch_number,
                             const std::string& person);

/// So that a merge does not bring back strokes that a person took away from masks: the history
/// tells which list of a photograph was left for which. Of a list that only got longer it tells
/// nothing.
Result<void> rememberTakenStrokes(const catalogue::Catalogue& catalogue,
                                  const std::string& batch_number,
                                  const std::vector<decisions::MaskStroke>& before,
                                  const std::vector<decisions::MaskStroke>& after,
                                  const records::Provenance& provenance);

/// Writes the strokes of a batch by `write`, so that the catalogue tells all the while of none that
/// the file lacks. What the catalogue cannot take is no error: the file is as it is wanted, though
/// a merge may bring back what was taken away. Errors: those of `write`.
Result<void> saveStrokes(const catalogue::Catalogue& catalogue, const std::string& batch_number,
                         const std::vector<decisions::MaskStroke>& before,
                         const std::vector<decisions::MaskStroke>& after,
                         const records::Provenance& provenance,
                         const std::function<Result<void>()>& write);

/// The catalogue learns of strokes that OUT has beyond those it knows; where it lacks some of
/// those it learns nothing.
Result<void> followStrokes(const catalogue::Catalogue& catalogue, const std::string& batch_number,
                           const std::filesystem::path& output);

}  // namespace ostraka::intake
