#pragma once
#include <filesystem>
#include <string>

#include "base/result.h"
#include "records/records.h"

namespace ostraka::catalogue {
class Catalogue;
}  // namespace ostraka::catalogue

namespace ostraka::sherds {

/// What the catalogue shows of a sherd must stay what was entered while its batch is computed
/// again, or stops half-way: model.ply, model.glb and preview.png of `from` get a folder of the
/// project that is named by their contents and never written into again (further names of the same
/// bytes where the disk knows such, else copies). Returns the folder, relative to the project.
/// Errors: Missing without a model, CannotWrite.
Result<std::string> keepModel(const std::filesystem::path& project, const std::string& batch,
                              const std::filesystem::path& from);

/// Removes the folders of the batch that no sherd shows any more, and the records of their files.
/// To be called before new results are entered, so that what shows them has time to go on.
Result<void> dropUnusedModels(const catalogue::Catalogue& catalogue,
                              const std::filesystem::path& project, const std::string& batch);

/// What was made from another pair says nothing about a sherd any more: its model, the program's
/// measures. Within a transaction.
void forgetModel(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                 const records::Provenance& provenance);

}  // namespace ostraka::sherds
