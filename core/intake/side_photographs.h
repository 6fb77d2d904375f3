#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/result.h"
#include "batch/photographs.h"
#include "records/records.h"

namespace ostraka::catalogue {
class Catalogue;
}  // namespace ostraka::catalogue

namespace ostraka::intake {

/// A batch that has some of the asked photographs, byte for byte. A photograph shows what lies on
/// the plate at one moment: one is enough, for either both would enter the same sherds, or it is in
/// the wrong folder of one.
struct SharedPhotographs {
  std::string batch;  ///< B0031: the one that has most of them
  int shared = 0, of = 0;
};
/// Whether the sherds of the other batch are in the catalogue or will come there before those of a
/// batch: it came earlier and has neither failed nor was set aside.
bool entersItsSherds(const catalogue::Catalogue& catalogue, const records::BatchRecord& other,
                     store::BatchRow before);
using CountsBatch = std::function<bool(const records::BatchRecord&)>;

/// Among the batches that count, by what the catalogue recorded of them and by what lies in their
/// folders and is not recorded yet. Reads only files of a size that both have. Errors: Cancelled.
Result<std::optional<SharedPhotographs>> sharedPhotographs(const catalogue::Catalogue& catalogue,
                                                           const std::filesystem::path& project,
                                                           std::vector<batch::SideFile> files,
                                                           const CountsBatch& counts,
                                                           const std::stop_token& stop);

/// Before a batch is processed, and before its results are entered: UnusableInput with the other
/// batch and what to do where its photographs are another's, too. Nothing where its sherds are in
/// the catalogue already, for it is only processed again; where the other one's never come there,
/// since it came later or has failed or was set aside; and where a person keeps both.
Result<void> checkNotShared(const catalogue::Catalogue& catalogue,
                            const std::filesystem::path& project, const records::BatchRecord& batch,
                            const std::stop_token& stop);
bool isAboutShared(const Message& sentence);  ///< of checkNotShared
/// A person wants both batches, and their sherds twice. It goes into the history.
Result<void> keepBoth(const catalogue::Catalogue& catalogue, const std::string& batch_number,
                      const records::Provenance& provenance);

}  // namespace ostraka::intake
