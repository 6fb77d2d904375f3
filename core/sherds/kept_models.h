#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <stop_token>
#include <string>

#include "base/result.h"
#include "files/folder_lock.h"
#include "records/records.h"

namespace ostraka::catalogue {
class Catalogue;
}  // namespace ostraka::catalogue

namespace ostraka::sherds {

/// Between keepModel and the rows that name what it kept a model is nobody's: who enters results
/// holds the batch's models from before keepModel on until the rows are there. Waits for another
/// who does so. Errors: Cancelled, CannotWrite.
Result<FolderLock> holdModels(const std::filesystem::path& project, const std::string& batch,
                              Progress& progress, const std::stop_token& stop);

using ModelHashes = std::map<std::string, std::string>;  ///< SHA-256 by file name

/// What the catalogue shows of a sherd must stay what was entered while its batch is computed
/// again, or stops half-way: model.ply, model.glb and preview.png of `from` get a folder of the
/// project that is named by their contents and never written into again (further names of the same
/// bytes where the disk knows such, else copies). Returns the folder, relative to the project.
/// Errors: Missing without all three, UnusableInput where one is a link or not as it was made,
/// CannotWrite.
Result<std::string> keepModel(const std::filesystem::path& project, const std::string& batch,
                              const std::filesystem::path& from, const ModelHashes& made);

/// Removes the folders of the batch that no sherd shows any more, the records of their files, and
/// what a killed run left half kept; nothing that keepModel did not make.
/// To be called after new results were read, whose models are `kept` (folders as keepModel names
/// them), and before they are entered, so that what shows the old ones has time to go on. Error:
/// UnusableInput for a batch whose number is not the name of a folder.
Result<void> dropUnusedModels(const catalogue::Catalogue& catalogue,
                              const std::filesystem::path& project, const std::string& batch,
                              const std::set<std::string>& kept);

/// What was made from another pair says nothing about a sherd any more: its model, the program's
/// measures. Within a transaction.
void forgetModel(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                 const records::Provenance& provenance);

}  // namespace ostraka::sherds
