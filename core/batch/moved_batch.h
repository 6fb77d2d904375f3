#pragma once
#include <filesystem>
#include <string>

namespace ostraka::batch {

/// Where a photograph is that a run recorded with its full path: in the batch's folder beside the
/// results (PROJECT/results/B0031 and PROJECT/batches/B0031), which a project that was moved,
/// copied or mounted elsewhere takes along, or else at its old path, which is also returned if it
/// is in neither.
std::filesystem::path photographNow(const std::string& then, const std::filesystem::path& output);

}  // namespace ostraka::batch
