#pragma once
#include <filesystem>
#include <optional>

namespace ostraka::ui {

/// Opens the window, with this project, and returns its exit status when it was closed. Without a
/// display it says so on standard error and returns 2.
int runWindow(int argc, char** argv, const std::optional<std::filesystem::path>& project);

}  // namespace ostraka::ui
