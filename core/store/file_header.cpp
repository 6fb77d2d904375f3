#include "store/file_header.h"

#include <sqlite3.h>

#include <array>
#include <cstring>

#include "store/page_checksums.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

// sqlite.org/fileformat2.html, section 1.3.
using Header = std::array<unsigned char, 100>;
constexpr std::string_view kMagic("SQLite format 3", 16);
constexpr std::size_t kPageSize = 16, kReserved = 20, kVersion = 60, kApplication = 68;
constexpr std::uint32_t kOstraka = 1330861138;  // OSTR

std::uint32_t bigEndianAt(const Header& header, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | header[at + i];
  return value;
}

}  // namespace

Error damagedCatalogue(const std::string& why, const fs::path& file) {
  return {ErrorCode::Damaged,
          "The catalogue is damaged (" + why +
              "); nothing was changed, and no backup was deleted. Restore it with 'ostraka "
              "catalogue repair PROJECT'.",
          file.string()};
}

fs::path repairedBeside(const fs::path& file) {
  return file.string() + ".repaired";
}

// Through SQLite: a process that closes a file of its own loses SQLite's locks on it.
Result<void> checkHeader(const fs::path& file) {
  Header header{};
  sqlite3* handle = nullptr;
  sqlite3_file* opened = nullptr;
  sqlite3_int64 bytes = 0;
  int code = sqlite3_open_v2(file.c_str(), &handle, SQLITE_OPEN_READONLY, nullptr);
  if (code == SQLITE_OK)
    code = sqlite3_file_control(handle, "main", SQLITE_FCNTL_FILE_POINTER, &opened);
  if (code == SQLITE_OK && opened->pMethods != nullptr)
    code = opened->pMethods->xFileSize(opened, &bytes);
  if (code == SQLITE_OK && bytes >= static_cast<sqlite3_int64>(header.size()))
    code = opened->pMethods->xRead(opened, header.data(), static_cast<int>(header.size()), 0);
  sqlite3_close(handle);
  if (code != SQLITE_OK)
    return Error::unusable(
        "The catalogue cannot be read; check that it exists and check its permissions.",
        file.string());
  if (bytes == 0) return damagedCatalogue("the file is empty", file);
  if (std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0)
    return damagedCatalogue("the file is not a database", file);
  if (bigEndianAt(header, kApplication) != kOstraka)
    return damagedCatalogue("the file belongs to another program", file);
  if (bigEndianAt(header, kVersion) == 0)
    return damagedCatalogue("the file contains no catalogue", file);
  const std::size_t page_bytes = std::size_t{header[kPageSize]} << 8 | header[kPageSize + 1];
  if (page_bytes != kPageBytes || header[kReserved] != kReservedBytes)
    return damagedCatalogue("the header is inconsistent", file);
  return {};
}

}  // namespace ostraka::store
