#include "program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "files/files.h"

namespace ostraka::test {

namespace fs = std::filesystem;

pid_t startProgram(const std::vector<std::string>& arguments, const fs::path& errors,
                   const Environment& environment) {
  std::vector<std::string> words{OSTRAKA_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Environment all = environment;
  for (char** own = environ; *own != nullptr; ++own) {  // of two of one name, which counts is open
    const std::string variable = *own, name = variable.substr(0, variable.find('=') + 1);
    if (std::ranges::none_of(environment, [&](const auto& of) { return of.starts_with(name); }))
      all.push_back(variable);
  }
  std::vector<char*> argv, envp;
  for (std::string& word : words) argv.push_back(word.data());
  for (std::string& variable : all) envp.push_back(variable.data());
  argv.push_back(nullptr);
  envp.push_back(nullptr);
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int nowhere = ::open("/dev/null", O_RDWR);
  const int file = ::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(nowhere, 0);
  ::dup2(nowhere, 1);
  ::dup2(file, 2);
  ::execve(argv[0], argv.data(), envp.data());
  ::_exit(127);
}

Ended waitFor(pid_t program, const fs::path& errors) {
  int status = 0;
  ::waitpid(program, &status, 0);
  const Result<std::string> said = readFile(errors);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said ? *said : ""};
}

Ended runProgram(const std::vector<std::string>& arguments, const fs::path& errors,
                 const Environment& environment) {
  return waitFor(startProgram(arguments, errors, environment), errors);
}

int numberFrom(const char* variable, int usual) {
  const char* told = std::getenv(variable);
  return told == nullptr ? usual : std::atoi(told);
}

std::map<std::string, std::string> digests(const fs::path& folder,
                                           const std::vector<std::string>& but) {
  std::map<std::string, std::string> found;
  if (!fs::exists(folder)) return found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && std::find(but.begin(), but.end(), name) == but.end())
      found[entry.path().lexically_relative(folder).string()] = sha256(*readFile(entry.path()));
  }
  return found;
}

}  // namespace ostraka::test
