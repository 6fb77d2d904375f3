#pragma once
#include "small_disk.h"
#include "undisturbed.h"

/// Commands that are killed at a write: at the same moments on every machine.
namespace ostraka::test {

/// Killed at some of its writes and given again a command writes the same bytes; at each with
/// OSTRAKA_EVERY_WRITE=1.
inline void killedAtItsWrites(const std::vector<std::string>& command,
                              const std::filesystem::path& target, const std::string& seal,
                              const std::filesystem::path& errors, long some = 3) {
  const Undisturbed undisturbed(command, target, errors);
  ASSERT_TRUE(undisturbed.whole().contains(seal)) << seal;
  std::filesystem::remove_all(target);
  const long writes = writesOf(target, command, errors);
  int killed = 0;
  for (const long before : roomsBelow(writes, some)) {
    SCOPED_TRACE("killed after " + std::to_string(before) + " of " + std::to_string(writes));
    std::filesystem::remove_all(target);
    ASSERT_EQ(runKilledAfter(before, target, command, errors).status, -1);
    ++killed;
    undisturbed.expectNoHalfFile();
    const Ended again = runProgram(command, errors);
    EXPECT_TRUE(again.status == undisturbed.status() || again.status == 2) << again.errors;
    EXPECT_EQ(undisturbed.now(), undisturbed.whole());
    if (testing::Test::HasFailure()) return;
  }
  tellKills(killed, command, "at " + std::to_string(writes) + " writes");
}

/// The same of a command that goes on from what is whole, a little later each time. With
/// OSTRAKA_EVERY_WRITE=1 at each write between one whole part, which has a file of the name `seal`,
/// and the next.
inline void killedAtItsWritesAgainAndAgain(const Undisturbed& undisturbed,
                                           const std::vector<std::string>& command,
                                           const std::filesystem::path& target,
                                           const std::string& seal,
                                           const std::filesystem::path& errors) {
  const bool each = std::getenv("OSTRAKA_EVERY_WRITE") != nullptr;
  const auto whole_parts = [&] {
    const Digests now = undisturbed.now();
    return std::count_if(now.begin(), now.end(), [&](const auto& file) {
      return std::filesystem::path(file.first).filename() == seal;
    });
  };
  std::filesystem::remove_all(target);
  int killed = 0;
  for (long room = 0, parts = 0; !testing::Test::HasFailure(); ++killed) {
    SCOPED_TRACE("kill " + std::to_string(killed) + ", after " + std::to_string(room) + " writes");
    const Ended ended = runKilledAfter(room, target, command, errors);
    if (ended.status >= 0) {
      EXPECT_EQ(ended.status, undisturbed.status()) << ended.errors;
      EXPECT_EQ(undisturbed.now(), undisturbed.whole());
      break;
    }
    undisturbed.expectNoHalfFile();
    const long parts_now = whole_parts();
    const bool further = parts_now > parts;
    parts = parts_now;
    room = each ? (further ? 0 : room + 1) : 2 * room + 10;
  }
  tellKills(killed, command, "at its writes");
}

}  // namespace ostraka::test
