#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <sstream>

#include "base/message.h"
#include "colmap/colmap_program.h"
#include "files/files.h"
#include "files/log_file.h"

namespace ostraka::colmap {
namespace {

constexpr int kNotStarted = 127;  // as the shell says it

// Both are called between fork and exec, where only system calls are allowed.

// Ends with all of its group when the pipe's other end is closed, as it is when this program ends,
// however that happens. exec: a copy of this program would keep its memory.
[[noreturn]] void becomeWatcher(int pipe_end, char* const* arguments) {
  ::setpgid(0, 0);
  ::dup2(pipe_end, STDIN_FILENO);
  ::execv(arguments[0], arguments);
  ::_exit(kNotStarted);
}

[[noreturn]] void becomeProgram(char* const* arguments, pid_t group, pid_t parent, int log) {
  // The thread that forked waits for the program, so the signal comes with the parent's end only.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::setpgid(0, group) != 0 || ::getppid() != parent) ::_exit(kNotStarted);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing >= 0) ::dup2(nothing, STDIN_FILENO);
  ::execv(arguments[0], arguments);
  ::_exit(kNotStarted);
}

int waitFor(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

// A group of processes that does not outlive this one: the programs that the program starts, too.
class ProcessGroup {
 public:
  ProcessGroup() {
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0) return;
    char shell[] = "/bin/sh", option[] = "-c", watch[] = "read nothing; kill -KILL 0";
    char* const arguments[] = {shell, option, watch, nullptr};
    leader_ = ::fork();
    if (leader_ == 0) becomeWatcher(ends[0], arguments);
    if (leader_ > 0) ::setpgid(leader_, leader_);  // as it does itself: whoever comes first
    ::close(ends[0]);
    pipe_ = ends[1];
  }
  ~ProcessGroup() {
    kill();
    if (pipe_ >= 0) ::close(pipe_);
  }
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;

  pid_t id() const { return leader_; }
  void kill() {
    if (leader_ <= 0) return;
    ::kill(-leader_, SIGKILL);
    waitFor(leader_);
    leader_ = -1;
  }

 private:
  pid_t leader_ = -1;
  int pipe_ = -1;
};

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

Result<FolderLock> claimWorkspace(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  if (const Result<void> made = makeFolder(folder); !made) return made.error();
  Result<FolderLock> held = FolderLock::take(folder);
  if (!held) return held;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed))
    if (at->path().filename() != kLockFile) fs::remove_all(at->path(), failed);
  if (failed) return cannotWrite(folder, failed.value());
  return held;
}

Result<void> runProgram(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, const std::filesystem::path& log,
                        std::stop_token stop) {
  const LogFile file(log);
  if (file.descriptor() < 0)
    return Error{ErrorCode::CannotWrite, message("The log cannot be written."), log.string()};
  // Everything is prepared before the fork.
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> raw;
  for (std::string& word : words) raw.push_back(word.data());
  raw.push_back(nullptr);
  ProcessGroup group;
  const pid_t parent = ::getpid(), child = group.id() > 0 ? ::fork() : -1;
  if (child == 0) becomeProgram(raw.data(), group.id(), parent, file.descriptor());
  if (child < 0) return Error::failed(message("A process cannot be started."), program.string());
  int status = 0;
  while (true) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR)
      return Error::failed(message("The program's exit status is unknown."), program.string());
    if (stop.stop_requested()) {
      ::kill(child, SIGKILL);  // it may not have joined its group yet
      group.kill();
      waitFor(child);
      return Error::cancelled();
    }
    ::usleep(20'000);
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotStarted)
    return Error::missing(message("The program cannot be started; install it."), program.string());
  return Error::failed(
      message("%1 ended with an error; its output is in this file.", program.filename().string()),
      log.string());
}

}  // namespace ostraka::colmap
