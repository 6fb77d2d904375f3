#pragma once
#include <cstddef>
#include <cstdint>

namespace ostraka::store {

/// Pages of catalogue.sqlite end with 8 bytes that SQLite reserves and never reads: here a checksum
/// of the page's content and its number. Any SQLite reads such a file; one that writes to it leaves
/// pages whose checksums are wrong, as a failing disk does.
constexpr std::size_t kPageBytes = 4096, kReservedBytes = 8;

/// The number in these 4 bytes, as SQLite's files have it.
std::uint32_t bigEndian(const unsigned char* at);

/// Of the page's first kPageBytes - kReservedBytes bytes. No single changed bit keeps it; of other
/// changes one in 2^64 does. number: from 1.
std::uint64_t pageChecksum(const unsigned char* page, std::uint32_t number);
std::uint64_t storedChecksum(const unsigned char* page);
void storeChecksum(unsigned char* page, std::uint32_t number);
inline bool isWholePage(const unsigned char* page, std::uint32_t number) {
  return storedChecksum(page) == pageChecksum(page, number);
}

/// Turns back the one bit whose turning makes the page what its checksum says, and says whether
/// there is one. Where two do, neither is proven. 10 ms.
bool turnBackOneBit(unsigned char* page, std::uint32_t number);

/// Name of the VFS (SQLite's way to files) that lies over the system's: it writes each page, of the
/// database and of its WAL, with the checksum, and reads no page without the right one
/// (SQLITE_IOERR_DATA), nor a WAL that is damaged before the end of what was saved. A file that has
/// been replaced under its name it does not lock (SQLITE_READONLY_DBMOVED). For databases whose
/// pages reserve these bytes from the beginning on. SQLite's own checksum VFS (ext/misc/cksumvfs.c)
/// showed the way.
const char* checkedPagesVfs();

}  // namespace ostraka::store
