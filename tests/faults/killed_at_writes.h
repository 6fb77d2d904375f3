#pragma once
#include "small_disk.h"
#include "undisturbed.h"

/// Commands that are killed at a write: at the same moments on every machine.
namespace ostraka::test {

/// Killed at some of its writes and given again a command writes the same bytes; at each with
/// OSTRAKA_EVERY_WRITE=1.
inline void killedAtItsWrites(const Undisturbed& undisturbed, long some) {
  undisturbed.removeAll();
  const long writes = writesOf(undisturbed.target(), undisturbed.command(), undisturbed.errors());
  int killed = 0;
  for (const long before : roomsBelow(writes, some)) {
    SCOPED_TRACE("killed after " + std::to_string(before) + " of " + std::to_string(writes));
    undisturbed.removeAll();
    const Ended ended =
        runKilledAfter(before, undisturbed.target(), undisturbed.command(), undisturbed.errors());
    ASSERT_EQ(ended.status, -1) << ended.errors;
    ++killed;
    undisturbed.expectNoHalfFile();
    const Ended again = undisturbed.run();
    EXPECT_TRUE(again.status == undisturbed.status() || again.status == 2) << again.errors;
    EXPECT_EQ(undisturbed.now(), undisturbed.whole());
    if (testing::Test::HasFailure()) return;
  }
  tellKills(killed, undisturbed.command(), "at " + std::to_string(writes) + " writes");
}

/// The same of a command that goes on from what is whole, a little later each time. With
/// OSTRAKA_EVERY_WRITE=1 at each write between one whole part, which has a file of the name `seal`,
/// and the next.
inline void killedAtItsWritesAgainAndAgain(const Undisturbed& undisturbed,
                                           const std::string& seal) {
  const bool each = std::getenv("OSTRAKA_EVERY_WRITE") != nullptr;
  const auto whole_parts = [&] {
    const Digests now = undisturbed.now();
    return std::count_if(now.begin(), now.end(), [&](const auto& file) {
      return std::filesystem::path(file.first).filename() == seal;
    });
  };
  undisturbed.removeAll();
  int killed = 0;
  for (long room = 0, parts = 0; !testing::Test::HasFailure(); ++killed) {
    SCOPED_TRACE("kill " + std::to_string(killed) + ", after " + std::to_string(room) + " writes");
    const Ended ended =
        runKilledAfter(room, undisturbed.target(), undisturbed.command(), undisturbed.errors());
    if (ended.status >= 0) {
      EXPECT_EQ(ended.status, undisturbed.status()) << ended.errors;
      EXPECT_EQ(undisturbed.now(), undisturbed.whole());
      break;
    }
    undisturbed.expectNoHalfFile();
    const long parts_now = whole_parts();
    const bool further = parts_now > parts;
    parts = parts_now;
    room = each ? (further ? 0 : room + 1) : 3 * room + 10;
  }
  tellKills(killed, undisturbed.command(), "at its writes");
}

}  // namespace ostraka::test
