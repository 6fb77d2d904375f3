#include "batch/heif_image.h"

#include <libheif/heif.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "base/limits.h"
#include "base/message.h"

namespace ostraka::batch {
namespace {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* held) const {
    release(held);
  }
};
using Context = std::unique_ptr<heif_context, Release<heif_context_free>>;
using Handle = std::unique_ptr<heif_image_handle, Release<heif_image_handle_release>>;
using Image = std::unique_ptr<heif_image, Release<heif_image_release>>;
using Options = std::unique_ptr<heif_decoding_options, Release<heif_decoding_options_free>>;

std::uint64_t bigEndian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char c : bytes) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

// Bytes of the box at the front; 0 when it is none or goes on beyond the file.
std::uint64_t boxBytes(std::string_view bytes) {
  if (bytes.size() < 8) return 0;
  std::uint64_t size = bigEndian(bytes.substr(0, 4)), header = 8;
  if (size == 0) size = bytes.size();  // to the end of the file
  if (size == 1) {
    if (bytes.size() < 16) return 0;
    size = bigEndian(bytes.substr(8, 8));
    header = 16;
  }
  return size >= header && size <= bytes.size() ? size : 0;
}

bool reachesItsEnd(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::uint64_t box = boxBytes(bytes);
    if (box == 0) return false;
    bytes.remove_prefix(box);
  }
  return true;
}

// The main image; null where there is none. The bytes must outlive it.
struct Opened {
  Context context;
  Handle handle;
};

Opened opened(std::string_view bytes) {
  Opened file{Context(heif_context_alloc()), nullptr};
  heif_context_set_maximum_image_size_limit(file.context.get(), limits::kImageSide.most);
  heif_context_set_max_decoding_threads(file.context.get(), 0);
  if (heif_context_read_from_memory_without_copy(file.context.get(), bytes.data(), bytes.size(),
                                                 nullptr)
          .code != heif_error_Ok)
    return file;
  heif_image_handle* handle = nullptr;
  if (heif_context_get_primary_image_handle(file.context.get(), &handle).code == heif_error_Ok)
    file.handle.reset(handle);
  return file;
}

Error damagedHeif(const std::string& where) {
  return Error::unusable(message("The HEIC image is damaged; copy it again."), where);
}

}  // namespace

bool isHeif(std::string_view bytes) {
  constexpr std::array<std::string_view, 6> kBrands{"heic", "heix", "heim", "heis", "mif1", "msf1"};
  if (bytes.size() < 12 || bytes.substr(4, 4) != "ftyp") return false;
  return std::find(kBrands.begin(), kBrands.end(), bytes.substr(8, 4)) != kBrands.end();
}

Result<ImageSize> heifSize(std::string_view bytes, const std::string& where) {
  if (!reachesItsEnd(bytes)) return cutOffImage(where);
  const Opened file = opened(bytes);
  if (!file.handle) return damagedHeif(where);
  return checkedSize(heif_image_handle_get_ispe_width(file.handle.get()),
                     heif_image_handle_get_ispe_height(file.handle.get()), where);
}

Result<cv::Mat> decodeHeif(std::string_view bytes, const std::string& where) {
  const Opened file = opened(bytes);
  const Options options(heif_decoding_options_alloc());
  if (!file.handle || !options) return damagedHeif(where);
  options->ignore_transformations = 1;
  options->convert_hdr_to_8bit = 1;
  heif_image* decoded = nullptr;
  if (heif_decode_image(file.handle.get(), &decoded, heif_colorspace_RGB,
                        heif_chroma_interleaved_RGB, options.get())
          .code != heif_error_Ok)
    return damagedHeif(where);
  const Image image(decoded);
  int stride = 0;
  const std::uint8_t* pixels =
      heif_image_get_plane_readonly(image.get(), heif_channel_interleaved, &stride);
  const int width = heif_image_get_width(image.get(), heif_channel_interleaved);
  const int height = heif_image_get_height(image.get(), heif_channel_interleaved);
  if (pixels == nullptr || width < 1 || height < 1 || stride < 3 * width) return damagedHeif(where);
  const cv::Mat rgb(height, width, CV_8UC3, const_cast<std::uint8_t*>(pixels),
                    static_cast<std::size_t>(stride));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  return bgr;
}

std::string heifExif(std::string_view bytes) {
  const Opened file = opened(bytes);
  heif_item_id id = 0;
  if (!file.handle ||
      heif_image_handle_get_list_of_metadata_block_IDs(file.handle.get(), "Exif", &id, 1) != 1)
    return {};
  std::string block(heif_image_handle_get_metadata_size(file.handle.get(), id), '\0');
  if (block.size() < 4 ||
      heif_image_handle_get_metadata(file.handle.get(), id, block.data()).code != heif_error_Ok)
    return {};
  const std::uint64_t skipped = 4 + bigEndian(std::string_view(block).substr(0, 4));
  return skipped < block.size() ? block.substr(skipped) : std::string();
}

}  // namespace ostraka::batch
