#pragma once
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "cloud/point_cloud.h"
#include "texture/texture.h"

namespace ostraka::texture {

/// Per vertex the direction in which u rises on the surface: unit length, square to the normal.
/// Together with the normal n and the cross product n x t it is the frame of a normal map. mesh:
/// with normals; uv: per vertex, from the page's top left corner, not mirrored.
std::vector<Eigen::Vector3f> tangentsOf(const TriangleMesh& mesh,
                                        const std::vector<Eigen::Vector2f>& uv);

/// What a lighter mesh of a sherd has lost of its surface, as a normal map on the places of its
/// page (glTF 2.0: linear, green up; BGR here): each texel has the normal of `full` where the
/// lighter mesh's own normal meets it, in the frame of normal n, tangent t and n x t, as they are
/// interpolated to the texel, n and t of unit length. So a renderer that builds the same frame has
/// the normals of `full` up to the steps of 8 bits (0.3 degrees). Texels are as fine as half an
/// edge of `full`, or as the page's where those are larger. (128, 128, 255), which leaves the
/// lighter mesh's normal, is what is off the charts, what nobody saw (unseen vertices of `full`),
/// and what faces away. Empty where the normals of what was seen are apart by less than a degree
/// (RMS): that changes the brightness in light from 45 degrees by less than 2 %, which nobody sees.
/// model: with normals and texel_mm; full: mm, the same frame. The same for any number of threads.
/// About 5 s per million texels on one core; 16 bytes a texel.
cv::Mat3b reliefOf(const TexturedMesh& model, const TriangleMesh& full, int threads);

}  // namespace ostraka::texture
