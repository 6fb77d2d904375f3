#include "images/tiff_image.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "base/limits.h"
#include "images/image_header.h"

namespace ostraka::images {
namespace {

// A file in memory, as libtiff reads and writes it.
struct Memory {
  std::string_view from;      ///< what is read
  std::string* to = nullptr;  ///< what is written
  std::uint64_t place = 0;

  std::uint64_t size() const { return to ? to->size() : from.size(); }
  static Memory& of(thandle_t handle) { return *static_cast<Memory*>(handle); }
};

tmsize_t readFrom(thandle_t handle, void* to, tmsize_t count) {
  Memory& memory = Memory::of(handle);
  const std::string_view all = memory.to ? std::string_view(*memory.to) : memory.from;
  if (count < 0 || memory.place >= all.size()) return 0;
  const std::size_t taken = std::min<std::size_t>(count, all.size() - memory.place);
  std::memcpy(to, all.data() + memory.place, taken);
  memory.place += taken;
  return static_cast<tmsize_t>(taken);
}

tmsize_t writeTo(thandle_t handle, void* from, tmsize_t count) {
  Memory& memory = Memory::of(handle);
  if (!memory.to || count < 0) return 0;
  const std::size_t end = memory.place + static_cast<std::size_t>(count);
  try {
    if (memory.to->size() < end) memory.to->resize(end);
  } catch (const std::exception&) {
    return 0;
  }
  std::memcpy(memory.to->data() + memory.place, from, static_cast<std::size_t>(count));
  memory.place = end;
  return count;
}

toff_t seek(thandle_t handle, toff_t offset, int from) {
  Memory& memory = Memory::of(handle);
  memory.place = from == SEEK_SET   ? offset
                 : from == SEEK_CUR ? memory.place + offset
                                    : memory.size() + offset;
  return memory.place;
}

int closeNothing(thandle_t) {
  return 0;
}

// Uncompressed tiles of 8 bits are refused by libtiff 4.5 unless it has the file in memory itself.
int mapped(thandle_t handle, void** base, toff_t* size) {
  const Memory& memory = Memory::of(handle);
  if (memory.to) return 0;
  *base = const_cast<char*>(memory.from.data());
  *size = memory.from.size();
  return 1;
}

void unmapped(thandle_t, void*, toff_t) {}

toff_t sizeOf(thandle_t handle) {
  return Memory::of(handle).size();
}

int silent(TIFF*, void*, const char*, const char*, va_list) {
  return 1;
}

using Tiff = std::unique_ptr<TIFF, void (*)(TIFF*)>;

Tiff opened(Memory& memory, const char* mode) {
  const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                             TIFFOpenOptionsFree);
  if (!options) throw std::bad_alloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), silent, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), silent, nullptr);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(),
                                      static_cast<tmsize_t>(16 * limits::kImagePixels.most));
  return {TIFFClientOpenExt("", mode, &memory, readFrom, writeTo, seek, closeNothing, sizeOf,
                            mapped, unmapped, options.get()),
          TIFFClose};
}

template <typename T>
T field(TIFF* file, std::uint32_t tag, T otherwise) {
  T value{};
  return TIFFGetFieldDefaulted(file, tag, &value) == 1 ? value : otherwise;
}

// The values of a picture that is held as a matrix holds it, grey or RGB.
struct Stored {
  cv::Size size;
  int type = 0;
};

std::optional<Stored> storedAs(TIFF* file, cv::Size size) {
  const auto bits = field<std::uint16_t>(file, TIFFTAG_BITSPERSAMPLE, 1);
  const auto samples = field<std::uint16_t>(file, TIFFTAG_SAMPLESPERPIXEL, 1);
  const auto format = field<std::uint16_t>(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  const auto light = field<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_PALETTE);
  const auto planes = field<std::uint16_t>(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  const bool grey = light == PHOTOMETRIC_MINISBLACK && samples == 1;
  const bool colours =
      light == PHOTOMETRIC_RGB && samples >= 3 && samples <= 4 && planes == PLANARCONFIG_CONTIG;
  if (!grey && !colours) return std::nullopt;
  const bool real = format == SAMPLEFORMAT_IEEEFP;
  if (!real && format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_INT) return std::nullopt;
  const int depth = bits == 8 && !real    ? CV_8U
                    : bits == 16 && !real ? CV_16U
                    : bits == 32          ? (real ? CV_32F : CV_32S)
                                          : -1;
  if (depth < 0) return std::nullopt;
  return Stored{size, CV_MAKETYPE(depth, samples)};
}

// Strips are tiles as wide as the picture.
std::optional<cv::Mat> valuesOf(TIFF* file, const Stored& stored) {
  const bool tiled = TIFFIsTiled(file) != 0;
  const auto width = tiled ? field<std::uint32_t>(file, TIFFTAG_TILEWIDTH, 0)
                           : static_cast<std::uint32_t>(stored.size.width);
  const auto height =
      std::min(field<std::uint32_t>(file, tiled ? TIFFTAG_TILELENGTH : TIFFTAG_ROWSPERSTRIP, 0),
               tiled ? UINT32_MAX : static_cast<std::uint32_t>(stored.size.height));
  const tmsize_t bytes = tiled ? TIFFTileSize(file) : TIFFStripSize(file);
  const std::size_t pixel = CV_ELEM_SIZE(stored.type);
  if (width == 0 || height == 0 || bytes <= 0 ||
      static_cast<std::uint64_t>(bytes) / pixel / width < height)
    return std::nullopt;
  std::vector<unsigned char> piece(static_cast<std::size_t>(bytes));
  cv::Mat image(stored.size, stored.type);
  std::uint32_t index = 0;
  for (std::uint32_t top = 0; top < static_cast<std::uint32_t>(image.rows); top += height)
    for (std::uint32_t left = 0; left < static_cast<std::uint32_t>(image.cols); left += width) {
      const std::uint32_t rows = std::min(height, image.rows - top);
      const std::size_t row_bytes = std::min(width, image.cols - left) * pixel;
      const tmsize_t read = tiled ? TIFFReadEncodedTile(file, index, piece.data(), bytes)
                                  : TIFFReadEncodedStrip(file, index, piece.data(), bytes);
      if (read < static_cast<tmsize_t>(rows * width * pixel)) return std::nullopt;
      for (std::uint32_t y = 0; y < rows; ++y)
        std::memcpy(image.ptr(static_cast<int>(top + y), static_cast<int>(left)),
                    piece.data() + y * width * pixel, row_bytes);
      ++index;
    }
  if (image.channels() == 3) cv::cvtColor(image, image, cv::COLOR_RGB2BGR);
  if (image.channels() == 4) cv::cvtColor(image, image, cv::COLOR_RGBA2BGRA);
  return image;
}

// Whatever it is, as libtiff would show it.
std::optional<cv::Mat> shown(TIFF* file, cv::Size size, bool grey) {
  cv::Mat picture(size, CV_8UC4);
  TIFFSetField(file, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);  // rows stay as they are stored
  if (TIFFReadRGBAImageOriented(
          file, static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height),
          reinterpret_cast<std::uint32_t*>(picture.data), ORIENTATION_TOPLEFT, 1) != 1)
    return std::nullopt;
  cv::Mat wanted;
  cv::cvtColor(picture, wanted, grey ? cv::COLOR_RGBA2GRAY : cv::COLOR_RGBA2BGR);
  return wanted;
}

bool isGrey(TIFF* file) {
  const auto light = field<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_PALETTE);
  return light == PHOTOMETRIC_MINISBLACK || light == PHOTOMETRIC_MINISWHITE;
}

}  // namespace

Result<cv::Mat> decodeTiff(std::string_view bytes, Values values, const std::string& where) {
  Memory memory{bytes};
  const Tiff file = opened(memory, "r");
  if (!file) return undecodableImage(where);
  const Result<ImageSize> claimed =
      checkedSize(field<std::uint32_t>(file.get(), TIFFTAG_IMAGEWIDTH, 0),
                  field<std::uint32_t>(file.get(), TIFFTAG_IMAGELENGTH, 0), where);
  if (!claimed) return claimed.error();
  const cv::Size size(claimed->width, claimed->height);
  const auto stored =
      values == Values::AsStored ? storedAs(file.get(), size) : std::optional<Stored>();
  const bool grey = values == Values::Grey || (values == Values::AsStored && isGrey(file.get()));
  const std::optional<cv::Mat> image =
      stored ? valuesOf(file.get(), *stored) : shown(file.get(), size, grey);
  if (!image) return undecodableImage(where);
  return *image;
}

std::string encodedTiff(const cv::Mat& image, double dpi) {
  CV_Assert(image.type() == CV_8UC1 || image.type() == CV_8UC3);
  const bool colours = image.channels() == 3;
  std::string bytes;
  Memory memory{{}, &bytes};
  Tiff file = opened(memory, "w");
  if (!file) throw std::bad_alloc();  // nothing else can fail, here and below
  TIFFSetField(file.get(), TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.cols));
  TIFFSetField(file.get(), TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.rows));
  TIFFSetField(file.get(), TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(file.get(), TIFFTAG_SAMPLESPERPIXEL, image.channels());
  TIFFSetField(file.get(), TIFFTAG_PHOTOMETRIC, colours ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  TIFFSetField(file.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(file.get(), TIFFTAG_COMPRESSION, COMPRESSION_LZW);
  TIFFSetField(file.get(), TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
  TIFFSetField(file.get(), TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(file.get(), 0));
  TIFFSetField(file.get(), TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  TIFFSetField(file.get(), TIFFTAG_XRESOLUTION, dpi);
  TIFFSetField(file.get(), TIFFTAG_YRESOLUTION, dpi);
  cv::Mat rgb;
  if (colours)
    cv::cvtColor(image, rgb, cv::COLOR_BGR2RGB);
  else
    rgb = image;
  for (int y = 0; y < rgb.rows; ++y) {
    std::vector<uchar> row(rgb.ptr(y), rgb.ptr(y) + rgb.cols * rgb.elemSize());
    if (TIFFWriteScanline(file.get(), row.data(), static_cast<std::uint32_t>(y), 0) != 1)
      throw std::bad_alloc();
  }
  if (TIFFFlush(file.get()) != 1) throw std::bad_alloc();
  file.reset();
  return bytes;
}

}  // namespace ostraka::images
