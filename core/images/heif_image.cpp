#include "images/heif_image.h"

#include <libheif/heif.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "base/limits.h"
#include "base/message.h"

namespace ostraka::images {
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

Error damagedHeif(const std::string& where) {
  return Error::unusable(message("The HEIC image is damaged; copy it again."), where);
}

// Big-endian numbers one behind the other. One that is not there makes all of them bad.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}
  bool good() const { return good_; }
  std::string_view rest() const { return rest_; }
  std::string_view text(std::size_t bytes) {
    if (bytes > rest_.size()) {
      good_ = false;
      rest_ = {};
      return {};
    }
    const std::string_view found = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return found;
  }
  std::uint64_t number(std::size_t bytes) {
    std::uint64_t value = 0;
    for (const char c : text(bytes)) value = value << 8 | static_cast<unsigned char>(c);
    return value;
  }
  std::uint64_t version() { return number(4) >> 24; }  // flags behind it

 private:
  std::string_view rest_;
  bool good_ = true;
};

struct Box {
  std::string_view type, content;
};

// The boxes side by side; nothing when one goes on beyond `bytes` or there are too many. In a file
// the last one may leave its size open.
std::optional<std::vector<Box>> boxesIn(std::string_view bytes, bool in_file) {
  std::vector<Box> boxes;
  while (!bytes.empty()) {
    Fields head(bytes);
    std::uint64_t size = head.number(4);
    const std::string_view type = head.text(4);
    if (size == 1)
      size = head.number(8);
    else if (size == 0 && in_file)
      size = bytes.size();
    const std::size_t header = bytes.size() - head.rest().size();
    if (!head.good() || size < header || size > bytes.size() ||
        boxes.size() == limits::kHeifParts.most)
      return std::nullopt;
    boxes.push_back({type, bytes.substr(header, size - header)});
    bytes.remove_prefix(size);
  }
  return boxes;
}

// The content of the one box of a type, empty where there is none. Of several, readers disagree
// about which counts: nothing.
std::optional<std::string_view> onlyBox(const std::vector<Box>& boxes, std::string_view type) {
  std::string_view found;
  for (const Box& box : boxes) {
    if (box.type != type) continue;
    if (!found.empty() || box.content.empty()) return std::nullopt;
    found = box.content;
  }
  return found;
}

// What stands in the file under a number: an image, or a block such as EXIF.
struct Item {
  std::string_view type, data;
  std::vector<std::uint64_t> tiles;       // an image is derived from these, in their order
  std::vector<std::uint64_t> companions;  // decoded along with it: its transparency
  bool placed = false;
  std::uint64_t images = 1, counted = 1;  // that decoding it decodes, itself included
};
using Items = std::map<std::uint64_t, Item>;

bool readTypes(std::string_view iinf, Items& items) {
  Fields in(iinf);
  const std::uint64_t version = in.version(), count = in.number(version == 0 ? 2 : 4);
  const auto entries = boxesIn(in.rest(), false);
  if (!in.good() || version > 1 || !entries || entries->size() != count) return false;
  for (const Box& entry : *entries) {
    Fields fields(entry.content);
    const std::uint64_t kind = fields.version(), id = fields.number(kind == 2 ? 2 : 4);
    fields.number(2);  // protection
    Item item;
    item.type = fields.text(4);
    if (entry.type != "infe" || kind < 2 || kind > 3 || !fields.good() ||
        !items.emplace(id, item).second)
      return false;
  }
  return true;
}

// Of derivation and of images that stand for a channel; the others (thumbnails, EXIF) are not
// followed in decoding.
bool readReferences(std::string_view iref, Items& items) {
  if (iref.empty()) return true;
  Fields in(iref);
  const std::uint64_t version = in.version();
  const std::size_t each = version == 0 ? 2 : 4;
  const auto references = boxesIn(in.rest(), false);
  if (!in.good() || version > 1 || !references) return false;
  std::uint64_t all = 0;
  for (const Box& reference : *references) {
    Fields fields(reference.content);
    const std::uint64_t from = fields.number(each), count = fields.number(2);
    // Readers go by the count, whatever the size says.
    if (!fields.good() || fields.rest().size() != count * each) return false;
    if (reference.type != "dimg" && reference.type != "auxl") continue;
    all += count;
    const auto source = items.find(from);
    if (source == items.end() || all > limits::kHeifParts.most) return false;
    if (reference.type == "dimg" && !source->second.tiles.empty()) return false;
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint64_t to = fields.number(each);
      const auto target = items.find(to);
      if (target == items.end()) return false;
      if (reference.type == "dimg")
        source->second.tiles.push_back(to);
      else
        target->second.companions.push_back(from);
    }
  }
  return true;
}

// Where the descriptions of grids stand: in one piece, in the file or in the box idat.
bool readPlaces(std::string_view iloc, std::string_view file, std::string_view idat, Items& items) {
  Fields in(iloc);
  const std::uint64_t version = in.version(), sizes = in.number(2);
  const auto bytesOf = [&](int shift) { return static_cast<std::size_t>(sizes >> shift & 15); };
  const std::size_t offset_bytes = bytesOf(12), length_bytes = bytesOf(8), base_bytes = bytesOf(4);
  const std::size_t index_bytes = version == 0 ? 0 : bytesOf(0);
  for (const std::size_t bytes : {offset_bytes, length_bytes, base_bytes, index_bytes})
    if (bytes != 0 && bytes != 4 && bytes != 8) return false;
  if (version > 2 || length_bytes == 0) return false;
  const std::uint64_t count = in.number(version < 2 ? 2 : 4);
  for (std::uint64_t k = 0; k < count && in.good(); ++k) {
    const auto found = items.find(in.number(version < 2 ? 2 : 4));
    const std::uint64_t method = version == 0 ? 0 : in.number(2) & 15;
    in.number(2);  // another file
    const std::uint64_t base = in.number(base_bytes), extents = in.number(2);
    std::uint64_t start = 0, length = 0;
    for (std::uint64_t e = 0; e < extents && in.good(); ++e) {
      in.number(index_bytes);
      start = in.number(offset_bytes);
      length = in.number(length_bytes);
    }
    if (found == items.end()) continue;
    if (found->second.placed) return false;
    found->second.placed = true;
    const std::string_view source = method == 0 ? file : idat;
    if (method > 1 || extents != 1 || base > source.size() || start > source.size() - base ||
        length > source.size() - base - start)
      continue;  // not a description
    found->second.data = source.substr(base + start, length);
  }
  return in.good();
}

// Whether decoding any image ends, within the limits. After n rounds each number counts the images
// down to the n-th level below; images that contain themselves grow for ever.
bool areWithinLimits(Items& items) {
  for (std::uint64_t level = 0; level < limits::kHeifLevels.most; ++level) {
    bool grown = false;
    for (auto& [id, item] : items) {
      item.counted = 1;
      for (const std::uint64_t tile : item.tiles) item.counted += items.at(tile).images;
      for (const std::uint64_t image : item.companions) item.counted += items.at(image).images;
      if (item.counted > limits::kHeifParts.most) return false;
      grown |= item.counted != item.images;
    }
    if (!grown) return true;
    for (auto& [id, item] : items) item.images = item.counted;
  }
  return false;
}

Result<void> checkedGrid(const Item& item, const std::string& where) {
  Fields grid(item.data);
  const std::uint64_t version = grid.number(1);
  const std::size_t each = (grid.number(1) & 1) != 0 ? 4 : 2;
  const std::uint64_t rows = grid.number(1) + 1, columns = grid.number(1) + 1;
  const std::uint64_t width = grid.number(each), height = grid.number(each);
  if (!grid.good() || version != 0 || item.tiles.size() != rows * columns)
    return damagedHeif(where);
  const auto size =
      checkedSize(static_cast<std::int64_t>(width), static_cast<std::int64_t>(height), where);
  return size ? Result<void>() : Result<void>(size.error());
}

// libheif 1.15 follows references without end, and allocates what a description says. Overlays are
// no photographs.
Result<void> checkedItems(std::string_view bytes, const std::string& where) {
  const auto boxes = boxesIn(bytes, true);
  if (!boxes) return cutOffImage(where);
  const auto meta = onlyBox(*boxes, "meta");
  if (!meta || meta->size() < 4) return damagedHeif(where);
  const auto parts = boxesIn(meta->substr(4), false);
  if (!parts) return damagedHeif(where);
  const auto iinf = onlyBox(*parts, "iinf"), iref = onlyBox(*parts, "iref");
  const auto iloc = onlyBox(*parts, "iloc"), idat = onlyBox(*parts, "idat");
  Items items;
  if (!iinf || !iref || !iloc || !idat || !readTypes(*iinf, items) ||
      !readReferences(*iref, items) || !readPlaces(*iloc, bytes, *idat, items) ||
      !areWithinLimits(items))
    return damagedHeif(where);
  for (const auto& [id, item] : items) {
    if (item.type == "iovl") return damagedHeif(where);
    if (item.type != "grid") continue;
    if (const auto good = checkedGrid(item, where); !good) return good.error();
  }
  return {};
}

// The main image. The bytes must outlive it.
struct Opened {
  Context context;
  Handle handle;
};

Result<Opened> opened(std::string_view bytes, const std::string& where) {
  if (const auto good = checkedItems(bytes, where); !good) return good.error();
  Opened file{Context(heif_context_alloc()), nullptr};
  heif_context_set_maximum_image_size_limit(file.context.get(), limits::kImageSide.most);
  heif_context_set_max_decoding_threads(file.context.get(), 0);
  heif_image_handle* handle = nullptr;
  if (heif_context_read_from_memory_without_copy(file.context.get(), bytes.data(), bytes.size(),
                                                 nullptr)
              .code != heif_error_Ok ||
      heif_context_get_primary_image_handle(file.context.get(), &handle).code != heif_error_Ok)
    return damagedHeif(where);
  file.handle.reset(handle);
  return file;
}

}  // namespace

bool isHeif(std::string_view bytes) {
  constexpr std::array<std::string_view, 6> kBrands{"heic", "heix", "heim", "heis", "mif1", "msf1"};
  if (bytes.size() < 12 || bytes.substr(4, 4) != "ftyp") return false;
  return std::find(kBrands.begin(), kBrands.end(), bytes.substr(8, 4)) != kBrands.end();
}

Result<ImageSize> heifSize(std::string_view bytes, const std::string& where) {
  const Result<Opened> file = opened(bytes, where);
  if (!file) return file.error();
  return checkedSize(heif_image_handle_get_ispe_width(file->handle.get()),
                     heif_image_handle_get_ispe_height(file->handle.get()), where);
}

Result<cv::Mat> decodeHeif(std::string_view bytes, const std::string& where) {
  const Result<Opened> file = opened(bytes, where);
  if (!file) return file.error();
  const Options options(heif_decoding_options_alloc());
  if (!options) return damagedHeif(where);
  options->ignore_transformations = 1;
  options->convert_hdr_to_8bit = 1;
  heif_image* decoded = nullptr;
  if (heif_decode_image(file->handle.get(), &decoded, heif_colorspace_RGB,
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
  const Result<Opened> file = opened(bytes, {});
  heif_item_id id = 0;
  if (!file ||
      heif_image_handle_get_list_of_metadata_block_IDs(file->handle.get(), "Exif", &id, 1) != 1)
    return {};
  std::string block(heif_image_handle_get_metadata_size(file->handle.get(), id), '\0');
  if (block.size() < 4 ||
      heif_image_handle_get_metadata(file->handle.get(), id, block.data()).code != heif_error_Ok)
    return {};
  const std::uint64_t skipped = 4 + Fields(block).number(4);
  return skipped < block.size() ? block.substr(skipped) : std::string();
}

}  // namespace ostraka::images
