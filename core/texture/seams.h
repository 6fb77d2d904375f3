#pragma once
#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

#include "cloud/point_cloud.h"
#include "texture/atlas.h"
#include "texture/charts.h"

namespace ostraka::texture {

/// An edge of the mesh that lies on the page twice: between two charts, or where the fracture's way
/// around is cut.
struct Seam {
  using Line = std::array<Eigen::Vector2d, 2>;  ///< texels
  Line one, other;                              ///< the same ends of the edge in the same order
};

/// mesh: closed. In order of the edges' vertices.
std::vector<Seam> seamsOf(const TriangleMesh& mesh, const std::vector<Chart>& charts,
                          const Atlas& atlas);

/// The same points of the surface on either side, half a texel apart.
std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> placesAlong(const Seam& seam);

/// Lets both sides of each seam show the same, as they are read between four texels. Each gives way
/// by half, and what it gives way by fades within 16 texels, beyond which nothing changes; nor does
/// anything where one side was not seen, since what is filled in corrects nothing. A gain for each
/// chart would not do: photographs turn dark at a crease within a texel, and both sides have that
/// step at slightly different places (with gains on a grid of 16 texels a step of 5.2 CIE76 falls
/// to 4.1, with this one to 0.5). Linear least squares over the texels at the seams (Liu, Ferguson,
/// Jacobson, Gingold, Seamless, ACM TOG 36, 2017), by conjugate gradients in some 50 rounds; time
/// and memory go with the seams' length, not with the page. faces: of each texel, -1: no chart;
/// seen: 0: filled in. The result does not depend on `threads`.
void levelSeams(cv::Mat3f& page, const cv::Mat1i& faces, const cv::Mat1b& seen,
                const std::vector<Seam>& seams, int threads);

}  // namespace ostraka::texture
