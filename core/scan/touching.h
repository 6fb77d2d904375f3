#pragma once
#include <Eigen/Core>
#include <vector>

#include "cloud/point_cloud.h"

namespace ostraka::scan {

struct TouchingOptions {
  double neck_share = 0.35;     ///< pieces touch where the outline narrows below this share of the
                                ///< smaller part's width; a sherd's own waist is wider,
  double seam_share = 0.75;     ///< or below this share, where the surface breaks off at the waist
  double min_extent_mm = 10.0;  ///< smaller parts are none
};

/// Where two touching sherds were told apart.
struct Neck {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< plate, mm
  double width_mm = 0;
};

struct TouchingParts {
  int count = 1;
  std::vector<int> part;  ///< per point, 0 .. count - 1
  std::vector<Neck> necks;
};

/// Sherds that touch show as one piece with a neck in its outline seen from above. The outline is
/// worn down step by step until it falls into parts. The piece is cut where the neck between them
/// is narrow, or, under a wider one, where the surface breaks off by a step, a kink or a groove
/// along four fifths of the line between the parts (only told from points with normals). Each
/// point goes to the part from which it is reached without crossing such breaks.
TouchingParts cutTouching(const PointCloud& piece, const TouchingOptions& options);

}  // namespace ostraka::scan
