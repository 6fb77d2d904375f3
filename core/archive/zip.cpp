#include "archive/zip.h"

#include <cstdint>
#include <limits>

#include "base/message.h"
#include "files/checksum.h"

namespace ostraka::archive {
namespace {

constexpr std::uint16_t kVersion = 20;     // folders and plain entries
constexpr std::uint16_t kFirstDay = 0x21;  // 1980-01-01
constexpr std::size_t kMostBytes = std::numeric_limits<std::uint32_t>::max() - (1U << 20);

void put16(std::string& out, std::uint16_t value) {
  out += static_cast<char>(value & 0xFF);
  out += static_cast<char>(value >> 8);
}

void put32(std::string& out, std::size_t value) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>(value >> (8 * i) & 0xFF);
}

// What the local and the central header share.
void putEntry(std::string& out, const ZipEntry& entry, std::uint32_t crc) {
  put16(out, kVersion);
  put16(out, 0);  // flags
  put16(out, 0);  // stored
  put16(out, 0);  // midnight
  put16(out, kFirstDay);
  put32(out, crc);
  put32(out, entry.bytes.size());
  put32(out, entry.bytes.size());
  put16(out, static_cast<std::uint16_t>(entry.name.size()));
  put16(out, 0);  // nothing extra
}

}  // namespace

Result<std::string> zipped(const std::vector<ZipEntry>& entries) {
  std::size_t total = 0;
  for (const ZipEntry& entry : entries) total += entry.bytes.size() + 2 * entry.name.size() + 128;
  if (total > kMostBytes || entries.size() > std::numeric_limits<std::uint16_t>::max())
    return Error::unusable(message("This is too large for one ZIP file; select fewer sherds."));
  std::string out, central;
  out.reserve(total);
  for (const ZipEntry& entry : entries) {
    const std::uint32_t crc = crc32(entry.bytes);
    put32(central, 0x02014B50);
    put16(central, kVersion);  // made by
    putEntry(central, entry, crc);
    put16(central, 0);  // no comment
    put16(central, 0);  // first disk
    put16(central, 0);  // internal attributes
    put32(central, 0);  // external attributes
    put32(central, out.size());
    central += entry.name;
    put32(out, 0x04034B50);
    putEntry(out, entry, crc);
    out += entry.name;
    out += entry.bytes;
  }
  const std::size_t at = out.size();
  out += central;
  put32(out, 0x06054B50);
  put16(out, 0);
  put16(out, 0);
  put16(out, static_cast<std::uint16_t>(entries.size()));
  put16(out, static_cast<std::uint16_t>(entries.size()));
  put32(out, central.size());
  put32(out, at);
  put16(out, 0);
  return out;
}

}  // namespace ostraka::archive
