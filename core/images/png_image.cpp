#include "images/png_image.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <new>
#include <opencv2/core.hpp>
#include <vector>

#include "images/image_header.h"

namespace ostraka::images {
namespace {

// libpng reports an error by a jump, so that whatever may jump has a method of its own without
// objects.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes)
      : left_(bytes),
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::failed,
                                    [](png_structp, png_const_charp) {})),
        info_(png_ ? png_create_info_struct(png_) : nullptr) {
    if (!info_) throw std::bad_alloc();
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  bool readHeader() {
    if (setjmp(failed_) != 0) return false;
    png_set_read_fn(png_, this, [](png_structp png, png_bytep to, std::size_t count) {
      std::string_view& left = static_cast<PngReader*>(png_get_io_ptr(png))->left_;
      if (count > left.size()) png_error(png, "the file ends early");
      std::memcpy(to, left.data(), count);
      left.remove_prefix(count);
    });
    png_read_info(png_, info_);
    return true;
  }

  // The type of the matrix that the rows are read into.
  int type(Values values) const {
    if (values == Values::Bgr) return CV_8UC3;
    if (values == Values::Grey) return CV_8UC1;
    const int kind = png_get_color_type(png_, info_);
    const bool coloured = (kind & PNG_COLOR_MASK_COLOR) != 0;
    const bool alpha = (kind & PNG_COLOR_MASK_ALPHA) != 0 ||
                       (coloured && png_get_valid(png_, info_, PNG_INFO_tRNS) != 0);
    const int channels = alpha ? 4 : coloured ? 3 : 1;
    return CV_MAKETYPE(png_get_bit_depth(png_, info_) == 16 ? CV_16U : CV_8U, channels);
  }

  bool readRows(int type, std::size_t bytes_of_a_row, png_bytepp rows) {
    if (setjmp(failed_) != 0) return false;
    const int kind = png_get_color_type(png_, info_);
    const bool coloured = (kind & PNG_COLOR_MASK_COLOR) != 0;
    const int channels = CV_MAT_CN(type);
    if (CV_MAT_DEPTH(type) == CV_16U)
      png_set_swap(png_);  // PNG's order of bytes is not this processor's
    else
      png_set_strip_16(png_);
    if (kind == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
    if (!coloured) png_set_expand_gray_1_2_4_to_8(png_);
    if (channels == 4)
      png_set_tRNS_to_alpha(png_);
    else
      png_set_strip_alpha(png_);
    if (coloured && channels > 1) png_set_bgr(png_);
    if (!coloured && channels > 1) png_set_gray_to_rgb(png_);
    if (coloured && channels == 1) png_set_rgb_to_gray(png_, PNG_ERROR_ACTION_NONE, 0.299, 0.587);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    if (png_get_rowbytes(png_, info_) != bytes_of_a_row) return false;
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  cv::Size size() const {
    return {static_cast<int>(png_get_image_width(png_, info_)),
            static_cast<int>(png_get_image_height(png_, info_))};
  }

 private:
  [[noreturn]] static void failed(png_structp png, png_const_charp) {
    std::longjmp(static_cast<PngReader*>(png_get_error_ptr(png))->failed_, 1);
  }

  std::string_view left_;
  std::jmp_buf failed_{};
  png_structp png_;
  png_infop info_;
};

class PngWriter {
 public:
  PngWriter()
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, &PngWriter::failed,
                                     [](png_structp, png_const_charp) {})),
        info_(png_ ? png_create_info_struct(png_) : nullptr) {
    if (!info_) throw std::bad_alloc();
  }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

  bool write(const cv::Mat& image, int effort, double dpi, png_bytepp rows) {
    if (setjmp(failed_) != 0) return false;
    png_set_write_fn(
        png_, this,
        [](png_structp png, png_bytep from, std::size_t count) {
          if (!static_cast<PngWriter*>(png_get_io_ptr(png))->append(from, count))
            png_error(png, "not enough memory");
        },
        nullptr);
    png_set_compression_mem_level(png_, 8);
    png_set_compression_level(png_, effort);
    png_set_compression_strategy(png_, Z_DEFAULT_STRATEGY);
    const int kind = image.channels() == 1   ? PNG_COLOR_TYPE_GRAY
                     : image.channels() == 3 ? PNG_COLOR_TYPE_RGB
                                             : PNG_COLOR_TYPE_RGBA;
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(image.cols),
                 static_cast<png_uint_32>(image.rows), 8, kind, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    const auto per_metre = static_cast<png_uint_32>(std::lround(dpi / 0.0254));
    if (dpi > 0) png_set_pHYs(png_, info_, per_metre, per_metre, PNG_RESOLUTION_METER);
    png_write_info(png_, info_);
    png_set_bgr(png_);
    png_write_image(png_, rows);
    png_write_end(png_, info_);
    return true;
  }
  std::string takeBytes() { return std::move(bytes_); }

 private:
  [[noreturn]] static void failed(png_structp png, png_const_charp) {
    std::longjmp(static_cast<PngWriter*>(png_get_error_ptr(png))->failed_, 1);
  }
  bool append(const unsigned char* from, std::size_t count) {
    try {
      bytes_.append(reinterpret_cast<const char*>(from), count);
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }

  std::string bytes_;
  std::jmp_buf failed_{};
  png_structp png_;
  png_infop info_;
};

std::vector<png_bytep> rowsOf(const cv::Mat& image) {
  std::vector<png_bytep> rows(static_cast<std::size_t>(image.rows));
  for (int y = 0; y < image.rows; ++y)
    rows[static_cast<std::size_t>(y)] = const_cast<png_bytep>(image.ptr(y));
  return rows;
}

}  // namespace

bool isPng(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1A\n");
}

Result<cv::Mat> decodePng(std::string_view bytes, Values values, const std::string& where) {
  PngReader reader(bytes);
  if (!reader.readHeader()) return undecodableImage(where);
  if (const auto size = checkedSize(reader.size().width, reader.size().height, where); !size)
    return size.error();
  cv::Mat image(reader.size(), reader.type(values));
  std::vector<png_bytep> rows = rowsOf(image);
  if (!reader.readRows(image.type(), image.cols * image.elemSize(), rows.data()))
    return undecodableImage(where);
  return image;
}

std::string encodedPng(const cv::Mat& image, int effort, double dpi) {
  CV_Assert(image.type() == CV_8UC1 || image.type() == CV_8UC3 || image.type() == CV_8UC4);
  std::vector<png_bytep> rows = rowsOf(image);
  PngWriter writer;
  if (!writer.write(image, effort, dpi, rows.data()))
    throw std::bad_alloc();  // nothing else can fail
  return writer.takeBytes();
}

}  // namespace ostraka::images
