#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ostraka::store {

/// sqlite.org/fileformat2.html, section 4: a WAL is a header, then frames of a header and a page.
/// Each frame's header holds the page's number, for the last frame of a transaction the size of the
/// database, the two salts of the WAL's header, and a checksum over all frames so far.
constexpr std::size_t kWalHeaderBytes = 32, kFrameHeaderBytes = 24;
constexpr std::size_t kFrameSummedBytes = 8, kFrameChecksumAt = 16, kWalHeaderChecksumAt = 24;

/// Section 4.2: both words of the checksum, s0 and s1, go on over `count` bytes.
void addToWalChecksum(const unsigned char* bytes, std::size_t count, bool big_endian,
                      std::uint32_t& s0, std::uint32_t& s1);

struct WalFrame {
  std::uint32_t page = 0;  ///< number of its page, from 1; 0: nothing tells it
  std::int64_t at = 0;     ///< where the page's bytes begin in the WAL
};
struct WalContent {
  /// A frame that SQLite takes for the WAL's end stands before the end of a saved transaction.
  bool damaged = false;
  std::vector<WalFrame> frames;  ///< of all saved transactions, in their order
};

/// False where so many bytes cannot be read from there.
using ReadAt = std::function<bool(unsigned char* to, std::size_t count, std::int64_t from)>;

/// SQLite drops all that follows a frame with a wrong checksum: what a killed process left
/// unfinished. Here the frames behind it are read, too. Nobody may be writing to it. bytes: size of
/// the file. O(bytes).
WalContent readWal(const ReadAt& read, std::int64_t bytes);

}  // namespace ostraka::store
