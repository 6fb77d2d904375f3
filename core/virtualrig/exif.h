#pragma once
#include <string>

namespace ostraka::virtualrig {

/// What a camera writes beside its picture.
struct CameraNotes {
  std::string make, model;
  std::string time;  ///< "2026:07:14 09:12:00"
  double exposure_s = 0, fnumber = 0, focal_mm = 0;
  int iso = 100, focal_35mm = 0;
  int width = 0, height = 0;
};
/// The APP1 segment's content: "Exif", two zeros, TIFF.
std::string exifSegment(const CameraNotes& notes);

}  // namespace ostraka::virtualrig
