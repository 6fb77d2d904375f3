#include "upkeep/page_repair.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <optional>
#include <vector>

#include "files/cannot_write.h"
#include "files/files.h"
#include "store/page_checksums.h"

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

// The one bit whose turning makes the page what its checksum says. Where two do, neither is proven.
bool turnBackOneBit(Page& page, std::uint32_t number) {
  const std::uint64_t wanted = store::storedChecksum(page.data());
  if (std::all_of(page.begin(), page.end(), [](unsigned char byte) { return byte == 0; }))
    return false;  // never written: no page is one bit from that
  std::optional<std::size_t> found;
  const auto turn = [&page](std::size_t bit) {
    page[bit / 8] ^= static_cast<unsigned char>(1 << bit % 8);
  };
  for (std::size_t bit = 0; bit < 8 * (store::kPageBytes - store::kReservedBytes); ++bit) {
    turn(bit);
    const bool fits = store::pageChecksum(page.data(), number) == wanted;
    turn(bit);
    if (!fits) continue;
    if (found) return false;
    found = bit;
  }
  const std::uint64_t wrong = wanted ^ store::pageChecksum(page.data(), number);
  const bool of_the_checksum = (wrong & (wrong - 1)) == 0;
  if (of_the_checksum == found.has_value()) return false;
  if (found)
    turn(*found);
  else
    store::storeChecksum(page.data(), number);
  return true;
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
  PageFile file(path, std::ios::in | std::ios::out);
  PageRepair repair;
  std::uint32_t pages = file.pages();
  for (std::uint32_t number = 1; number <= pages; ++number) {
    Page page = file.read(number);
    bool whole = store::isWholePage(page.data(), number);
    if (!whole && repair.lost.size() < kMostTried && turnBackOneBit(page, number)) {
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
