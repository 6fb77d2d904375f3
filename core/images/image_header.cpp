#include "images/image_header.h"

#include <cstdint>
#include <optional>

#include "base/limits.h"
#include "base/message.h"
#include "files/files.h"
#include "images/heif_image.h"
#include "images/jpeg_image.h"
#include "images/png_image.h"
#include "images/raw_image.h"

namespace ostraka::images {
namespace {

constexpr std::int64_t kMaxPixels = limits::kImagePixels.most, kMaxSide = limits::kImageSide.most;

// Bytes with bounds: reading past the end gives nothing.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
  std::size_t size() const { return bytes_.size(); }
  std::optional<std::uint32_t> at(std::size_t offset, int count, bool big_endian) const {
    if (offset > bytes_.size() || bytes_.size() - offset < static_cast<std::size_t>(count))
      return std::nullopt;
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) {
      const std::size_t k = offset + static_cast<std::size_t>(big_endian ? i : count - 1 - i);
      value = value << 8 | static_cast<unsigned char>(bytes_[k]);
    }
    return value;
  }
  std::size_t find(char byte, std::size_t from) const { return bytes_.find(byte, from); }

 private:
  std::string_view bytes_;
};

bool isStartOfFrame(std::uint32_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// Entropy-coded bytes go on until a 0xFF that is followed by neither 0 nor a restart marker.
std::size_t afterScan(const Bytes& bytes, std::size_t offset) {
  while (true) {
    offset = bytes.find('\xFF', offset);
    const auto next =
        offset == std::string_view::npos ? std::nullopt : bytes.at(offset + 1, 1, true);
    if (!next) return bytes.size();
    if (*next == 0 || (*next >= 0xD0 && *next <= 0xD7))
      offset += 2;
    else if (*next == 0xFF)
      offset += 1;
    else
      return offset;
  }
}

Result<ImageSize> jpegSize(const Bytes& bytes, const std::string& where) {
  std::optional<ImageSize> size;
  std::size_t offset = 2;
  std::uint64_t scans = 0;
  while (true) {
    const auto lead = bytes.at(offset, 1, true);
    const auto marker = bytes.at(offset + 1, 1, true);
    if (!lead || !marker) return cutOffImage(where);
    if (*lead != 0xFF) return damagedJpeg(where);
    if (*marker == 0xFF) {  // filler
      ++offset;
      continue;
    }
    if (*marker == 0xD9) break;  // the end
    if (*marker == 0x01 || (*marker >= 0xD0 && *marker <= 0xD8)) {
      offset += 2;
      continue;
    }
    const auto length = bytes.at(offset + 2, 2, true);
    if (!length) return cutOffImage(where);
    if (*length < 2) return damagedJpeg(where);
    if (isStartOfFrame(*marker) && !size) {
      const auto height = bytes.at(offset + 5, 2, true);
      const auto width = bytes.at(offset + 7, 2, true);
      if (!height || !width) return cutOffImage(where);
      const Result<ImageSize> found = checkedSize(*width, *height, where);
      if (!found) return found.error();
      size = *found;
    }
    offset += 2 + *length;
    if (*marker != 0xDA) continue;
    if (++scans > limits::kJpegScans.most) return damagedJpeg(where);
    offset = afterScan(bytes, offset);
  }
  if (!size) return Error::unusable(message("The JPEG file contains no image."), where);
  return *size;
}

Result<ImageSize> pngSize(const Bytes& bytes, const std::string& where) {
  constexpr std::uint32_t kHeader = 0x49484452, kEnd = 0x49454E44;  // IHDR, IEND
  const auto first = bytes.at(12, 4, true), width = bytes.at(16, 4, true);
  const auto height = bytes.at(20, 4, true);
  if (!first || !width || !height) return cutOffImage(where);
  if (*first != kHeader)
    return Error::unusable(message("The PNG image is damaged; copy it again."), where);
  const Result<ImageSize> size = checkedSize(*width, *height, where);
  if (!size) return size.error();
  std::size_t offset = 8;
  while (true) {
    const auto length = bytes.at(offset, 4, true), type = bytes.at(offset + 4, 4, true);
    if (!length || !type) return cutOffImage(where);
    offset += std::size_t{12} + *length;  // length, type, content, checksum
    if (offset > bytes.size()) return cutOffImage(where);
    if (*type == kEnd) return *size;
  }
}

// One entry of a TIFF directory: numbers of 1, 2 or 4 bytes, in place or elsewhere in the file.
struct TiffEntry {
  std::uint32_t type = 0, count = 0;
  std::size_t offset = 0;
  int bytesEach() const { return type == 1 ? 1 : type == 3 ? 2 : type == 4 ? 4 : 0; }
};

std::optional<std::uint32_t> number(const Bytes& bytes, const TiffEntry& entry, std::uint32_t index,
                                    bool big) {
  if (entry.bytesEach() == 0 || index >= entry.count) return std::nullopt;
  return bytes.at(entry.offset + std::size_t{index} * entry.bytesEach(), entry.bytesEach(), big);
}

// Strips or tiles must lie inside of the file.
bool reachesItsEnd(const Bytes& bytes, const TiffEntry& starts, const TiffEntry& lengths,
                   bool big) {
  if (starts.count == 0 || starts.count != lengths.count) return false;
  if (starts.count > bytes.size() / 2) return false;
  for (std::uint32_t i = 0; i < starts.count; ++i) {
    const auto start = number(bytes, starts, i, big), length = number(bytes, lengths, i, big);
    if (!start || !length || std::size_t{*start} + *length > bytes.size()) return false;
  }
  return true;
}

Result<ImageSize> tiffSize(const Bytes& bytes, bool big, const std::string& where) {
  const auto directory = bytes.at(4, 4, big);
  const auto count = directory ? bytes.at(*directory, 2, big) : std::nullopt;
  if (!count) return cutOffImage(where);
  TiffEntry width, height, starts, lengths;
  for (std::uint32_t i = 0; i < *count; ++i) {
    const std::size_t at = std::size_t{*directory} + 2 + std::size_t{12} * i;
    const auto tag = bytes.at(at, 2, big), type = bytes.at(at + 2, 2, big);
    const auto entries = bytes.at(at + 4, 4, big), value = bytes.at(at + 8, 4, big);
    if (!tag || !type || !entries || !value) return cutOffImage(where);
    TiffEntry entry{*type, *entries, at + 8};
    if (std::size_t{*entries} * entry.bytesEach() > 4) entry.offset = *value;
    if (*tag == 256) width = entry;
    if (*tag == 257) height = entry;
    if (*tag == 273 || *tag == 324) starts = entry;
    if (*tag == 279 || *tag == 325) lengths = entry;
  }
  const auto w = number(bytes, width, 0, big), h = number(bytes, height, 0, big);
  if (!w || !h)
    return Error::unusable(message("The TIFF file does not state the image's size."), where);
  const Result<ImageSize> size = checkedSize(*w, *h, where);
  if (size && !reachesItsEnd(bytes, starts, lengths, big)) return cutOffImage(where);
  return size;
}

}  // namespace

Error cutOffImage(const std::string& where) {
  return Error::unusable(message("The image file is truncated; copy it from the camera again."),
                         where);
}
Error damagedJpeg(const std::string& where) {
  return Error::unusable(message("The JPEG image is damaged; copy it again."), where);
}
Error undecodableImage(const std::string& where) {
  return Error::unusable(message("The image cannot be decoded; copy it again."), where);
}

Result<ImageSize> checkedSize(std::int64_t width, std::int64_t height, const std::string& where) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide ||
      width * height > kMaxPixels)
    return Error::unusable(
        message("The image header states a size of %1 x %2 pixels, which cannot be used.", width,
                height),
        where);
  return ImageSize{static_cast<int>(width), static_cast<int>(height)};
}

Result<ImageSize> imageSize(std::string_view text, const std::string& where) {
  const Bytes bytes(text);
  if (text.empty())
    return Error::unusable(message("The file is empty; copy it from the camera again."), where);
  if (hasRawEnding(where)) return rawSize(text, where);
  if (isHeif(text)) return heifSize(text, where);
  if (isJpeg(text)) return jpegSize(bytes, where);
  if (isPng(text)) return pngSize(bytes, where);
  if (text.starts_with(std::string_view("II*\0", 4))) return tiffSize(bytes, false, where);
  if (text.starts_with(std::string_view("MM\0*", 4))) return tiffSize(bytes, true, where);
  return Error::unusable(message("Not a JPEG, PNG, TIFF, HEIC or RAW image."), where);
}

Result<ImageSize> readImageSize(const std::filesystem::path& file) {
  const Result<std::string> bytes = readFile(file, limits::kImageBytes.most);
  if (!bytes) return bytes.error();
  return imageSize(*bytes, file.string());
}

}  // namespace ostraka::images
