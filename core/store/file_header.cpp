#include "store/file_header.h"

#include <sqlite3.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <system_error>

#include "base/message.h"
#include "store/page_checksums.h"

namespace ostraka::store {
namespace {

namespace fs = std::filesystem;

// sqlite.org/fileformat2.html, section 1.3.
using Header = std::array<unsigned char, 100>;
constexpr std::string_view kMagic("SQLite format 3", 16);
constexpr std::size_t kPageSize = 16, kWriteVersion = 18, kReadVersion = 19, kReserved = 20,
                      kVersion = 60, kApplication = 68;
constexpr std::uint32_t kOstraka = 1330861138;  // OSTR

struct Beginning {
  int code = 0;  ///< of SQLite, which could not read it
  std::int64_t bytes = 0;
  Header header{};
  bool has_wal = false;

  // A file says that it has no WAL (1) until its first connection is about to write one (2), and
  // Database::copyTo makes 1 of it again. SQLite applies what lies beside it all the same.
  bool isBesideWalOfAnother() const {
    return has_wal && header[kWriteVersion] == 1 && header[kReadVersion] == 1;
  }
};

// Through SQLite: a process that closes a file of its own loses SQLite's locks on it. The WAL is
// looked for between opening and reading: meanwhile a repair may replace the file, or another
// process begin its first WAL.
Beginning beginningOf(const fs::path& file) {
  Beginning found;
  sqlite3* handle = nullptr;
  sqlite3_file* opened = nullptr;
  sqlite3_int64 bytes = 0;
  found.code = sqlite3_open_v2(file.c_str(), &handle, SQLITE_OPEN_READONLY, nullptr);
  if (found.code == SQLITE_OK)
    found.code = sqlite3_file_control(handle, "main", SQLITE_FCNTL_FILE_POINTER, &opened);
  if (found.code == SQLITE_OK && opened->pMethods != nullptr) {
    std::error_code none;
    const fs::path wal = sqlite3_filename_wal(sqlite3_db_filename(handle, "main"));
    found.has_wal = fs::file_size(wal, none) > 0 && !none;
    found.code = opened->pMethods->xFileSize(opened, &bytes);
  }
  const auto count = static_cast<int>(found.header.size());
  if (found.code == SQLITE_OK && bytes >= count)
    found.code = opened->pMethods->xRead(opened, found.header.data(), count, 0);
  found.bytes = bytes;
  sqlite3_close(handle);
  return found;
}

}  // namespace

Error damagedCatalogue(const Message& why, const fs::path& file) {
  return {ErrorCode::Damaged,
          message("The catalogue is damaged (%1); nothing was changed, and no backup was deleted. "
                  "Restore it with 'ostraka catalogue repair PROJECT'.",
                  why),
          file.string()};
}

fs::path repairedBeside(const fs::path& file) {
  return file.string() + ".repaired";
}

Result<void> checkHeader(const fs::path& file) {
  const Beginning found = beginningOf(file);
  const Header& header = found.header;
  if (found.code != SQLITE_OK)
    return Error::unusable(
        message("The catalogue cannot be read; check that it exists and check its permissions."),
        file.string());
  if (found.bytes == 0) return damagedCatalogue(message("the file is empty"), file);
  if (std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0)
    return damagedCatalogue(message("the file is not a database"), file);
  if (bigEndian(header.data() + kApplication) != kOstraka)
    return damagedCatalogue(message("the file belongs to another program"), file);
  if (bigEndian(header.data() + kVersion) == 0)
    return damagedCatalogue(message("the file contains no catalogue"), file);
  const std::size_t page_bytes = std::size_t{header[kPageSize]} << 8 | header[kPageSize + 1];
  if (page_bytes != kPageBytes || header[kReserved] != kReservedBytes)
    return damagedCatalogue(message("the header is inconsistent"), file);
  if (found.isBesideWalOfAnother())
    return damagedCatalogue(message("it is a backup, but the -wal file beside it belongs to the "
                                    "catalogue that it replaced"),
                            file);
  return {};
}

bool hasWalOfAnother(const fs::path& file) {
  const Beginning found = beginningOf(file);
  return found.code == SQLITE_OK && found.isBesideWalOfAnother();
}

}  // namespace ostraka::store
