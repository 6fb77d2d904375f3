#include "virtualrig/exif.h"

#include <libexif/exif-data.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace ostraka::virtualrig {
namespace {

struct Free {
  void operator()(::ExifData* data) const { exif_data_unref(data); }
};

class Writer {
 public:
  Writer() : memory_(exif_mem_new_default()), data_(exif_data_new()) {
    exif_data_set_byte_order(data_.get(), EXIF_BYTE_ORDER_INTEL);
  }
  ~Writer() { exif_mem_unref(memory_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void text(ExifIfd ifd, ExifTag tag, const std::string& value) {
    ExifEntry* entry = add(ifd, tag, EXIF_FORMAT_ASCII, value.size() + 1, 1);
    std::memcpy(entry->data, value.c_str(), value.size() + 1);
  }
  void whole(ExifIfd ifd, ExifTag tag, int value) {
    exif_set_short(add(ifd, tag, EXIF_FORMAT_SHORT, 1, 2)->data, EXIF_BYTE_ORDER_INTEL,
                   static_cast<ExifShort>(value));
  }
  void ratio(ExifIfd ifd, ExifTag tag, unsigned numerator, unsigned denominator) {
    exif_set_rational(add(ifd, tag, EXIF_FORMAT_RATIONAL, 1, 8)->data, EXIF_BYTE_ORDER_INTEL,
                      {numerator, denominator});
  }
  std::string bytes() const {
    unsigned char* out = nullptr;
    unsigned size = 0;
    exif_data_save_data(data_.get(), &out, &size);
    std::string result(reinterpret_cast<const char*>(out), size);
    std::free(out);
    return result;
  }

 private:
  ExifEntry* add(ExifIfd ifd, ExifTag tag, ExifFormat format, std::size_t components,
                 std::size_t bytes_each) {
    ExifEntry* entry = exif_entry_new_mem(memory_);
    entry->tag = tag;
    entry->format = format;
    entry->components = components;
    entry->size = static_cast<unsigned>(components * bytes_each);
    entry->data = static_cast<unsigned char*>(exif_mem_alloc(memory_, entry->size));
    exif_content_add_entry(data_->ifd[ifd], entry);
    exif_entry_unref(entry);  // the content holds it
    return entry;
  }

  ExifMem* memory_;
  std::unique_ptr<::ExifData, Free> data_;
};

unsigned tenths(double value) {
  return static_cast<unsigned>(std::lround(value * 10));
}

}  // namespace

std::string exifSegment(const CameraNotes& d) {
  Writer out;
  out.text(EXIF_IFD_0, EXIF_TAG_MAKE, d.make);
  out.text(EXIF_IFD_0, EXIF_TAG_MODEL, d.model);
  out.whole(EXIF_IFD_0, EXIF_TAG_ORIENTATION, 1);
  out.text(EXIF_IFD_0, EXIF_TAG_DATE_TIME, d.time);
  const auto inverse = static_cast<unsigned>(std::lround(1 / d.exposure_s));
  out.ratio(EXIF_IFD_EXIF, EXIF_TAG_EXPOSURE_TIME, 1, std::max(1u, inverse));
  out.ratio(EXIF_IFD_EXIF, EXIF_TAG_FNUMBER, tenths(d.fnumber), 10);
  out.whole(EXIF_IFD_EXIF, EXIF_TAG_ISO_SPEED_RATINGS, d.iso);
  out.text(EXIF_IFD_EXIF, EXIF_TAG_DATE_TIME_ORIGINAL, d.time);
  out.ratio(EXIF_IFD_EXIF, EXIF_TAG_FOCAL_LENGTH, tenths(d.focal_mm), 10);
  out.whole(EXIF_IFD_EXIF, EXIF_TAG_FOCAL_LENGTH_IN_35MM_FILM, d.focal_35mm);
  out.whole(EXIF_IFD_EXIF, EXIF_TAG_PIXEL_X_DIMENSION, d.width);
  out.whole(EXIF_IFD_EXIF, EXIF_TAG_PIXEL_Y_DIMENSION, d.height);
  return out.bytes();
}

}  // namespace ostraka::virtualrig
