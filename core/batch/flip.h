#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace ostraka::batch {

/// One series of photographs of both sides, in the order in which they were taken, and where the
/// sherds were turned over in it.
struct Series {
  std::vector<std::filesystem::path> files;
  std::size_t first_back = 0;  ///< index of the first photograph of the back; a proposal
  bool flip_found = false;     ///< a pause of the camera stands out there; else a person must look
};

/// The index behind the longest pause, when it stands out: with `least_side` photographs at least
/// on either side of it, and longer than `pauses` times the usual (median) and twice the next
/// longest pause that could be meant. ms: in ascending order.
std::optional<std::size_t> flipIn(const std::vector<std::int64_t>& taken_ms,
                                  std::size_t least_side = 3, double pauses = 3);

/// Puts the files in order of the cameras' clocks, where each file says its time, else in natural
/// order of the names; finds the flip. Where no pause stands out, `first_back` is the largest jump
/// of the numbers in the names, or else the middle. Reads at most 256 KiB of a JPEG.
Series seriesOf(std::vector<std::filesystem::path> files);

}  // namespace ostraka::batch
