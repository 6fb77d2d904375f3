#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "archive/bag_reader.h"
#include "archive/bagit.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "records/records.h"

namespace ostraka::metadata {

/// metadata/batches.json: batches with their bags, photographs, scans and all decisions about their
/// pairs. `exported`: the files of the bag so far; photographs that travel along are named.
Result<nlohmann::ordered_json> batchesJson(const catalogue::Catalogue& catalogue,
                                           const std::set<store::BatchRow>& batches,
                                           const std::vector<archive::BagFile>& exported);

struct FileCopy {
  std::string from;  ///< relative to data/ of the export
  std::string to;    ///< relative to the project
};
/// A file of the export as its manifest has it, which is what was verified; `at`: relative to
/// data/. Error: UnusableInput where it is not there, or a record says another checksum or size.
Result<archive::BagFile> verifiedFile(const archive::BagReader& bag, const std::string& at,
                                      const std::string& sha256, std::int64_t bytes);

struct ReadBatches {
  std::vector<FileCopy> copies;                ///< the files that belong to what entered
  std::map<std::string, std::string> numbers;  ///< of the export -> in the project
  std::set<store::BatchRow> fresh;             ///< that were not there before
};
/// Batches that are not there yet enter whole, with their ids; the others stay as they are. Where
/// the project has another batch of the same number (two laptops begin with B0001 each), the
/// entering one gets the project's next number. rows: id -> row of persons and bags. Throws
/// json::exception where something is not as written.
Result<ReadBatches> readBatches(catalogue::Catalogue& catalogue, const archive::BagReader& bag,
                                const nlohmann::json& batches,
                                const std::map<std::string, std::int64_t>& rows,
                                const records::Provenance& provenance);

/// What a sherd was made from.
Result<void> restoreScans(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                          store::ScanRow front, store::ScanRow back);

}  // namespace ostraka::metadata
