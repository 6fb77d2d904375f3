#pragma once
#include <optional>
#include <string>

namespace ostraka::app {

/// `ostraka` without a sub-command: becomes the window's program, with this project unless it is
/// empty. Returns where that is not installed.
int openWindow(const std::string& project);

/// What the computer's OpenGL calls itself, or why there is none, for `ostraka doctor`; found in a
/// child process, since a broken driver may take its process down. works: whether the window's 3D
/// view does; none where that was not looked at.
std::string openGlWords(std::optional<bool>& works);

/// Tells the window's program to say on standard output what openGlWords says, behind a + where it
/// works, a - where not and a ? where it was not looked at.
inline constexpr const char* kLookAtOpenGl = "--opengl";

}  // namespace ostraka::app
