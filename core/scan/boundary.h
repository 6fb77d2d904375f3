#pragma once
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "cloud/point_cloud.h"
#include "rig/camera.h"

namespace ostraka::scan {

/// A photograph with its mask, of the camera's size: coverage 0..255 of one sherd, or of all sherds
/// of that side.
struct SilhouetteView {
  rig::PosedImage camera;
  cv::Mat1b mask;
};

struct BoundaryOptions {
  double border_px = 6;  ///< from the mask's border; the authors name it for coarse reconstructions
  double hidden_mm = 1.5;   ///< a point so far behind another is hidden by it
  int neighbours = 30;      ///< within 1.2 mm at a spacing of 0.4 mm: less than a third of a wall
  double gap_rad = 1.5708;  ///< between the directions to the neighbours: 90 degrees, as in PCL
};

/// Per point 1 on the boundary of the scanned surface, else 0, as Wang et al., ICCV 2023, have it:
/// not farther from the mask's border than border_px in any photograph that sees it, and with
/// neighbours that leave a gap once they are projected onto their plane (Linsen, Prautzsch: Local
/// versus global triangulations, Eurographics 2001). Without views, or where their masks leave
/// nothing, the gap alone tells it. views: in the frame of the cloud, which needs normals.
/// O(n log n) and O(n) for each view.
std::vector<std::uint8_t> findBoundary(const PointCloud& cloud,
                                       std::span<const SilhouetteView> views,
                                       const BoundaryOptions& options);

}  // namespace ostraka::scan
