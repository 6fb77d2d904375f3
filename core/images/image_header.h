#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka::images {

struct ImageSize {
  int width = 0, height = 0;  ///< pixels as stored; an EXIF orientation is not applied
  bool operator==(const ImageSize&) const = default;
};

/// Size of a JPEG, PNG, TIFF, HEIC or RAW image from its bytes, without decoding, and whether the
/// file is complete: a JPEG without end marker, a PNG without IEND, a TIFF whose strips
/// and a HEIC whose boxes lie outside of the file, and a RAW whose values end early are cut off.
/// `where` is the file's name, whose ending says that it is RAW. Never reads outside of `bytes`.
/// Errors: UnusableInput, one sentence.
Result<ImageSize> imageSize(std::string_view bytes, const std::string& where);

/// The same for a file.
Result<ImageSize> readImageSize(const std::filesystem::path& file);

// What is wrong with a file, in one sentence.
Error cutOffImage(const std::string& where);
Error damagedJpeg(const std::string& where);
Error undecodableImage(const std::string& where);

/// A size as a file claims it, unless no image has it. Error: UnusableInput.
Result<ImageSize> checkedSize(std::int64_t width, std::int64_t height, const std::string& where);

}  // namespace ostraka::images
