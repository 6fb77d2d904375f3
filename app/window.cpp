#include "window.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>

#ifdef OSTRAKA_WITH_WINDOW
#include "ui/main/run_window.h"
#endif

#include "command.h"

namespace ostraka::app {

int openWindow([[maybe_unused]] int argc, [[maybe_unused]] char** argv,
               [[maybe_unused]] const std::string& project) {
#ifdef OSTRAKA_WITH_WINDOW
  std::optional<std::filesystem::path> folder;
  if (!project.empty()) folder = project;
  return ui::runWindow(argc, argv, folder);
#else
  std::fputs("This Ostraka was built without its window; see ostraka --help for the commands.\n",
             stderr);
  return UnusableInputStatus;
#endif
}

#ifdef OSTRAKA_WITH_WINDOW

std::string openGlWords(std::optional<bool>& works) {
  works = false;
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return "could not be looked at";
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    const std::string words = ui::openGlOfThisComputer(works);
    const std::string answer = (!works ? "?" : *works ? "+" : "-") + words;
    const ssize_t written = ::write(ends[1], answer.data(), answer.size());
    ::_exit(written < 0 ? 1 : 0);
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

#else

std::string openGlWords(std::optional<bool>& works) {
  works.reset();
  return "not looked at: built without the window";
}

#endif

}  // namespace ostraka::app
