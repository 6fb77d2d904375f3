#pragma once
#include <Eigen/Core>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/point_cloud.h"
#include "texture/bake.h"
#include "texture/view.h"

namespace ostraka::texture {

/// A mesh with its page of photographs.
struct TexturedMesh {
  TriangleMesh mesh;  ///< vertices on the borders of charts are there once for each chart
  std::vector<Eigen::Vector2f> uv;  ///< per vertex, 0..1 from the page's top left corner
  Texture texture;
  double texel_mm = 0;
};

/// mesh: closed, outward, mm. A texel is as large as a pixel of the photograph that
/// was taken from nearest. Errors: Cancelled; NotEnough when no photograph shows the mesh.
Result<TexturedMesh> textured(const TriangleMesh& mesh, const std::vector<View>& views, int threads,
                              Progress& progress, const std::stop_token& stop);

/// The picture as a JPEG file, quality 95.
std::string asJpeg(const cv::Mat3b& picture);
/// The mask as a PNG file.
std::string asPng(const cv::Mat1b& mask);

}  // namespace ostraka::texture
