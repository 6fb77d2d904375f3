#pragma once
#include <string>

namespace ostraka::ui {

/// The renderer's name and version, or what is missing. Makes a QGuiApplication of its own: call it
/// in a process that has none and ends afterwards.
std::string openGlOfThisComputer(bool& works);

}  // namespace ostraka::ui
