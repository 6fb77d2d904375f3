#include "texture/texture.h"

#include <opencv2/imgcodecs.hpp>

#include "model/model.h"

namespace ostraka::texture {
namespace {

Error nothingShown() {
  return {ErrorCode::NotEnough, "No photograph shows the sherd.", {}};
}

}  // namespace

Result<TexturedMesh> textured(const TriangleMesh& plain, const std::vector<View>& views,
                              int threads, Progress& progress, const std::stop_token& stop) {
  TriangleMesh mesh = plain;
  if (mesh.normals.size() != mesh.vertices.size()) mesh.normals = model::vertexNormals(mesh);
  const double pixel_mm = finestPixel_mm(mesh, views);
  if (pixel_mm <= 0) return nothingShown();
  const std::vector<Chart> charts = chartsOf(mesh, pixel_mm);
  if (charts.empty()) return nothingShown();
  const Atlas atlas = packed(charts, pixel_mm);
  Result<Texture> texture = bake(mesh, charts, atlas, views, threads, progress, stop);
  if (!texture) return texture.error();
  if (texture->seen_share <= 0) return nothingShown();
  UnwrappedMesh unwrapped = texture::unwrapped(mesh, charts, atlas);
  return TexturedMesh{std::move(unwrapped.mesh), std::move(unwrapped.uv), std::move(*texture),
                      atlas.texel_mm};
}

std::string asJpeg(const cv::Mat3b& picture) {
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 95});
  return {bytes.begin(), bytes.end()};
}

std::string asPng(const cv::Mat1b& mask) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", mask, bytes);
  return {bytes.begin(), bytes.end()};
}

}  // namespace ostraka::texture
