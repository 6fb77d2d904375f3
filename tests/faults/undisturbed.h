#pragma once
#include "files/folder_lock.h"
#include "kills.h"

/// What a command writes when nobody disturbs it is what it writes at the end of all interruptions.
namespace ostraka::test {

using Digests = std::map<std::string, std::string>;
inline const std::string tells_the_time = "tells the time";  ///< in place of a digest

/// What a command writes below its target when nobody disturbs it: files that are the same each
/// time, and those that tell the time.
class Undisturbed {
 public:
  Undisturbed(std::vector<std::string> command, std::filesystem::path target,
              std::filesystem::path errors)
      : command_(std::move(command)), target_(std::move(target)), errors_(std::move(errors)) {
    for (Digests& found : runs_) {
      removeAll();
      const Ended ended = run();
      status_ = ended.status;
      EXPECT_NE(status_, 2) << ended.errors;
      found = digests(target_);
      EXPECT_FALSE(found.empty());
    }
  }
  const std::vector<std::string>& command() const { return command_; }
  const std::filesystem::path& target() const { return target_; }
  const std::filesystem::path& errors() const { return errors_; }
  void removeAll() const { std::filesystem::remove_all(target_); }
  Ended run() const { return runProgram(command_, errors_); }
  int status() const { return status_; }
  Digests whole() const { return lasting(runs_[0]); }
  Digests now() const { return lasting(digests(target_)); }
  /// Each file that has its last name is whole; until then it is hidden. What a run leaves in the
  /// lock that it held holds nobody up.
  void expectNoHalfFile() const {
    const Digests whole = this->whole();
    for (const auto& [name, digest] : now()) {
      const std::string file = std::filesystem::path(name).filename().string();
      if (file.starts_with('.')) continue;
      if (file == kLockFile && !whole.contains(name)) {
        EXPECT_TRUE(std::filesystem::is_empty(target_ / name)) << name;
        continue;
      }
      const auto known = whole.find(name);
      EXPECT_TRUE(known != whole.end() && known->second == digest) << name;
    }
  }

 private:
  Digests lasting(const Digests& found) const {
    Digests kept;
    for (const auto& [name, digest] : found) {
      const auto a = runs_[0].find(name), b = runs_[1].find(name);
      const bool lasts = a != runs_[0].end() && b != runs_[1].end() && a->second == b->second;
      kept[name] = lasts ? digest : tells_the_time;
    }
    return kept;
  }
  std::vector<std::string> command_;
  std::filesystem::path target_, errors_;
  Digests runs_[2];
  int status_ = -1;
};

/// Killed and given again a command writes the same bytes. Whatever has its last name, seal, after
/// a kill is whole with all that belongs to it: no half result passes for one.
inline void killedWithTheSameBytes(const Undisturbed& undisturbed, const std::string& seal,
                                   int times = kills()) {
  ASSERT_TRUE(undisturbed.whole().contains(seal)) << seal;
  killRepeatedly(
      undisturbed.command(), undisturbed.errors(), [&] { undisturbed.removeAll(); },
      [&] {
        if (std::filesystem::exists(undisturbed.target() / seal)) {
          EXPECT_EQ(undisturbed.now(), undisturbed.whole());
        }
      },
      [&](const Ended& again) {
        // 2: it was whole when it was killed, and is not written over.
        EXPECT_TRUE(again.status == undisturbed.status() || again.status == 2) << again.errors;
        EXPECT_EQ(undisturbed.now(), undisturbed.whole());
        if (again.status == 2) return;
        EXPECT_FALSE(std::filesystem::exists(undisturbed.target().string() + ".partial"));
      },
      times);
}

/// Of a command that goes on from what is whole: killed again before it has ended, until there is
/// nothing left to do, so that a kill costs little more than what it undoes.
inline void killedAgainAndAgain(const Undisturbed& undisturbed, int times = kills()) {
  Delays delays(8);
  undisturbed.removeAll();
  int killed = 0, ends = 0;
  while ((killed < times || ends == 0) && !testing::Test::HasFailure()) {
    const Ended ended = killed < times
                            ? runAndKill(delays, undisturbed.command(), undisturbed.errors())
                            : undisturbed.run();
    SCOPED_TRACE("seed " + std::to_string(delays.seed()) + ", kill " + std::to_string(killed));
    if (ended.status < 0) {
      ++killed;
      undisturbed.expectNoHalfFile();
      continue;
    }
    ++ends;
    EXPECT_EQ(ended.status, undisturbed.status()) << ended.errors;
    EXPECT_EQ(undisturbed.now(), undisturbed.whole());
    if (killed < times) undisturbed.removeAll();
  }
  tellKills(killed, undisturbed.command(), "seed " + std::to_string(delays.seed()));
}

}  // namespace ostraka::test
