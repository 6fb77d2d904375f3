#include "store/page_checksums.h"

#include <endian.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "store/wal_content.h"

namespace ostraka::store {
namespace {

constexpr std::size_t kSummed = kPageBytes - kReservedBytes;

constexpr sqlite3_int64 kWalHeader = kWalHeaderBytes, kFrameHeader = kFrameHeaderBytes;
constexpr sqlite3_int64 kFrame = kFrameHeader + static_cast<sqlite3_int64>(kPageBytes);

// A step that loses nothing: for each word another result, for each state another one. No single
// bit becomes a single bit: the product alone leaves the top bit one, and in the next word there
// is a bit that makes it undone.
std::uint64_t stirred(std::uint64_t state, std::uint64_t word) {
  const std::uint64_t product = (state ^ word) * 0x9E3779B97F4A7C15u;
  return std::rotl(product ^ (product >> 32), 29);
}

std::uint64_t wordAt(const unsigned char* page, std::size_t word) {
  std::uint64_t value = 0;
  std::memcpy(&value, page + 8 * word, 8);
  return le64toh(value);
}

// A file opened by this VFS; the system's own file follows it in memory.
struct CheckedFile {
  sqlite3_file shim;
  std::int64_t is_wal;
};
static_assert(sizeof(CheckedFile) % alignof(std::max_align_t) == 0);

bool isWal(const sqlite3_file* file) {
  return reinterpret_cast<const CheckedFile*>(file)->is_wal != 0;
}
sqlite3_file* below(sqlite3_file* file) {
  return reinterpret_cast<sqlite3_file*>(reinterpret_cast<CheckedFile*>(file) + 1);
}
const sqlite3_io_methods& methodsOf(sqlite3_file* file) {
  return *file->pMethods;
}

void putBigEndian(unsigned char* at, std::uint32_t value) {
  value = htobe32(value);
  std::memcpy(at, &value, 4);
}

bool isPageOfDatabase(int amount, sqlite3_int64 offset) {
  return amount == static_cast<int>(kPageBytes) && offset % amount == 0;
}
bool isPageOfWal(int amount, sqlite3_int64 offset) {
  return amount == static_cast<int>(kPageBytes) &&
         (offset - kWalHeader - kFrameHeader) % kFrame == 0;
}

// SQLite reads the header alone when it is about to look which frames count, and nobody writes.
int lookAtWal(sqlite3_file* system) {
  sqlite3_int64 bytes = 0;
  if (const int code = methodsOf(system).xFileSize(system, &bytes); code != SQLITE_OK) return code;
  int failed = SQLITE_OK;
  const ReadAt read = [&](unsigned char* to, std::size_t count, std::int64_t from) {
    const int code = methodsOf(system).xRead(system, to, static_cast<int>(count), from);
    if (code != SQLITE_OK && code != SQLITE_IOERR_SHORT_READ) failed = code;
    return code == SQLITE_OK;
  };
  const bool damaged = readWal(read, bytes).damaged;
  return damaged ? SQLITE_IOERR_DATA : failed;
}

int readPage(sqlite3_file* file, void* buffer, int amount, sqlite3_int64 offset) {
  sqlite3_file* system = below(file);
  if (const int code = methodsOf(system).xRead(system, buffer, amount, offset); code != SQLITE_OK)
    return code;
  const bool wal = isWal(file);
  std::uint32_t number = 0;
  if (wal && offset == 0 && amount == kWalHeader) return lookAtWal(system);
  if (!wal && isPageOfDatabase(amount, offset)) {
    number = static_cast<std::uint32_t>(offset / amount) + 1;
  } else if (wal && isPageOfWal(amount, offset)) {
    std::array<unsigned char, 4> bytes{};
    const int code = methodsOf(system).xRead(system, bytes.data(), 4, offset - kFrameHeader);
    if (code != SQLITE_OK) return code;
    number = bigEndian(bytes.data());
  } else {
    // Of the database only its header is read in parts; pages of another size are not ours.
    return wal || amount < 512 ? SQLITE_OK : SQLITE_IOERR_DATA;
  }
  return isWholePage(static_cast<const unsigned char*>(buffer), number) ? SQLITE_OK
                                                                        : SQLITE_IOERR_DATA;
}

// SQLite summed the frame before the page got its checksum, so it is summed again, from what the
// disk holds of the frame before it.
int writeWalPage(sqlite3_file* system, unsigned char* page, sqlite3_int64 offset) {
  const auto read = [&](unsigned char* bytes, int amount, sqlite3_int64 from) {
    return methodsOf(system).xRead(system, bytes, amount, from);
  };
  const sqlite3_int64 frame = offset - kFrameHeader;
  const bool first = frame == kWalHeader;
  std::array<unsigned char, kFrameHeader> header{};
  std::array<unsigned char, 8> before{};
  std::array<unsigned char, 4> magic{};
  int code = read(header.data(), kFrameHeader, frame);
  if (code == SQLITE_OK)
    code = read(before.data(), 8,
                first ? static_cast<sqlite3_int64>(kWalHeaderChecksumAt)
                      : frame - kFrame + static_cast<sqlite3_int64>(kFrameChecksumAt));
  if (code == SQLITE_OK) code = read(magic.data(), 4, 0);
  if (code != SQLITE_OK) return code;
  storeChecksum(page, bigEndian(header.data()));
  const bool big_endian = (magic[3] & 1) != 0;
  std::uint32_t s0 = bigEndian(before.data()), s1 = bigEndian(before.data() + 4);
  addToWalChecksum(header.data(), kFrameSummedBytes, big_endian, s0, s1);
  addToWalChecksum(page, kPageBytes, big_endian, s0, s1);
  std::array<unsigned char, 8> sums{};
  putBigEndian(sums.data(), s0);
  putBigEndian(sums.data() + 4, s1);
  code = methodsOf(system).xWrite(system, page, static_cast<int>(kPageBytes), offset);
  if (code != SQLITE_OK) return code;
  return methodsOf(system).xWrite(system, sums.data(), 8,
                                  frame + static_cast<sqlite3_int64>(kFrameChecksumAt));
}

// The reserved bytes are set in SQLite's own copy of the page, as SQLite's checksum VFS does it: a
// page that is journalled later carries a right checksum.
int writePage(sqlite3_file* file, const void* buffer, int amount, sqlite3_int64 offset) {
  sqlite3_file* system = below(file);
  auto* page = static_cast<unsigned char*>(const_cast<void*>(buffer));
  if (isWal(file) && isPageOfWal(amount, offset)) return writeWalPage(system, page, offset);
  if (!isWal(file) && isPageOfDatabase(amount, offset))
    storeChecksum(page, static_cast<std::uint32_t>(offset / amount) + 1);
  return methodsOf(system).xWrite(system, buffer, amount, offset);
}

// Whoever waited while the file was replaced would read the old one with the new one's WAL, and
// write the new WAL into the old file.
int lockFile(sqlite3_file* file, int level) {
  sqlite3_file* system = below(file);
  const int code = methodsOf(system).xLock(system, level);
  if (code != SQLITE_OK || level != SQLITE_LOCK_SHARED) return code;
  int moved = 0;
  if (methodsOf(system).xFileControl(system, SQLITE_FCNTL_HAS_MOVED, &moved) != SQLITE_OK ||
      moved == 0)
    return SQLITE_OK;
  methodsOf(system).xUnlock(system, SQLITE_LOCK_NONE);
  return SQLITE_READONLY_DBMOVED;
}

// Everything else is the system's.
template <auto Method, class... Arguments>
auto passed(sqlite3_file* file, Arguments... arguments) {
  sqlite3_file* system = below(file);
  return (methodsOf(system).*Method)(system, arguments...);
}
using M = sqlite3_io_methods;
constexpr sqlite3_io_methods kMethods = {
    2,  // without xFetch: what is mapped into memory would not be checked
    passed<&M::xClose>,
    readPage,
    writePage,
    passed<&M::xTruncate, sqlite3_int64>,
    passed<&M::xSync, int>,
    passed<&M::xFileSize, sqlite3_int64*>,
    lockFile,
    passed<&M::xUnlock, int>,
    passed<&M::xCheckReservedLock, int*>,
    passed<&M::xFileControl, int, void*>,
    passed<&M::xSectorSize>,
    passed<&M::xDeviceCharacteristics>,
    passed<&M::xShmMap, int, int, int, void volatile**>,
    passed<&M::xShmLock, int, int, int>,
    passed<&M::xShmBarrier>,
    passed<&M::xShmUnmap, int>,
    nullptr,
    nullptr};

sqlite3_vfs* systemVfs() {
  static sqlite3_vfs* const system = sqlite3_vfs_find(nullptr);
  return system;
}

int openFile(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* flags_out) {
  sqlite3_vfs* system = systemVfs();
  // Journals and temporary files hold copies only.
  if ((flags & (SQLITE_OPEN_MAIN_DB | SQLITE_OPEN_WAL)) == 0)
    return system->xOpen(system, name, file, flags, flags_out);
  auto* checked = reinterpret_cast<CheckedFile*>(file);
  checked->shim.pMethods = nullptr;
  checked->is_wal = (flags & SQLITE_OPEN_WAL) != 0 ? 1 : 0;
  const int code = system->xOpen(system, name, below(file), flags, flags_out);
  if (below(file)->pMethods != nullptr) checked->shim.pMethods = &kMethods;
  return code;
}

}  // namespace

std::uint32_t bigEndian(const unsigned char* at) {
  std::uint32_t value = 0;
  std::memcpy(&value, at, 4);
  return be32toh(value);
}

// Four sums side by side, which the processor adds at once.
std::uint64_t pageChecksum(const unsigned char* page, std::uint32_t number) {
  std::array<std::uint64_t, 4> sums = {number + 1u, 2, 3, 4};
  std::size_t word = 0;
  for (; word + 4 <= kSummed / 8; word += 4)
    for (std::size_t lane = 0; lane < 4; ++lane)
      sums[lane] = stirred(sums[lane], wordAt(page, word + lane));
  for (; word < kSummed / 8; ++word) sums[0] = stirred(sums[0], wordAt(page, word));
  std::uint64_t all = sums[0];
  // Stirred once more, since the same change in two sums must not be the same in all.
  for (std::size_t lane = 1; lane < 4; ++lane) all = stirred(all, stirred(sums[lane], lane));
  return stirred(all ^ (all >> 32), kPageBytes);
}

std::uint64_t storedChecksum(const unsigned char* page) {
  return wordAt(page, kSummed / 8);
}

void storeChecksum(unsigned char* page, std::uint32_t number) {
  const std::uint64_t sum = htole64(pageChecksum(page, number));
  std::memcpy(page + kSummed, &sum, 8);
}

bool turnBackOneBit(unsigned char* page, std::uint32_t number) {
  const std::uint64_t wanted = storedChecksum(page);
  if (std::all_of(page, page + kPageBytes, [](unsigned char byte) { return byte == 0; }))
    return false;  // never written: no page is one bit from that
  std::optional<std::size_t> found;
  const auto turn = [page](std::size_t bit) {
    page[bit / 8] ^= static_cast<unsigned char>(1 << bit % 8);
  };
  for (std::size_t bit = 0; bit < 8 * (kPageBytes - kReservedBytes); ++bit) {
    turn(bit);
    const bool fits = pageChecksum(page, number) == wanted;
    turn(bit);
    if (!fits) continue;
    if (found) return false;
    found = bit;
  }
  const std::uint64_t wrong = wanted ^ pageChecksum(page, number);
  const bool of_the_checksum = (wrong & (wrong - 1)) == 0;
  if (of_the_checksum == found.has_value()) return false;
  if (found)
    turn(*found);
  else
    storeChecksum(page, number);
  return true;
}

const char* checkedPagesVfs() {
  static sqlite3_vfs vfs = [] {
    sqlite3_initialize();
    sqlite3_vfs made = *systemVfs();
    made.pNext = nullptr;
    made.zName = "ostraka-checked-pages";
    made.szOsFile += static_cast<int>(sizeof(CheckedFile));
    made.xOpen = openFile;
    return made;
  }();
  static const int registered = sqlite3_vfs_register(&vfs, 0);
  return registered == SQLITE_OK ? vfs.zName : nullptr;
}

}  // namespace ostraka::store
