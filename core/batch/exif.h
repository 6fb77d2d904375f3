#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ostraka::batch {

/// What a camera wrote about a photograph (CIPA DC-008, Exif 2.32); what it did not write is empty.
struct Exif {
  std::string make, model, serial, lens;  ///< serial: of the body
  std::optional<double> focal_length_mm, f_number, exposure_s;
  std::optional<int> focal_length_35mm;  ///< that sees as much on a picture 36 mm wide
  std::optional<int> iso;
  std::optional<bool> auto_white_balance;
  std::string taken;   ///< by the camera's clock, 2026-07-14T09:30:12.25
  std::string offset;  ///< of that clock from UTC: +04:00
  std::optional<int> orientation;

  /// As one JSON object under the standard's names: {"Make":"Canon","FocalLength":50.0}; "{}" when
  /// nothing is known.
  std::string json() const;
  /// Milliseconds since 1970, UTC; a clock without an offset is taken to show this computer's time.
  std::optional<std::int64_t> takenMs() const;
};

/// From the bytes of a JPEG, TIFF, HEIC or of a RAW built like TIFF; anything else, and what is
/// damaged, gives nothing. Of a JPEG the first 256 KiB are enough.
Exif exifIn(std::string_view bytes);
Exif readExif(const std::filesystem::path& file);

}  // namespace ostraka::batch
