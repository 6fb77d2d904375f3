#include "batch/exif.h"

#include <libexif/exif-data.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/limits.h"
#include "base/text.h"
#include "files/open_folder.h"
#include "images/heif_image.h"

namespace ostraka::batch {
namespace {

constexpr std::size_t kHead_bytes = 256 * 1024;  // of a JPEG: Exif's segment is one of the first
constexpr std::size_t kLongest = 100;            // letters of a name

struct Free {
  void operator()(ExifData* data) const { exif_data_unref(data); }
};
using Data = std::unique_ptr<ExifData, Free>;

bool isTiff(std::string_view bytes) {
  return bytes.starts_with(std::string_view("II*\0", 4)) ||
         bytes.starts_with(std::string_view("MM\0*", 4));
}

Data parsed(std::string_view bytes) {
  Data data(exif_data_new());
  if (!data) return nullptr;
  // Nothing is to be added that the camera did not write.
  exif_data_unset_option(data.get(), EXIF_DATA_OPTION_FOLLOW_SPECIFICATION);
  const std::string tiff =
      isTiff(bytes) ? std::string("Exif\0\0", 6) + std::string(bytes) : std::string();
  const std::string_view all = tiff.empty() ? bytes : std::string_view(tiff);
  exif_data_load_data(data.get(), reinterpret_cast<const unsigned char*>(all.data()),
                      static_cast<unsigned>(all.size()));
  return data;
}

const ExifEntry* entryOf(const Data& data, ExifIfd ifd, ExifTag tag, ExifFormat format,
                         std::size_t bytes) {
  const ExifEntry* entry = exif_content_get_entry(data->ifd[ifd], tag);
  const bool good = entry != nullptr && entry->data != nullptr && entry->format == format &&
                    entry->size >= bytes && entry->components > 0;
  return good ? entry : nullptr;
}

// Printable ASCII, as the standard has it; cameras fill up with blanks and zeros.
std::string textOf(const Data& data, ExifIfd ifd, ExifTag tag) {
  const ExifEntry* entry = entryOf(data, ifd, tag, EXIF_FORMAT_ASCII, 1);
  std::string text;
  for (unsigned i = 0; entry && i < entry->size && entry->data[i] != 0 && text.size() < kLongest;
       ++i)
    text +=
        entry->data[i] >= 0x20 && entry->data[i] < 0x7f ? static_cast<char>(entry->data[i]) : '?';
  const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

std::optional<double> ratioOf(const Data& data, ExifTag tag) {
  const ExifEntry* entry = entryOf(data, EXIF_IFD_EXIF, tag, EXIF_FORMAT_RATIONAL, 8);
  if (!entry) return {};
  const ExifRational r = exif_get_rational(entry->data, exif_data_get_byte_order(data.get()));
  if (r.denominator == 0 || r.numerator == 0) return {};  // 0 stands for "unknown"
  return static_cast<double>(r.numerator) / r.denominator;
}

std::optional<int> shortOf(const Data& data, ExifIfd ifd, ExifTag tag) {
  const ExifEntry* entry = entryOf(data, ifd, tag, EXIF_FORMAT_SHORT, 2);
  if (!entry) return {};
  return exif_get_short(entry->data, exif_data_get_byte_order(data.get()));
}

// 2026:07:14 09:30:12 as 2026-07-14T09:30:12; anything else is nothing.
std::string timeOf(const std::string& exif, const std::string& part_of_second) {
  int y = 0, mo = 0, d = 0, h = 0, mi = 0, s = 0, read = 0;
  if (std::sscanf(exif.c_str(), "%4d:%2d:%2d %2d:%2d:%2d%n", &y, &mo, &d, &h, &mi, &s, &read) !=
          6 ||
      read != static_cast<int>(exif.size()) || y < 1970 || mo < 1 || mo > 12 || d < 1 || d > 31 ||
      h < 0 || h > 23 || mi < 0 || mi > 59 || s < 0 || s > 60)
    return {};
  const std::string text = formatted("%04d-%02d-%02dT%02d:%02d:%02d", y, mo, d, h, mi, s);
  const bool digits = part_of_second.size() <= 9 &&
                      part_of_second.find_first_not_of("0123456789") == std::string::npos;
  return text + (digits && !part_of_second.empty() ? "." + part_of_second : std::string());
}

// +04:00 in seconds.
std::optional<int> secondsOf(const std::string& offset) {
  char sign = 0;
  int h = 0, m = 0, read = 0;
  if (std::sscanf(offset.c_str(), "%c%2d:%2d%n", &sign, &h, &m, &read) != 3 ||
      read != static_cast<int>(offset.size()) || (sign != '+' && sign != '-') || h < 0 || h > 14 ||
      m < 0 || m > 59)
    return {};
  return (sign == '-' ? -1 : 1) * (h * 3600 + m * 60);
}

}  // namespace

std::string Exif::json() const {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  const auto put = [&all](const char* name, const auto& value) {
    if (value) all[name] = *value;
  };
  const auto putText = [&all](const char* name, const std::string& value) {
    if (!value.empty()) all[name] = value;
  };
  putText("Make", make);
  putText("Model", model);
  putText("BodySerialNumber", serial);
  putText("LensModel", lens);
  put("FocalLength", focal_length_mm);
  put("FocalLengthIn35mmFilm", focal_length_35mm);
  put("FNumber", f_number);
  put("ExposureTime", exposure_s);
  put("ISO", iso);
  if (auto_white_balance) all["WhiteBalance"] = *auto_white_balance ? "auto" : "manual";
  putText("DateTimeOriginal", taken.empty() ? taken : taken + offset);
  put("Orientation", orientation);
  return all.dump();
}

std::optional<std::int64_t> Exif::takenMs() const {
  std::tm parts{};
  int read = 0;
  if (std::sscanf(taken.c_str(), "%d-%d-%dT%d:%d:%d%n", &parts.tm_year, &parts.tm_mon,
                  &parts.tm_mday, &parts.tm_hour, &parts.tm_min, &parts.tm_sec, &read) != 6)
    return {};
  double part_s = 0;  // not by sscanf, which reads the point as the person's language writes it
  const char* rest = taken.c_str() + read;
  if (*rest == '.') std::from_chars(rest, taken.c_str() + taken.size(), part_s);
  parts.tm_year -= 1900;
  parts.tm_mon -= 1;
  parts.tm_isdst = -1;
  const std::optional<int> offset_s = secondsOf(offset);
  const std::time_t whole = offset_s ? ::timegm(&parts) - *offset_s : std::mktime(&parts);
  if (whole <= 0) return {};
  return static_cast<std::int64_t>(whole) * 1000 + std::llround(part_s * 1000);
}

Exif exifIn(std::string_view bytes) {
  if (images::isHeif(bytes)) {
    const std::string tiff = images::heifExif(bytes);
    return isTiff(tiff) ? exifIn(tiff) : Exif();
  }
  const bool jpeg = bytes.starts_with("\xff\xd8");
  if (!jpeg && !isTiff(bytes)) return {};
  const Data data = parsed(jpeg ? bytes.substr(0, kHead_bytes) : bytes);
  if (!data) return {};
  Exif exif;
  exif.make = textOf(data, EXIF_IFD_0, EXIF_TAG_MAKE);
  exif.model = textOf(data, EXIF_IFD_0, EXIF_TAG_MODEL);
  exif.serial = textOf(data, EXIF_IFD_EXIF, EXIF_TAG_BODY_SERIAL_NUMBER);
  exif.lens = textOf(data, EXIF_IFD_EXIF, EXIF_TAG_LENS_MODEL);
  exif.focal_length_mm = ratioOf(data, EXIF_TAG_FOCAL_LENGTH);
  exif.f_number = ratioOf(data, EXIF_TAG_FNUMBER);
  exif.exposure_s = ratioOf(data, EXIF_TAG_EXPOSURE_TIME);
  if (const auto mm = shortOf(data, EXIF_IFD_EXIF, EXIF_TAG_FOCAL_LENGTH_IN_35MM_FILM);
      mm && *mm > 0)
    exif.focal_length_35mm = mm;
  exif.iso = shortOf(data, EXIF_IFD_EXIF, EXIF_TAG_ISO_SPEED_RATINGS);
  if (const auto balance = shortOf(data, EXIF_IFD_EXIF, EXIF_TAG_WHITE_BALANCE))
    exif.auto_white_balance = *balance == 0;
  exif.taken = timeOf(textOf(data, EXIF_IFD_EXIF, EXIF_TAG_DATE_TIME_ORIGINAL),
                      textOf(data, EXIF_IFD_EXIF, EXIF_TAG_SUB_SEC_TIME_ORIGINAL));
  const std::string offset = textOf(data, EXIF_IFD_EXIF, EXIF_TAG_OFFSET_TIME_ORIGINAL);
  if (secondsOf(offset)) exif.offset = offset;
  exif.orientation = shortOf(data, EXIF_IFD_0, EXIF_TAG_ORIENTATION);
  return exif;
}

Exif readExif(const std::filesystem::path& file) {
  Result<OpenFile> in = OpenFile::open(file);
  if (!in || static_cast<std::uint64_t>(in->bytes()) > limits::kImageBytes.most) return {};
  std::string bytes(std::min(kHead_bytes, static_cast<std::size_t>(in->bytes())), '\0');
  if (!in->read(bytes)) return {};
  if (isTiff(bytes) || images::isHeif(bytes)) {  // the block may stand at its end
    const std::size_t head = bytes.size();
    bytes.resize(static_cast<std::size_t>(in->bytes()));
    if (!in->read(std::span(bytes).subspan(head))) bytes.resize(head);
  }
  return exifIn(bytes);
}

}  // namespace ostraka::batch
