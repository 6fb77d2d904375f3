#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

/// Sides photographed by a rig on which everything goes wrong now and then: cameras are pulled out,
/// silent, late, hand over old or cut-off files; the table's line loses, doubles, garbles and
/// delays replies, its controller restarts in mid-move. In simulated time.
namespace ostraka::capture::testing {

struct TortureOptions {
  std::string driver = "grbl";  ///< "grbl", "comxim1", "comxim2"
  int stops = 24;               ///< in all; sides of 8
  int cameras = 2;
  std::uint64_t seed = 1;
  double table_trouble = 0.01;   ///< of each reply, for each kind of trouble
  double camera_trouble = 0.02;  ///< of each exposure, for each kind of trouble
  std::filesystem::path folder;  ///< is emptied
};

struct TortureCount {
  int stops = 0, photographs = 0;
  int lost = 0, doubled = 0, misnamed = 0;  ///< photographs; must be 0
  int wrong_end = 0;                        ///< sides after which the table stood wrong; must be 0
  int given_up = 0;                         ///< sides that could not be finished; must be 0
  int refused = 0, troubles = 0, resumed = 0;
  double simulated_s = 0;
};
TortureCount torture(const TortureOptions& options);

}  // namespace ostraka::capture::testing
