#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "scan/scan.h"

namespace ostraka::decisions {

/// Scans that were split already: one PLY per sherd, oriented points, mm. Points that are no
/// measurement (far outside of all others, or several at 0, 0, 0) and those whose normal has no
/// direction are left out with a warning, and files whose names begin with a dot are not looked at.
struct ScanFolder {
  std::vector<scan::Scan> scans;  ///< in the order of their files' names, which they bear
  std::vector<std::filesystem::path> files;  ///< of the scans
  std::vector<Message> warnings;             ///< a file that cannot be used costs that scan
  std::string hash;                          ///< names and contents of all files
  int unusable = 0;
};

/// Files are opened for reading only. Errors: UnusableInput, no PLY file or none that can be used.
Result<ScanFolder> readScanFolder(const std::filesystem::path& folder, int threads);

/// The longest edge of the middle scan's box, in the scans' unit; at least one scan.
double medianLength(std::span<const scan::Scan> scans);
/// 8 to 400: what is shorter or longer is not in mm.
bool isSherdLength(double mm);
/// Whether both sides can be in mm. what_to_do: how the sentence ends. Errors: UnusableInput, with
/// the unit that they look like; also when one side is more than 3 times as long as the other.
Result<void> checkUnit(const ScanFolder& fronts, const ScanFolder& backs,
                       const Message& what_to_do);

/// Whether a batch folder holds split scans (PLY files in front/) instead of photographs.
bool holdsScans(const std::filesystem::path& batch);

/// Whether the scans' frame is a plate's: all stand on z = 0 with their faces up. Scans stop up to
/// 0.6 mm above the plate, and up to 4 mm where the lowest strip is hidden.
bool standOnPlate(std::span<const scan::Scan> scans);

}  // namespace ostraka::decisions
