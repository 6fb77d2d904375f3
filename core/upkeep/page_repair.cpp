#include "upkeep/page_repair.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <vector>

#include "files/files.h"
#include "store/page_checksums.h"
#include "store/wal_content.h"

namespace ostraka::upkeep {
namespace {

namespace fs = std::filesystem;

using Page = std::array<unsigned char, store::kPageBytes>;
// sqlite.org/fileformat2.html, sections 1.3 and 1.6.
constexpr std::size_t kPageCount = 28, kRootHeader = 100;
constexpr unsigned char kInnerTablePage = 5;
// A file that is something else altogether is not tried bit by bit, which takes 10 ms a page.
constexpr std::size_t kMostTried = 1000;
constexpr std::size_t kMostPages = std::size_t{1} << 22;  // 16 GiB

class PageFile {
 public:
  PageFile(const fs::path& path, std::ios::openmode mode)
      : path_(path), file_(path, std::ios::binary | mode) {
    std::error_code ignored;
    const std::uintmax_t bytes = fs::file_size(path, ignored);
    if (!ignored)
      pages_ = static_cast<std::uint32_t>((bytes + store::kPageBytes - 1) / store::kPageBytes);
  }
  std::uint32_t pages() const { return pages_; }
  /// Zeros where the file ends.
  Page read(std::uint32_t number) {
    Page page{};
    file_.clear();
    file_.seekg(static_cast<std::streamoff>((number - 1) * store::kPageBytes));
    file_.read(reinterpret_cast<char*>(page.data()), static_cast<std::streamsize>(page.size()));
    return page;
  }
  bool write(std::uint32_t number, const Page& page) {
    file_.clear();
    file_.seekp(static_cast<std::streamoff>((number - 1) * store::kPageBytes));
    errno = 0;
    file_.write(reinterpret_cast<const char*>(page.data()), page.size());
    file_.flush();
    reason_ = errno;
    pages_ = std::max(pages_, number);
    return file_.good();
  }
  Error cannotBeWritten() const { return cannotWrite(path_, reason_); }

 private:
  fs::path path_;
  std::fstream file_;
  std::uint32_t pages_ = 0;
  int reason_ = 0;  ///< errno of the last write
};

std::uint32_t pageNumberAt(const Page& page, std::size_t at) {
  return std::uint32_t{page[at]} << 24 | std::uint32_t{page[at + 1]} << 16 |
         std::uint32_t{page[at + 2]} << 8 | page[at + 3];
}

// SQLite reads no WAL beside a file whose first page is destroyed, though that page may stand in
// it. Pages come as the frames hold them, the damaged ones too, which are then repaired as all
// others: what the file holds of them is older, and looks whole.
Result<void> putWalInto(const fs::path& path, PageRepair& repair) {
  const fs::path wal = path.string() + "-wal";
  std::error_code failed;
  const std::uintmax_t bytes = fs::file_size(wal, failed);
  if (failed) return {};
  std::ifstream in(wal, std::ios::binary);
  const auto read = [&in](unsigned char* to, std::size_t count, std::int64_t from) {
    in.clear();
    in.seekg(from);
    return static_cast<bool>(
        in.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count)));
  };
  const store::WalContent content = store::readWal(read, static_cast<std::int64_t>(bytes));
  repair.wal_damaged = content.damaged;
  PageFile file(path, std::ios::in | std::ios::out);
  const std::size_t most = file.pages() + content.frames.size();
  for (const store::WalFrame& frame : content.frames) {
    Page page{};
    if (frame.page == 0 || frame.page > most || !read(page.data(), page.size(), frame.at))
      ++repair.wal_pages_lost;
    else if (!file.write(frame.page, page))
      return file.cannotBeWritten();
  }
  fs::remove(wal, failed);
  return failed ? Result<void>(cannotWrite(wal, failed.value())) : Result<void>();
}

// The root of the schema and, where it has inner cells, the leaves below it.
std::vector<std::uint32_t> schemaPages(const Page& root) {
  std::vector<std::uint32_t> pages = {1};
  if (root[kRootHeader] != kInnerTablePage) return pages;
  const std::size_t cells = std::size_t{root[kRootHeader + 3]} << 8 | root[kRootHeader + 4];
  pages.push_back(pageNumberAt(root, kRootHeader + 8));
  for (std::size_t i = 0; i < cells; ++i) {
    const std::size_t at = kRootHeader + 12 + 2 * i;
    if (at + 2 > store::kPageBytes) break;
    const std::size_t cell = std::size_t{root[at]} << 8 | root[at + 1];
    if (cell + 4 <= store::kPageBytes) pages.push_back(pageNumberAt(root, cell));
  }
  return pages;
}

}  // namespace

Result<PageRepair> repairPages(const fs::path& path, std::span<const fs::path> backups) {
  PageRepair repair;
  if (Result<void> put = putWalInto(path, repair); !put) return put.error();
  PageFile file(path, std::ios::in | std::ios::out);
  std::uint32_t pages = file.pages();
  for (std::uint32_t number = 1; number <= pages; ++number) {
    Page page = file.read(number);
    bool whole = store::isWholePage(page.data(), number);
    if (!whole && repair.lost.size() < kMostTried && store::turnBackOneBit(page.data(), number)) {
      whole = true;
      ++repair.by_bit;
      if (!file.write(number, page)) return file.cannotBeWritten();
    }
    for (const fs::path& backup : backups) {
      if (whole) break;
      Page other = PageFile(backup, std::ios::in).read(number);
      if (!store::isWholePage(other.data(), number) ||
          store::storedChecksum(other.data()) != store::storedChecksum(page.data()))
        continue;
      whole = true;
      ++repair.by_backup;
      if (!file.write(number, other)) return file.cannotBeWritten();
    }
    if (!whole) repair.lost.insert(number);
    if (number == 1 && whole)
      pages = std::clamp<std::uint32_t>(pageNumberAt(page, kPageCount), pages, kMostPages);
  }
  repair.pages = static_cast<int>(pages);
  if (pages > file.pages() && !file.write(pages, Page{})) return file.cannotBeWritten();
  return repair;
}

Result<bool> takeSchemaPages(const fs::path& path, const PageRepair& repair,
                             const fs::path& backup) {
  PageFile file(path, std::ios::in | std::ios::out), source(backup, std::ios::in);
  const Page root = source.read(1);
  for (const std::uint32_t number : schemaPages(root)) {
    if (number == 0 || number > file.pages()) return false;
    if (!repair.lost.contains(number)) continue;
    Page page = source.read(number);
    if (number == 1) {
      const std::uint32_t pages = file.pages();
      for (std::size_t i = 0; i < 4; ++i)
        page[kPageCount + i] = static_cast<unsigned char>(pages >> (24 - 8 * i));
      store::storeChecksum(page.data(), 1);
    }
    if (!file.write(number, page)) return file.cannotBeWritten();
  }
  return true;
}

}  // namespace ostraka::upkeep
