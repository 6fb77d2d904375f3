// `ostraka cluster` on a computer without a cluster; core/cluster has its tests with one.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/core/catalogue/small_project.h"

namespace {

namespace fs = std::filesystem;

class ClusterCommand : public ostraka::catalogue::SmallProject {
 protected:
  /// The exit status; what it printed as JSON is in said. No other program is found.
  int run(const std::string& arguments) {
    const std::string command = "PATH='" + folder_.path().string() + "' '" + OSTRAKA_PROGRAM +
                                "' --json cluster " + arguments + " '" +
                                project_->folder().string() + "' 2>/dev/null";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> buffer;
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
      text.append(buffer.data(), n);
    said = nlohmann::json::parse(text, nullptr, false);
    const int status = ::pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string error() const { return said.value("error", std::string()); }
  nlohmann::json said;
};

TEST_F(ClusterCommand, AProjectThatWasNeverOnAClusterHasNothingToTell) {
  EXPECT_EQ(run("status"), 0);
  EXPECT_TRUE(said["batches"].empty());
  EXPECT_EQ(run("collect"), 0);
  EXPECT_TRUE(said["batches"].empty());
  EXPECT_FALSE(fs::exists(project_->folder() / "cluster"));
}

TEST_F(ClusterCommand, WithoutSlurmItSaysWhereToRunItOrHowToNameAHost) {
  EXPECT_EQ(run("submit"), 1);
  EXPECT_THAT(error(), testing::HasSubstr("sbatch is not on this computer's PATH"));
  EXPECT_THAT(error(), testing::HasSubstr("--host USER@LOGIN:/FOLDER"));
  EXPECT_EQ(run("submit --host anna@login:/dig"), 1);
  EXPECT_THAT(error(), testing::HasSubstr("ssh is not on this computer's PATH"));
}

TEST_F(ClusterCommand, WhatCannotBeAHostOrAPartitionIsRefused) {
  EXPECT_EQ(run("submit --host login"), 2);
  EXPECT_EQ(run("submit --host 'login:/dig; rm -r /'"), 2);
  EXPECT_EQ(run("submit --partition 'a b'"), 2);
  EXPECT_EQ(run("submit --minutes 0"), 2);
}

}  // namespace
