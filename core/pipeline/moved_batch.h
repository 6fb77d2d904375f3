#pragma once
#include <filesystem>
#include <string>

namespace ostraka::pipeline {

/// Where a photograph lies that a run named with its whole path: there still, or, when the project
/// was moved or mounted elsewhere, in the batch's folder beside the results (PROJECT/results/B0031
/// and PROJECT/batches/B0031). The old path when it is in neither place.
std::filesystem::path photographNow(const std::string& then, const std::filesystem::path& output);

}  // namespace ostraka::pipeline
