#include "images/raw_image.h"

#include <libraw/libraw.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "base/limits.h"
#include "base/message.h"
#include "base/text.h"

namespace ostraka::images {
namespace {

Error damagedRaw(const std::string& where) {
  return Error::unusable(message("The RAW image is damaged, or its camera is not supported; copy "
                                 "it again, or export it as "
                                 "TIFF."),
                         where);
}

// A file whose values are not yet unpacked. The bytes must outlive it.
Result<std::unique_ptr<LibRaw>> openedRaw(std::string_view bytes, const std::string& where) {
  auto raw = std::make_unique<LibRaw>(LIBRAW_OPIONS_NO_MEMERR_CALLBACK |
                                      LIBRAW_OPIONS_NO_DATAERR_CALLBACK);
  libraw_output_params_t& how = *raw->output_params_ptr();
  how.user_flip = 0;
  how.use_camera_wb = 1;
  how.no_auto_bright = 1;
  how.output_bps = 8;
  how.output_color = 1;  // sRGB
  how.gamm[0] = 1 / 2.4;
  how.gamm[1] = 12.92;
  how.max_raw_memory_mb = 2048;
  // The first value that is missing ends unpacking: the others of a size that a small file states
  // would take seconds.
  raw->set_dataerror_handler(
      [](void* file, const char*, auto) { static_cast<LibRaw*>(file)->setCancelFlag(); },
      raw.get());
  if (raw->open_buffer(const_cast<char*>(bytes.data()), bytes.size()) != LIBRAW_SUCCESS)
    return damagedRaw(where);
  const libraw_image_sizes_t& sizes = raw->imgdata.sizes;
  if (const auto good = checkedSize(sizes.raw_width, sizes.raw_height, where); !good)
    return good.error();
  // Files may also state codes of no bits, of which none is ever missing.
  if (std::uint64_t{sizes.raw_width} * sizes.raw_height >
      limits::kRawPixelsPerByte.most * bytes.size())
    return cutOffImage(where);
  return raw;
}

Result<void> unpack(LibRaw& raw, const std::string& where) {
  const int status = raw.unpack();
  if (status == LIBRAW_IO_ERROR || raw.error_count() > 0) return cutOffImage(where);
  return status == LIBRAW_SUCCESS ? Result<void>() : Result<void>(damagedRaw(where));
}

// Whether the header states that the values end within the file. It gives the length of the first
// piece alone; that is all of them when it has each bit of values that are not compressed, or more
// than half of them otherwise.
bool statesThatItIsWhole(LibRaw& raw, std::size_t file_bytes) {
  const auto& values = raw.get_internal_data_pointer()->unpacker_data;
  const libraw_image_sizes_t& sizes = raw.imgdata.sizes;
  const std::uint64_t pixels = std::uint64_t{sizes.raw_width} * sizes.raw_height;
  const std::uint64_t bits = pixels * values.tiff_bps * std::max(values.tiff_samples, 1u);
  const std::uint64_t stated = std::uint64_t{values.data_size} * 8;
  if (bits == 0 || values.data_offset <= 0) return false;
  return (values.tiff_compress == 1 ? stated >= bits : 2 * stated > bits) &&
         static_cast<std::uint64_t>(values.data_offset) + values.data_size <= file_bytes;
}

}  // namespace

bool hasRawEnding(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 11> kEndings{
      ".dng", ".cr2", ".cr3", ".nef", ".nrw", ".arw", ".orf", ".rw2", ".raf", ".pef", ".srw"};
  return std::find(kEndings.begin(), kEndings.end(), lowerCase(file.extension().string())) !=
         kEndings.end();
}

Result<ImageSize> rawSize(std::string_view bytes, const std::string& where) {
  const auto raw = openedRaw(bytes, where);
  if (!raw) return raw.error();
  if (!statesThatItIsWhole(**raw, bytes.size()))
    if (const auto whole = unpack(**raw, where); !whole) return whole.error();
  if ((*raw)->adjust_sizes_info_only() != LIBRAW_SUCCESS) return damagedRaw(where);
  return checkedSize((*raw)->imgdata.sizes.iwidth, (*raw)->imgdata.sizes.iheight, where);
}

Result<cv::Mat> decodeRaw(std::string_view bytes, const std::string& where) {
  const auto raw = openedRaw(bytes, where);
  if (!raw) return raw.error();
  if (const auto whole = unpack(**raw, where); !whole) return whole.error();
  if ((*raw)->dcraw_process() != LIBRAW_SUCCESS) return damagedRaw(where);
  const std::unique_ptr<libraw_processed_image_t, decltype(&LibRaw::dcraw_clear_mem)> image(
      (*raw)->dcraw_make_mem_image(), &LibRaw::dcraw_clear_mem);
  if (!image || image->type != LIBRAW_IMAGE_BITMAP || image->bits != 8 ||
      (image->colors != 3 && image->colors != 1))
    return damagedRaw(where);
  const cv::Mat rgb(image->height, image->width, CV_8UC(image->colors), image->data);
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, image->colors == 3 ? cv::COLOR_RGB2BGR : cv::COLOR_GRAY2BGR);
  return bgr;
}

}  // namespace ostraka::images
