#pragma once
#include <optional>
#include <string>

namespace ostraka::app {

/// `ostraka` without a sub-command: opens the window, with this project unless it is empty.
int openWindow(int argc, char** argv, const std::string& project);

/// What the computer's OpenGL calls itself, or why there is none, for `ostraka doctor`; found in a
/// child process, since a broken driver may take its process down. works: whether the window's 3D
/// view does; none where that was not looked at.
std::string openGlWords(std::optional<bool>& works);

}  // namespace ostraka::app
