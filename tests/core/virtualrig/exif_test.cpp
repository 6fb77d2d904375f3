#include "virtualrig/exif.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>

namespace ostraka::virtualrig {
namespace {

// A reader of its own, by TIFF 6.0 and Exif 2.3: little-endian, entries of 12 bytes.
class Tiff {
 public:
  explicit Tiff(const std::string& segment) : bytes_(segment.substr(6)) {}

  std::uint32_t at(std::size_t offset, int size) const {
    std::uint32_t value = 0;
    for (int i = size - 1; i >= 0; --i)
      value = value << 8 | static_cast<std::uint8_t>(bytes_.at(offset + static_cast<unsigned>(i)));
    return value;
  }
  /// Tag -> offset of its entry.
  std::map<int, std::size_t> directory(std::size_t offset) const {
    std::map<int, std::size_t> entries;
    for (std::uint32_t i = 0; i < at(offset, 2); ++i)
      entries[static_cast<int>(at(offset + 2 + 12 * i, 2))] = offset + 2 + 12 * i;
    return entries;
  }
  std::string text(std::size_t entry) const {
    EXPECT_EQ(at(entry + 2, 2), 2U);
    const std::uint32_t count = at(entry + 4, 4);
    const std::size_t place = count > 4 ? at(entry + 8, 4) : entry + 8;
    EXPECT_EQ(bytes_.at(place + count - 1), '\0');
    return bytes_.substr(place, count - 1);
  }
  std::uint32_t whole(std::size_t entry) const {
    EXPECT_EQ(at(entry + 2, 2), 3U);
    EXPECT_EQ(at(entry + 4, 4), 1U);
    return at(entry + 8, 2);
  }
  std::pair<std::uint32_t, std::uint32_t> ratio(std::size_t entry) const {
    EXPECT_EQ(at(entry + 2, 2), 5U);
    const std::size_t place = at(entry + 8, 4);
    return {at(place, 4), at(place + 4, 4)};
  }

 private:
  std::string bytes_;
};

CameraNotes notes() {
  CameraNotes notes;
  notes.make = "Pentacon";
  notes.model = "X";  // two bytes stand in the entry itself
  notes.time = "2026:07:14 09:12:00";
  notes.exposure_s = 1 / 60.0;
  notes.fnumber = 5.6;
  notes.focal_mm = 4.25;
  notes.iso = 400;
  notes.focal_35mm = 26;
  notes.width = 4032;
  notes.height = 3024;
  return notes;
}

TEST(ExifSegment, IsReadByTheLettersOfTheStandard) {
  const std::string segment = exifSegment(notes());
  ASSERT_EQ(segment.substr(0, 14), std::string("Exif\0\0II*\0\x08\0\0\0", 14));
  const Tiff tiff(segment);
  const std::map<int, std::size_t> first = tiff.directory(8);
  EXPECT_EQ(tiff.text(first.at(0x010F)), "Pentacon");
  EXPECT_EQ(tiff.text(first.at(0x0110)), "X");
  EXPECT_EQ(tiff.whole(first.at(0x0112)), 1U) << "upright";
  EXPECT_EQ(tiff.text(first.at(0x0132)), "2026:07:14 09:12:00");
  const std::map<int, std::size_t> of_camera = tiff.directory(tiff.at(first.at(0x8769) + 8, 4));
  using Ratio = std::pair<std::uint32_t, std::uint32_t>;
  EXPECT_EQ(tiff.ratio(of_camera.at(0x829A)), (Ratio{1, 60}));
  EXPECT_EQ(tiff.ratio(of_camera.at(0x829D)), (Ratio{56, 10}));
  EXPECT_EQ(tiff.whole(of_camera.at(0x8827)), 400U);
  EXPECT_EQ(tiff.text(of_camera.at(0x9003)), "2026:07:14 09:12:00");
  EXPECT_EQ(tiff.ratio(of_camera.at(0x920A)), (Ratio{43, 10})) << "4.25 mm to a tenth";
  EXPECT_EQ(tiff.whole(of_camera.at(0xA405)), 26U);
  EXPECT_EQ(tiff.whole(of_camera.at(0xA002)), 4032U);
  EXPECT_EQ(tiff.whole(of_camera.at(0xA003)), 3024U);
}

TEST(ExifSegment, FitsIntoOneSegmentOfAJpeg) {
  EXPECT_LT(exifSegment(notes()).size(), 65'533U);
}

}  // namespace
}  // namespace ostraka::virtualrig
