#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::intake {

/// SHA-256 by name, relative to the batch's folder.
using PhotographHashes = std::map<std::string, std::string>;

/// The side whose folder a file with this name relative to the batch's folder lies in; none for
/// what lies elsewhere, such as masks, the plate or the board, which may be those of many batches.
std::optional<batch::Side> sideOf(const std::string& name);

/// The photographs (or imported scans) that lie in the folders of both sides now. Error: Cancelled.
Result<PhotographHashes> photographsNow(const std::filesystem::path& batch_folder,
                                        const std::stop_token& stop);

/// What tells one taking of the batch from another: one hash of the names and hashes of all these.
Result<std::string> takingNow(const std::filesystem::path& batch_folder,
                              const std::stop_token& stop);

}  // namespace ostraka::intake
