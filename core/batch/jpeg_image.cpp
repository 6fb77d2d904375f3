#include "batch/jpeg_image.h"

#include <algorithm>
#include <csetjmp>
#include <new>
#include <opencv2/imgcodecs.hpp>

#include <jpeglib.h>  // after cstdio, which it leaves to its user

#include <jerror.h>

#include "base/message.h"
#include "batch/photograph.h"

namespace ostraka::batch {
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

}  // namespace

bool isJpeg(std::string_view bytes) {
  return bytes.starts_with("\xFF\xD8\xFF");
}

Result<cv::Mat> decodeJpeg(std::string_view bytes, const ImageSize& size, int channels,
                           const std::string& where) {
  constexpr int kInksOfPrinters = 4;
  JpegReader reader(bytes);
  if (!reader.readHeader() || reader.size() != size) return reader.failure(where);
  if (reader.components() == kInksOfPrinters)
    return decodedByOpenCv(bytes, channels == 1 ? cv::IMREAD_GRAYSCALE : cv::IMREAD_COLOR);
  cv::Mat image(size.height, size.width, CV_8UC(channels));
  if (!reader.readRows(channels == 1 ? JCS_GRAYSCALE : JCS_EXT_BGR, image.data, image.step))
    return reader.failure(where);
  if (reader.losesData()) return damagedJpeg(where);
  return image;
}

}  // namespace ostraka::batch
