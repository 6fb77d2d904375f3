#pragma once
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "files/folder_lock.h"

namespace ostraka::stages {

/// What a stage leaves behind besides its files: figures for the report and warnings in words.
struct StageNotes {
  nlohmann::ordered_json figures = nlohmann::ordered_json::object();
  std::vector<Message> warnings;
};

/// A stage that is whole: its notes, its cost, and the hash that names exactly these results.
struct StageRecord {
  StageNotes notes;
  double seconds = 0;
  double peak_memory_mb = 0;  ///< of the process up to the stage's end
  std::string outputs_hash;   ///< over names and contents of the files left, and the notes
};

/// Writes a stage's files into the folder it is given.
using StageWork = std::function<Result<StageNotes>(const std::filesystem::path&)>;

/// One folder OUT/work/<name> per stage. The stage runs only if its stage.json does not match `key`
/// (program and format version, options, hashes of inputs) or a file it names is missing or
/// changed. `work` writes its files into the folder it is given, which is empty but for begun.json;
/// stage.json is written last, so that a run killed at any moment leaves the stage either whole or
/// to be done again. A folder that neither of the two marks as this stage's is a person's and stays
/// as it is: UnusableInput. Where the folder is gone that was held (FolderLock::stands) nothing is
/// left in its place: outputGone (output_folder.h).
Result<StageRecord> runStage(const FolderLock& work_folder, const std::string& name,
                             const nlohmann::ordered_json& key, const StageWork& work,
                             Progress& progress);

/// Messages among a stage's figures; none where there are none. What is no list of messages is said
/// as it is: a doubt must not get lost.
std::vector<Message> messagesAt(const nlohmann::ordered_json& figures, const char* key);

}  // namespace ostraka::stages
