#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::store {

/// A small project with as many sherds as a test needs, and its files.
class FilledProject : public catalogue::SmallProject {
 protected:
  void fill(int sherds) {
    for (int i = 0; i < sherds; ++i) {
      const SherdRow sherd = i % 3 == 0 ? draft(context13, bag1) : numbered(context12);
      EXPECT_TRUE(set(sherd, "ware", i % 2 == 0 ? "grey" : "red slipped"));
      EXPECT_TRUE(set(sherd, "length_mm", std::to_string(20 + i)));
      EXPECT_TRUE(set(sherd, "note", "found beside the oven, number " + std::to_string(i)));
    }
  }
  std::filesystem::path folder() const { return folder_.path() / "project"; }
  std::filesystem::path file() const { return folder() / "catalogue.sqlite"; }
};

/// What a process leaves that is killed after it has saved.
template <class Work>
inline void inAKilledProcess(Work work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace ostraka::store
