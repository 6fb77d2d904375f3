#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "colmap/colmap_program.h"

namespace ostraka::colmap {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// Within ten seconds; how long it took.
std::chrono::duration<double> waitUntil(const std::function<bool()>& so) {
  const auto begin = std::chrono::steady_clock::now();
  while (!so() && std::chrono::steady_clock::now() - begin < 10s) std::this_thread::sleep_for(5ms);
  return std::chrono::steady_clock::now() - begin;
}

// A stand-in for colmap that starts a program of its own; both sleep.
class RunProgram : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    std::ofstream(program_) << "#!/bin/sh\n"
                            << "sleep 60 &\n"
                            << "echo $! $$ > " << (folder_ / "pids.new").string() << "\n"
                            << "mv " << (folder_ / "pids.new").string() << " "
                            << (folder_ / "pids").string() << "\n"
                            << "[ \"$1\" = leave ] || wait\n";
    fs::permissions(program_, fs::perms::owner_all);
  }
  void TearDown() override { fs::remove_all(folder_); }

  bool started() const { return fs::exists(folder_ / "pids"); }
  // Of the program and of the one that it started; a dead one that nobody has buried is not alive.
  int alive() const {
    std::ifstream pids(folder_ / "pids");
    int count = 0;
    for (int pid = 0; pids >> pid;) {
      std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
      std::string id, name, state;
      if (stat >> id >> name >> state && state != "Z" && state != "X") ++count;
    }
    return count;
  }
  Result<void> run(const std::vector<std::string>& arguments, std::stop_token stop = {}) const {
    return runProgram(program_, arguments, folder_ / "log.txt", stop);
  }

  fs::path folder_ = fs::path(testing::TempDir()) / ("ostraka_run_" + std::to_string(::getpid()));
  fs::path program_ = folder_ / "colmap";
};

TEST_F(RunProgram, TheProgramAndWhatItStartedDieWithTheirParentThatIsKilled) {
  const pid_t parent = ::fork();
  if (parent == 0) {
    [[maybe_unused]] const Result<void> ignored = run({});
    ::_exit(0);
  }
  waitUntil([this] { return started(); });
  ASSERT_EQ(alive(), 2);
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  EXPECT_LT(waitUntil([this] { return alive() == 0; }), 1s);
  EXPECT_EQ(alive(), 0);
}

TEST_F(RunProgram, ACancelEndsTheProgramAndWhatItStarted) {
  std::stop_source source;
  std::thread person([&] {
    waitUntil([this] { return started(); });
    source.request_stop();
  });
  const Result<void> done = run({}, source.get_token());
  person.join();
  ASSERT_TRUE(started());
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().code, ErrorCode::Cancelled);
  EXPECT_LT(waitUntil([this] { return alive() == 0; }), 1s);
}

TEST_F(RunProgram, WhatAProgramLeavesRunningEndsWithIt) {
  EXPECT_TRUE(run({"leave"}).has_value());
  ASSERT_TRUE(started());
  EXPECT_LT(waitUntil([this] { return alive() == 0; }), 1s);
}

TEST_F(RunProgram, AWorkspaceIsEmptiedForOneRunAndRefusedToASecondByName) {
  const fs::path workspace = folder_ / "work";
  fs::create_directories(workspace / "images");
  std::ofstream(workspace / "database.db") << "of an earlier run";
  {
    const Result<FolderLock> held = claimWorkspace(workspace);
    ASSERT_TRUE(held.has_value());
    EXPECT_FALSE(fs::exists(workspace / "images") || fs::exists(workspace / "database.db"));
    std::ofstream(workspace / "database.db") << "of this run";
    const Result<FolderLock> second = claimWorkspace(workspace);
    ASSERT_FALSE(second.has_value());
    EXPECT_EQ(second.error().where, workspace.string());
    EXPECT_TRUE(fs::exists(workspace / "database.db"));
  }
  EXPECT_TRUE(claimWorkspace(workspace).has_value());
}

}  // namespace
}  // namespace ostraka::colmap
