#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/result.h"
#include "batch/batch.h"
#include "files/folder_lock.h"

namespace ostraka::stages {

/// What tells one taking of a side from another (ScanRef::photographs). hashes: BatchInputs.
std::string photographsHash(const batch::Batch& batch, const nlohmann::ordered_json& hashes,
                            batch::Side side);

/// Holds OUT for one run and notes whose it is; nothing is written before the folder is held, for
/// another run may be at work in it. Errors: UnusableInput (OUT of another batch, or of another
/// program), those of FolderLock::take, CannotWrite.
Result<FolderLock> claimOutput(const std::filesystem::path& output, const batch::Batch& batch,
                               const nlohmann::ordered_json& hashes);

/// The same for scans that are registered; scans_hash names them. An OUT of the same scans goes on,
/// also one of a run that was stopped.
Result<FolderLock> claimOutput(const std::filesystem::path& output, const std::string& scans_hash);

/// OUT was deleted or moved away while a run was writing into it.
Error outputGone(const std::filesystem::path& output);

/// Takes away what a run wrote into an OUT that was deleted under it, as far as nothing else is in
/// there.
void leaveGoneOutput(const std::filesystem::path& output);

/// Whether a run writes a file of this name into OUT/unpaired: f001.ply, b012.ply.
bool isUnpairedScan(const std::string& name);

/// In OUT: SHA-256 by name of what `process` read from the batch.
inline constexpr const char* kInputsRecord = "work/batch.json";

/// In OUT: `files` names the SHA-256 of kInputsRecord, pairs.json, report.html and report.json, as
/// a run left them.
inline constexpr const char* kReportsRecord = "work/reports.json";

/// What an earlier run left on top must not look whole while this one may change it.
void withdrawResults(const std::filesystem::path& output);

}  // namespace ostraka::stages
