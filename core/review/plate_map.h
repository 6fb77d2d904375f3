#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "review/live_pairs.h"
#include "review/review.h"

namespace ostraka::review {

/// One sherd in the photograph of one side; of a joined one each part that lies apart.
struct MapMark {
  int scan = 0;                                        ///< index of the side's scan
  Eigen::Vector2d place_mm = Eigen::Vector2d::Zero();  ///< the scan's, see ScanRef
  std::string number;                                  ///< of its sherd: "03"; empty: nobody's back
  /// A doubtful pair shows both numbers: the one that it would have with its rival. Else empty.
  std::string other_number;
  int part = 0;  ///< of a joined scan, 0: the largest
  CardState state = CardState::Sure;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< middle of the outline, pixels
  std::vector<Eigen::Vector2d> outline;          ///< closed, pixels
};

struct MapSide {
  std::filesystem::path photograph;
  int width = 0, height = 0;  ///< pixels
  std::vector<MapMark> marks;
};

/// Both photographs of a plate with the sherds' numbers, so that the pieces go into their bags.
struct PlateMap {
  MapSide front, back;
};

/// As things stand with these decisions. Errors: Missing without cameras, those of reviewOf.
Result<PlateMap> plateMap(const LivePairs& live, const decisions::Decisions& standing);

}  // namespace ostraka::review
