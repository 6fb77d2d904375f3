#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "files/folder_lock.h"

namespace ostraka::stages {

/// Copies what the stages in OUT/work left of a sherd to OUT/sherds/<number>; without a model only
/// the scans. held: of OUT/work.
Result<void> publish(const FolderLock& held, const std::string& number, bool has_model);

/// Takes away what an earlier run left in OUT/sherds of others than these.
void removeStaleSherds(const std::filesystem::path& output, const std::set<std::string>& numbers);

/// Writes what stands on top of OUT. report.json comes last, so that where it is all else is too:
/// before it kReportsRecord, by which a reader sees whether one of the three was changed since.
Result<void> publishReports(const std::filesystem::path& output,
                            const nlohmann::ordered_json& pairs, const std::string& html,
                            const nlohmann::ordered_json& report);

/// Files below OUT that no run writes, by their paths in it, in order: of a stage those that its
/// stage.json does not name. What people decided and painted there is theirs and none of these.
/// Links are not followed, and count as such files.
std::vector<std::string> filesOfOthers(const std::filesystem::path& output);

}  // namespace ostraka::stages
