#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <vector>

#include "decisions/candidate_table.h"

namespace ostraka::pipeline {

struct SyntheticOut {
  std::filesystem::path output;
  decisions::CandidateTable table;
  std::vector<Eigen::Isometry3d> front_from_back;  ///< the truth: front i belongs to back i
};

struct SyntheticOptions {
  int sherds = 4;
  /// The first two sherds have one outline and different breaks, and the program has their backs
  /// swapped, hardly sure of it.
  bool swapped_look_alikes = true;
  double noise_mm = 0.03;
};

/// A small OUT folder as processBatch leaves it, without computing one: round sherds of 20 to 30 mm
/// in rows on the plate, seen by one camera from above on each side, with what the pairs stage says
/// about them made up: all are sure but the near-duplicates. In well under a second.
SyntheticOut writeSyntheticOut(const std::filesystem::path& output,
                               const SyntheticOptions& options);

}  // namespace ostraka::pipeline
