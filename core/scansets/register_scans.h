#pragma once
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pairing/candidates.h"
#include "registration/register_sides.h"

namespace ostraka::scansets {

struct RegisterOptions {
  std::filesystem::path front, back;  ///< folders of *.ply, one scan each; opened for reading only
  std::filesystem::path output;       ///< OUT; created, or continued when of the same scans
  pairing::Scale scale = pairing::Scale::Fixed;
  pairing::Method pairing = pairing::Method::Default;
  registration::Method registration = registration::Method::Default;
  registration::Boundary boundary = registration::Boundary::Strip;
  int threads = 0;  ///< 0: all that this process may use; the result does not depend on it
  Result<void> check() const;
};

struct RegisterSummary {
  struct Pair {
    std::string number;  ///< "01": folder under OUT/sherds
    std::string front, back;
    std::optional<double> score, margin;  ///< none where the pairing states none
    double fracture_rms_mm = 0, fracture_overlap = 0, uncertainty_mm = 0;
    bool ambiguous = false;
    std::string reason;  ///< why a person must look; empty otherwise
    /// False: no fractures to compare, and the figures above but the uncertainty say nothing.
    bool fracturesCompared() const { return fracture_rms_mm > 0; }
  };
  std::vector<Pair> pairs;  ///< by front
  std::vector<std::string> unpaired_front, unpaired_back;
  std::vector<Message> warnings;  ///< whole sentences
  int unusable = 0;               ///< files that could not be read: the result is not whole
  double seconds = 0;
  std::filesystem::path pairs_file;
  /// A millimetre in the fronts' unit, by the usual size of sherds; 1 where they may well be in mm.
  double mm = 1;
  int ambiguous() const;
  bool whole() const;  ///< every scan is in a pair, and every file could be read
};

/// Scans split already (one PLY per sherd and side, oriented points, mm) to registered pairs:
/// writes OUT/pairs.json (metrics.md), OUT/sherds/<nn>/merged.ply in the front scan's frame,
/// OUT/report.json and OUT/report.html. A file that cannot be used costs that scan, with a warning.
/// With Scale::Free all lengths and poses are in the fronts' own unit, whatever it is. Errors:
/// UnusableInput (no usable scan on a side, scans of Scale::Fixed that are not in mm, OUT of other
/// scans), CannotWrite, Cancelled.
Result<RegisterSummary> registerScans(const RegisterOptions& options, Progress& progress,
                                      std::stop_token stop);

}  // namespace ostraka::scansets
