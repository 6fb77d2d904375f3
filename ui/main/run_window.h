#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace ostraka::ui {

/// Opens the window, with this project, and returns its exit status when it was closed. Without a
/// display it says so on standard error and returns 2.
int runWindow(int argc, char** argv, const std::optional<std::filesystem::path>& project);

/// The renderer's name and version, or what is missing. Makes a QGuiApplication of its own: call it
/// in a process that has none and ends afterwards. works: none where there is no display to ask.
std::string openGlOfThisComputer(std::optional<bool>& works);

}  // namespace ostraka::ui
