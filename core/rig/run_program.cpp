#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <sstream>

#include "rig/colmap_program.h"

namespace ostraka::rig {
namespace {

constexpr int kNotStarted = 127;  // as the shell says it

[[noreturn]] void becomeProgram(std::vector<char*>& arguments, int log) {
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing >= 0) ::dup2(nothing, STDIN_FILENO);
  ::execv(arguments[0], arguments.data());
  ::_exit(kNotStarted);
}

}  // namespace

std::optional<std::filesystem::path> findProgram(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path program = std::filesystem::path(folder) / name;
    std::error_code ignored;
    if (!folder.empty() && std::filesystem::is_regular_file(program, ignored) &&
        ::access(program.c_str(), X_OK) == 0)
      return program;
  }
  return std::nullopt;
}

Result<void> runProgram(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, const std::filesystem::path& log,
                        std::stop_token stop) {
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) return Error{ErrorCode::CannotWrite, "The log cannot be written.", log.string()};
  // Everything is prepared before the fork: afterwards only system calls are allowed.
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> raw;
  for (std::string& word : words) raw.push_back(word.data());
  raw.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) becomeProgram(raw, file);
  ::close(file);
  if (child < 0) return Error{ErrorCode::Failed, "No process can be started.", program.string()};
  int status = 0;
  while (true) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR)
      return Error{ErrorCode::Failed, "The program was lost.", program.string()};
    if (stop.stop_requested()) {
      ::kill(child, SIGKILL);
      while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
      }
      return Error::cancelled();
    }
    ::usleep(20'000);
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotStarted)
    return Error{ErrorCode::Missing, "The program cannot be started; install it.",
                 program.string()};
  return Error{ErrorCode::Failed,
               program.filename().string() + " ended with an error; its words are in this file.",
               log.string()};
}

}  // namespace ostraka::rig
