#include "window.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "base/program_parts.h"
#include "command.h"

namespace ostraka::app {
namespace {

constexpr const char* kWindow = "ostraka-window";

}  // namespace

// The window is a program of its own, so that commands start without its libraries, and run on
// computers that lack them. It takes this one's place.
int openWindow(const std::string& project) {
  const std::string program = programPart(kWindow).string();
  ::execl(program.c_str(), "ostraka", project.empty() ? nullptr : project.c_str(), nullptr);
  std::fputs("Ostraka's window is not installed here; see ostraka --help for the commands.\n",
             stderr);
  return UnusableInputStatus;
}

std::string openGlWords(std::optional<bool>& works) {
  works.reset();
  const std::string program = programPart(kWindow).string();
  if (::access(program.c_str(), X_OK) != 0) return "not looked at: the window is not installed";
  works = false;
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return "could not be looked at";
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    ::execl(program.c_str(), "ostraka", kLookAtOpenGl, nullptr);
    ::_exit(1);
  }
  ::close(ends[1]);
  std::string answer;
  std::array<char, 512> buffer{};
  for (ssize_t n = 0; (n = ::read(ends[0], buffer.data(), buffer.size())) > 0;)
    answer.append(buffer.data(), static_cast<std::size_t>(n));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (answer.empty()) return "its driver breaks down; set LIBGL_ALWAYS_SOFTWARE=1";
  works = answer[0] == '?' ? std::nullopt : std::optional(answer[0] == '+');
  return answer.substr(1);
}

}  // namespace ostraka::app
