#pragma once
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// The built program, run as a process of its own, so that it can be killed.
namespace ostraka::test {

using Environment = std::vector<std::string>;  ///< "NAME=value", added to the test's own

/// Its output is dropped, its errors go to the file.
pid_t startProgram(const std::vector<std::string>& arguments, const std::filesystem::path& errors,
                   const Environment& environment = {});

struct Ended {
  int status = -1;  ///< exit status; -1: ended by a signal
  std::string errors;
};
Ended waitFor(pid_t program, const std::filesystem::path& errors);
Ended runProgram(const std::vector<std::string>& arguments, const std::filesystem::path& errors,
                 const Environment& environment = {});

/// What the environment variable says, else the usual.
int numberFrom(const char* variable, int usual);

/// SHA-256 of all files in the folder by their names; empty where there is none. Files with one of
/// these names are passed over: they tell seconds.
std::map<std::string, std::string> digests(const std::filesystem::path& folder,
                                           const std::vector<std::string>& but = {});

}  // namespace ostraka::test
