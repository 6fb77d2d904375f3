#pragma once
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace ostraka {

struct Outcome {
  int status = -1;
  std::string text;  ///< of both streams, or of standard output alone
};

/// Runs the built program as a person does.
inline Outcome run(const std::string& arguments, const std::string& errors_to = "2>&1") {
  // Without a display, as on a cluster: the commands need none, and no window opens.
  const std::string command = "env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM " +
                              std::string(OSTRAKA_PROGRAM) + " " + arguments + " " + errors_to;
  Outcome outcome;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
    outcome.text.append(buffer.data(), n);
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

}  // namespace ostraka
