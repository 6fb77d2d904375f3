// What a camera wrote about its photograph, against bytes put together by hand after the standard.
#include "batch/exif.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>

#include "batch_folder.h"

namespace ostraka::batch {
namespace {

using testing::Optional;

enum Type { Ascii = 2, Short = 3, Long = 4, Rational = 5 };

// A TIFF structure of two directories; the second one is Exif's.
class Written {
 public:
  explicit Written(bool little) : little_(little) {}
  void text(int ifd, int tag, std::string value) {
    value += '\0';
    fields_[ifd].push_back({tag, Ascii, value.size(), value});
  }
  void number(int ifd, int tag, unsigned value) {
    fields_[ifd].push_back({tag, Short, 1, bytes(value, 2)});
  }
  void ratio(int ifd, int tag, unsigned over, unsigned under) {
    fields_[ifd].push_back({tag, Rational, 1, bytes(over, 4) + bytes(under, 4)});
  }
  std::string tiff() const {
    const std::size_t first = 8, exif = first + sizeOf(0, 1);
    std::string all = (little_ ? "II" : "MM") + bytes(42, 2) + bytes(first, 4);
    all += directory(0, first, exif) + directory(1, exif, 0);
    return all;
  }
  std::string jpeg() const {
    const std::string body = std::string("Exif\0\0", 6) + tiff();
    const std::size_t length = body.size() + 2;
    return std::string("\xFF\xD8\xFF\xE1") + static_cast<char>(length >> 8) +
           static_cast<char>(length & 0xFF) + body + "\xFF\xD9";
  }

 private:
  struct Field {
    int tag;
    Type type;
    std::size_t count;
    std::string value;
  };
  std::string bytes(std::size_t value, int count) const {
    std::string text;
    for (int i = 0; i < count; ++i)
      text += static_cast<char>(value >> 8 * (little_ ? i : count - 1 - i) & 0xFF);
    return text;
  }
  std::size_t sizeOf(int ifd, std::size_t more) const {
    std::size_t size = 2 + 12 * (fields_[ifd].size() + more) + 4;
    for (const Field& f : fields_[ifd]) size += f.value.size() > 4 ? f.value.size() : 0;
    return size;
  }
  std::string directory(int ifd, std::size_t at, std::size_t exif) const {
    const std::size_t count = fields_[ifd].size() + (exif > 0 ? 1 : 0);
    std::string head = bytes(count, 2), behind;
    for (const Field& f : fields_[ifd]) {
      head += bytes(static_cast<std::size_t>(f.tag), 2) + bytes(f.type, 2) + bytes(f.count, 4);
      if (f.value.size() > 4) {
        head += bytes(at + 2 + 12 * count + 4 + behind.size(), 4);
        behind += f.value;
      } else {
        head += f.value + std::string(4 - f.value.size(), '\0');
      }
    }
    if (exif > 0) head += bytes(0x8769, 2) + bytes(Long, 2) + bytes(1, 4) + bytes(exif, 4);
    return head + bytes(0, 4) + behind;
  }
  bool little_;
  std::vector<Field> fields_[2];
};

Written canon(bool little) {
  Written w(little);
  w.text(0, 0x010F, "Canon");
  w.text(0, 0x0110, "Canon EOS 250D   ");
  w.number(0, 0x0112, 6);
  w.ratio(1, 0x829A, 1, 60);
  w.ratio(1, 0x829D, 80, 10);
  w.number(1, 0x8827, 200);
  w.text(1, 0x9003, "2026:07:14 09:30:12");
  w.text(1, 0x9011, "+04:00");
  w.text(1, 0x9291, "25");
  w.ratio(1, 0x920A, 50, 1);
  w.number(1, 0xA403, 1);
  w.text(1, 0xA431, "063021004567");
  w.text(1, 0xA434, "EF-S60mm f/2.8 Macro USM");
  return w;
}

void isCanon(const Exif& exif) {
  EXPECT_EQ(exif.make, "Canon");
  EXPECT_EQ(exif.model, "Canon EOS 250D") << "blanks at the end";
  EXPECT_EQ(exif.serial, "063021004567");
  EXPECT_EQ(exif.lens, "EF-S60mm f/2.8 Macro USM");
  EXPECT_THAT(exif.exposure_s, Optional(1.0 / 60));
  EXPECT_THAT(exif.f_number, Optional(8.0));
  EXPECT_THAT(exif.iso, Optional(200));
  EXPECT_THAT(exif.focal_length_mm, Optional(50.0));
  EXPECT_THAT(exif.auto_white_balance, Optional(false));
  EXPECT_THAT(exif.orientation, Optional(6));
  EXPECT_EQ(exif.taken, "2026-07-14T09:30:12.25");
  EXPECT_EQ(exif.offset, "+04:00");
}

TEST(Exif, IsReadInBothByteOrdersFromJpegAndTiff) {
  for (const bool little : {false, true}) {
    isCanon(exifIn(canon(little).jpeg()));
    isCanon(exifIn(canon(little).tiff()));
  }
}

TEST(Exif, AFileIsReadLikeItsBytes) {
  const BatchFolder folder;
  folder.write("a.jpg", canon(true).jpeg() + std::string(300000, 'x'));
  isCanon(readExif(folder.path() / "a.jpg"));
  EXPECT_EQ(readExif(folder.path() / "none.jpg").json(), "{}");
}

// 09:30:12.25 at +04:00 is 05:30:12.25 in UTC: 20648 days and 19812.25 s after 1970.
TEST(Exif, TheClocksOffsetCounts) {
  Exif exif = exifIn(canon(true).jpeg());
  EXPECT_THAT(exif.takenMs(), Optional(20648LL * 86400000 + 19812250));
  exif.offset = "-00:30";
  EXPECT_THAT(exif.takenMs(), Optional(20648LL * 86400000 + 19812250 + 16200000));
}

TEST(Exif, AClockWithoutOffsetShowsTheTimeOfThisComputer) {
  ::setenv("TZ", "Asia/Yerevan", 1);  // +04:00
  ::tzset();
  Exif exif = exifIn(canon(true).jpeg());
  const auto with = exif.takenMs();
  exif.offset.clear();
  EXPECT_EQ(exif.takenMs(), with);
  ::unsetenv("TZ");
  ::tzset();
}

TEST(Exif, IsKeptUnderTheStandardsNames) {
  const nlohmann::json kept = nlohmann::json::parse(exifIn(canon(false).jpeg()).json());
  EXPECT_EQ(kept["Make"], "Canon");
  EXPECT_EQ(kept["BodySerialNumber"], "063021004567");
  EXPECT_EQ(kept["FNumber"], 8.0);
  EXPECT_EQ(kept["WhiteBalance"], "manual");
  EXPECT_EQ(kept["DateTimeOriginal"], "2026-07-14T09:30:12.25+04:00");
  EXPECT_EQ(kept.size(), 11u);
}

TEST(Exif, TheEquivalentFocalLengthIsRead) {
  Written telephone(true);
  telephone.number(1, 0xA405, 26);
  EXPECT_THAT(exifIn(telephone.jpeg()).focal_length_35mm, Optional(26));
  Written unknown(true);
  unknown.number(1, 0xA405, 0);
  EXPECT_EQ(exifIn(unknown.jpeg()).json(), "{}") << "0 stands for unknown";
}

TEST(Exif, WhatIsNotThereIsEmpty) {
  Written w(true);
  w.text(1, 0x9003, "0000:00:00 00:00:00");  // a camera whose clock was never set
  w.ratio(1, 0x920A, 0, 0);
  w.text(0, 0x010F, "\xC3\xA9t\n");
  const Exif exif = exifIn(w.jpeg());
  EXPECT_EQ(exif.taken, "");
  EXPECT_FALSE(exif.takenMs());
  EXPECT_FALSE(exif.focal_length_mm);
  EXPECT_FALSE(exif.iso);
  EXPECT_EQ(exif.make, "??t?");
  EXPECT_EQ(exifIn(std::string_view("\x89PNG\r\n")).json(), "{}");
  EXPECT_EQ(exifIn({}).json(), "{}");
}

// Cut off anywhere, or with any byte turned round, it is read without harm.
TEST(Exif, DamageGivesLessAndNoCrash) {
  const std::string whole = canon(true).jpeg();
  for (std::size_t n = 0; n < whole.size(); ++n) {
    (void)exifIn(whole.substr(0, n)).json();
    std::string turned = whole;
    turned[n] = static_cast<char>(~turned[n]);
    const Exif exif = exifIn(turned);
    EXPECT_LE(exif.model.size(), 100u);
    EXPECT_TRUE(nlohmann::json::accept(exif.json())) << n;
    (void)exif.takenMs();
  }
}

}  // namespace
}  // namespace ostraka::batch
