#include "images/jpeg_image.h"

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <new>
#include <opencv2/imgproc.hpp>

#include <jpeglib.h>  // after cstdio, which it leaves to its user

#include <jerror.h>

#include "images/image_header.h"

namespace ostraka::images {
namespace {

// libjpeg in memory. It reports an error by a jump, so that whatever may jump has a method of its
// own without objects.
class JpegReader {
 public:
  explicit JpegReader(std::string_view bytes) : bytes_(bytes) {
    job_.err = jpeg_std_error(&errors_);
    job_.client_data = this;
    errors_.error_exit = [](j_common_ptr job) { std::longjmp(of(job).failed_, 1); };
    errors_.emit_message = [](j_common_ptr job, int level) {
      if (level < 0) of(job).warned();
    };
  }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
  ~JpegReader() { jpeg_destroy_decompress(&job_); }

  bool readHeader() {
    if (setjmp(failed_) != 0) return false;
    jpeg_create_decompress(&job_);
    jpeg_mem_src(&job_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
    return jpeg_read_header(&job_, TRUE) == JPEG_HEADER_OK;
  }

  bool readRows(J_COLOR_SPACE colors, unsigned char* rows, std::size_t bytes_of_a_row) {
    if (setjmp(failed_) != 0) return false;
    job_.out_color_space = colors;
    jpeg_start_decompress(&job_);
    while (job_.output_scanline < job_.output_height) {
      JSAMPROW row = rows + job_.output_scanline * bytes_of_a_row;
      jpeg_read_scanlines(&job_, &row, 1);
    }
    jpeg_finish_decompress(&job_);
    return true;
  }

  ImageSize size() const {
    return {static_cast<int>(job_.image_width), static_cast<int>(job_.image_height)};
  }
  int components() const { return job_.num_components; }
  bool losesData() const { return loses_data_; }
  Error failure(const std::string& where) const {
    if (errors_.msg_code == JERR_OUT_OF_MEMORY) throw std::bad_alloc();
    return undecodableImage(where);
  }

 private:
  static JpegReader& of(j_common_ptr job) { return *static_cast<JpegReader*>(job->client_data); }

  // Only what means that picture data is lost: cameras write files that libjpeg wonders at, too.
  void warned() {
    ++errors_.num_warnings;
    switch (errors_.msg_code) {
      case JWRN_HIT_MARKER:
      case JWRN_HUFF_BAD_CODE:
      case JWRN_ARITH_BAD_CODE:
      case JWRN_JPEG_EOF:
      case JWRN_MUST_RESYNC:
        loses_data_ = true;
        break;
      case JWRN_EXTRANEOUS_DATA:
        loses_data_ |= leavesPictureData();
        break;
      default:
        break;
    }
  }

  // Bytes are left behind a scan: a camera's filling, or what no longer fits behind a hole.
  bool leavesPictureData() const {
    constexpr std::ptrdiff_t kMostByCameras = 64;
    const unsigned char* end = job_.src->next_input_byte;
    const std::ptrdiff_t before = end - reinterpret_cast<const unsigned char*>(bytes_.data());
    const std::ptrdiff_t left = std::clamp<std::ptrdiff_t>(errors_.msg_parm.i[0], 0, before);
    return left - std::count(end - left, end, 0) > kMostByCameras;
  }

  std::string_view bytes_;
  jpeg_decompress_struct job_{};
  jpeg_error_mgr errors_{};
  std::jmp_buf failed_{};
  bool loses_data_ = false;
};

class JpegWriter {
 public:
  JpegWriter() {
    job_.err = jpeg_std_error(&errors_);
    job_.client_data = this;
    errors_.error_exit = [](j_common_ptr job) {
      std::longjmp(static_cast<JpegWriter*>(job->client_data)->failed_, 1);
    };
  }
  JpegWriter(const JpegWriter&) = delete;
  JpegWriter& operator=(const JpegWriter&) = delete;
  ~JpegWriter() {
    jpeg_destroy_compress(&job_);
    std::free(bytes_);
  }

  bool write(const cv::Mat& image, const JpegOptions& options) {
    if (setjmp(failed_) != 0) return false;
    jpeg_create_compress(&job_);
    jpeg_mem_dest(&job_, &bytes_, &size_);
    job_.image_width = static_cast<JDIMENSION>(image.cols);
    job_.image_height = static_cast<JDIMENSION>(image.rows);
    job_.input_components = image.channels();
    job_.in_color_space = image.channels() == 1 ? JCS_GRAYSCALE : JCS_EXT_BGR;
    jpeg_set_defaults(&job_);
    jpeg_set_quality(&job_, options.quality, TRUE);
    for (int c = 0; c < job_.num_components; ++c)
      job_.comp_info[c].h_samp_factor = job_.comp_info[c].v_samp_factor =
          c == 0 && options.halved_colors && image.channels() == 3 ? 2 : 1;
    job_.dct_method = JDCT_ISLOW;  // the exact one
    job_.write_JFIF_header = options.exif.empty() ? TRUE : FALSE;
    jpeg_start_compress(&job_, TRUE);
    if (!options.exif.empty())
      jpeg_write_marker(&job_, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(options.exif.data()),
                        static_cast<unsigned>(options.exif.size()));
    while (job_.next_scanline < job_.image_height) {
      JSAMPROW row = const_cast<JSAMPROW>(image.ptr(static_cast<int>(job_.next_scanline)));
      jpeg_write_scanlines(&job_, &row, 1);
    }
    jpeg_finish_compress(&job_);
    return true;
  }
  std::string bytes() const { return {reinterpret_cast<const char*>(bytes_), size_}; }

 private:
  jpeg_compress_struct job_{};
  jpeg_error_mgr errors_{};
  std::jmp_buf failed_{};
  unsigned char* bytes_ = nullptr;
  unsigned long size_ = 0;
};

// Colours from a printer's inks, which such files hold inverted.
cv::Mat withoutInks(const cv::Mat& inks, bool grey) {
  cv::Mat3b colours(inks.size());
  std::transform(inks.begin<cv::Vec4b>(), inks.end<cv::Vec4b>(), colours.begin(),
                 [](const cv::Vec4b& cmyk) {
                   const auto light = [&](int ink) {
                     return static_cast<uchar>(cmyk[3] - ((255 - cmyk[ink]) * cmyk[3] >> 8));
                   };
                   return cv::Vec3b(light(2), light(1), light(0));
                 });
  if (!grey) return colours;
  cv::Mat light;
  cv::cvtColor(colours, light, cv::COLOR_BGR2GRAY);
  return light;
}

}  // namespace

bool isJpeg(std::string_view bytes) {
  return bytes.starts_with("\xFF\xD8\xFF");
}

Result<cv::Mat> decodeJpeg(std::string_view bytes, const ImageSize& size, Values values,
                           const std::string& where) {
  JpegReader reader(bytes);
  if (!reader.readHeader() || reader.size() != size) return reader.failure(where);
  const bool grey =
      values == Values::Grey || (values == Values::AsStored && reader.components() == 1);
  const bool of_inks = reader.components() == 4;
  cv::Mat image(size.height, size.width, of_inks ? CV_8UC4 : grey ? CV_8UC1 : CV_8UC3);
  if (!reader.readRows(of_inks ? JCS_CMYK
                       : grey  ? JCS_GRAYSCALE
                               : JCS_EXT_BGR,
                       image.data, image.step))
    return reader.failure(where);
  if (reader.losesData()) return damagedJpeg(where);
  if (of_inks) image = withoutInks(image, grey);
  return image;
}

std::string encodedJpeg(const cv::Mat& image, const JpegOptions& options) {
  CV_Assert(image.type() == CV_8UC1 || image.type() == CV_8UC3);
  JpegWriter writer;
  if (!writer.write(image, options)) throw std::bad_alloc();  // nothing else can fail
  return writer.bytes();
}

}  // namespace ostraka::images
