#pragma once
#include <optional>
#include <string>

namespace ostraka::ui {

/// The renderer's name and version, or what is missing. Makes a QGuiApplication of its own: call it
/// in a process that has none and ends afterwards. works: none where there is no display to ask.
std::string openGlOfThisComputer(std::optional<bool>& works);

}  // namespace ostraka::ui
