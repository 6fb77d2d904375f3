#pragma once
#include <opencv2/core/mat.hpp>
#include <optional>
#include <stop_token>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/point_cloud.h"
#include "texture/atlas.h"
#include "texture/charts.h"
#include "texture/light.h"
#include "texture/view.h"

namespace ostraka::texture {

/// The page of an atlas as the photographs have it.
struct Texture {
  cv::Mat3b picture;      ///< BGR, sRGB; also filled where no chart lies
  cv::Mat1b seen;         ///< 255: from photographs; 0: filled in from what is around, or no chart
  double seen_share = 0;  ///< of the charts' texels
  bool lit = true;        ///< false: without the light that fell on the sherd
};

/// Photographs onto the charts in two frequency bands (Burt, Adelson, A multiresolution spline, ACM
/// TOG 1983): what is coarser than about 8 texels is a mean over all photographs that see the
/// place, without those that are much brighter or darker there than the others (highlights,
/// shadows); what is finer comes from the one or two that see it best (slant, distance, sharpness),
/// so that nothing is doubled where the poses are off by a pixel. Exposures are brought together
/// over both sides beforehand: one gain per photograph and channel by least squares over all places
/// that several photographs show. Where charts meet, both show the same. mesh: with normals. light:
/// divided out, so that the page shows what the surface is rather than how it was lit; without one
/// it is as photographed. The result does not depend on `threads`. Errors: Cancelled.
Result<Texture> bake(const TriangleMesh& mesh, const std::vector<Chart>& charts, const Atlas& atlas,
                     const std::vector<View>& views, const std::optional<Light>& light, int threads,
                     Progress& progress, const std::stop_token& stop);

}  // namespace ostraka::texture
