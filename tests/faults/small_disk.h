#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "files/files.h"
#include "program.h"

/// Commands on a disk that takes so many writes and no more, or that are killed at a write;
/// small_disk.cpp does it.
namespace ostraka::test {

inline Environment roomFor(long writes, const std::filesystem::path& disk) {
  return {"LD_PRELOAD=" OSTRAKA_SMALL_DISK_LIBRARY, "OSTRAKA_SMALL_DISK=" + disk.string(),
          "OSTRAKA_SMALL_DISK_WRITES=" + std::to_string(writes),
          "ASAN_OPTIONS=verify_asan_link_order=0"};
}

inline Ended runWithRoomFor(long writes, const std::filesystem::path& disk,
                            const std::vector<std::string>& command,
                            const std::filesystem::path& errors,
                            const std::filesystem::path& count = {}) {
  Environment environment = roomFor(writes, disk);
  environment.push_back("OSTRAKA_SMALL_DISK_COUNT=" + count.string());
  return runProgram(command, errors, environment);
}

/// Killed instead of the write after so many.
inline Ended runKilledAfter(long writes, const std::filesystem::path& disk,
                            const std::vector<std::string>& command,
                            const std::filesystem::path& errors) {
  Environment environment = roomFor(writes, disk);
  environment.emplace_back("OSTRAKA_SMALL_DISK_KILLS=1");
  return runProgram(command, errors, environment);
}

/// How often the command writes below the folder, with room for all.
inline long writesOf(const std::filesystem::path& disk, const std::vector<std::string>& command,
                     const std::filesystem::path& errors) {
  const std::filesystem::path count = errors.string() + "-count";
  runWithRoomFor(1L << 40, disk, command, errors, count);
  const Result<std::string> text = readFile(count);
  long writes = 0;
  if (text) std::from_chars(text->data(), text->data() + text->size(), writes);
  EXPECT_GT(writes, 0);
  return writes;
}

/// Some rooms below the number of writes: the first, the last and those between; each of them with
/// OSTRAKA_EVERY_WRITE=1.
inline std::set<long> roomsBelow(long writes, long some) {
  if (std::getenv("OSTRAKA_EVERY_WRITE") != nullptr) some = writes;
  std::set<long> rooms;
  for (long k = 0; k < some; ++k) rooms.insert(k * (writes - 1) / std::max(1L, some - 1));
  return rooms;
}

/// One sentence: that the disk is full, and which folder.
inline void expectDiskFull(const Ended& ended, const std::filesystem::path& disk) {
  EXPECT_EQ(ended.status, 1) << ended.errors;
  const std::size_t at = ended.errors.find("ostraka: ");
  ASSERT_NE(at, std::string::npos) << ended.errors;
  const std::string last = ended.errors.substr(at);
  EXPECT_EQ(std::count(last.begin(), last.end(), '\n'), 1) << last;
  EXPECT_NE(last.find("disk is full"), std::string::npos) << last;
  EXPECT_NE(last.find(disk.string()), std::string::npos) << last;
}

}  // namespace ostraka::test
