#pragma once
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "cloud/point_cloud.h"
#include "texture/charts.h"

namespace ostraka::texture {

/// Where each chart lies on one page of texels. Texel centres have integer coordinates, y down.
struct Atlas {
  int width = 0, height = 0;
  double texel_mm =
      0;  ///< edge of a texel on the surface: as asked, or coarser where it is limited
  std::vector<Eigen::Vector2i> places;  ///< top left corner of each chart's own texels

  /// A corner of a chart, as it stands there in mm, on the page.
  Eigen::Vector2d onPage(const Chart& chart, std::size_t index,
                         const Eigen::Vector2f& corner) const;
};

/// Charts side by side in rows, the tallest first, with a margin so that smaller copies of the page
/// do not mix them. No edge is longer than `most_texels`: texels become coarser instead.
Atlas packed(const std::vector<Chart>& charts, double texel_mm, int most_texels = 8192);

/// What lies on each texel of a page: -1, or the face, and where on it.
struct Texels {
  cv::Mat1i face;
  cv::Mat_<cv::Vec2f> weights;  ///< barycentric, of the face's first and second corner
};
/// A texel whose centre lies up to 0.7 of a texel outside its face counts as the face's: what is
/// drawn between two texels takes from both.
Texels texelsOf(const std::vector<Chart>& charts, const Atlas& atlas);
/// The mesh with a place on the page for each vertex: vertices on the border of two charts are
/// there once for each.
struct UnwrappedMesh {
  TriangleMesh mesh;
  std::vector<Eigen::Vector2f> uv;  ///< per vertex, 0..1 of the page from its top left corner
};
UnwrappedMesh unwrapped(const TriangleMesh& mesh, const std::vector<Chart>& charts,
                        const Atlas& atlas);
/// The same of a mesh that is unwrapped, on a page of any size.
Texels texelsOf(const TriangleMesh& mesh, const std::vector<Eigen::Vector2f>& uv, cv::Size page);

}  // namespace ostraka::texture
