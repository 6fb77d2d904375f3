#pragma once
#include <string>

namespace ostraka::app {

/// `ostraka` without a sub-command: opens the window, with this project unless it is empty.
int openWindow(int argc, char** argv, const std::string& project);

/// What the computer's OpenGL calls itself, or why there is none, for `ostraka doctor`; found in a
/// child process, since a broken driver may take its process down. ok: the window's 3D view works.
std::string openGlWords(bool& ok);

}  // namespace ostraka::app
