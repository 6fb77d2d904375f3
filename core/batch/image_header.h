#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka::batch {

struct ImageSize {
  int width = 0, height = 0;  ///< pixels as stored; an EXIF orientation is not applied
  bool operator==(const ImageSize&) const = default;
};

/// Size of a JPEG, PNG or TIFF image from its bytes, without decoding, and whether the file goes on
/// to its own end: a JPEG without end marker, a PNG without IEND and a TIFF whose strips lie
/// outside of the file are cut off. Never reads outside of `bytes`. Errors: UnusableInput, one
/// sentence.
Result<ImageSize> imageSize(std::string_view bytes, const std::string& where);

/// The same for a file.
Result<ImageSize> readImageSize(const std::filesystem::path& file);

}  // namespace ostraka::batch
