#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace ostraka::stereo {

/// A folder of its own, in front of everything else on the PATH while a test runs; programs put
/// there stand in for COLMAP's and OpenMVS's. Each writes down its arguments and runs a body.
class StandIns : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "-adapters");
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "bin");
    path_ = std::getenv("PATH");
    ::setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    std::filesystem::remove_all(folder_);
  }

  /// $work is the test's folder, $want NAME... ends the program when a file is not in $work/dense.
  void put(const std::string& name, const std::string& body) const {
    const std::filesystem::path program = folder_ / "bin" / name;
    std::ofstream(program) << "#!/bin/sh\nwork=" << folder_.string()
                           << "\necho \"" + name + " $*\" >> $work/calls\n"
                           << "want() { for f in \"$@\"; do [ -s \"$work/dense/$f\" ] || "
                              "{ echo \"$f is missing\"; exit 9; }; done; }\n"
                           << body << "\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }
  void hideEverythingElse() const { ::setenv("PATH", (folder_ / "bin").c_str(), 1); }
  static std::string textOf(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string calls() const { return textOf(folder_ / "calls"); }
  std::filesystem::path work() const { return folder_ / "dense"; }

  std::filesystem::path folder_;

 private:
  std::string path_;
};

}  // namespace ostraka::stereo
