#include "texture/texture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/limits.h"
#include "base/message.h"
#include "batch/photograph.h"
#include "files/files.h"
#include "images/image_header.h"
#include "images/jpeg_image.h"
#include "images/png_image.h"
#include "model/model.h"
#include "model/preview.h"
#include "texture/relief.h"

namespace ostraka::texture {
namespace {

Error nothingShown() {
  return {ErrorCode::NotEnough, message("No photograph shows the sherd."), {}};
}

Eigen::AlignedBox3f boxOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

// Models of one batch lie where their sherds lay, those of others have other sizes. A GLB is
// simplified by 0.03 mm, which moves a corner by a few times as much; a model without a scale may
// be of any size.
bool areOfOneShape(const TriangleMesh& a, const TriangleMesh& b) {
  const Eigen::AlignedBox3f of_a = boxOf(a), of_b = boxOf(b);
  if (of_a.isEmpty() || of_b.isEmpty()) return false;
  const float most = 0.3f + 0.01f * of_a.diagonal().norm();
  return (of_a.min() - of_b.min()).cwiseAbs().maxCoeff() <= most &&
         (of_a.max() - of_b.max()).cwiseAbs().maxCoeff() <= most;
}

Result<cv::Mat> decoded(const std::string& file, const std::string& where) {
  const Result<images::ImageSize> size = images::imageSize(file, where);
  if (!size) return size.error();
  if (static_cast<std::uint64_t>(size->width) * static_cast<std::uint64_t>(size->height) >
      limits::kTexturePixels.most)
    return Error::unusable(message("The texture of this model has more than 67,108,864 pixels, so "
                                   "the model is used without "
                                   "it; export the model with a smaller one."),
                           where);
  return batch::decodePhotograph(file, where);
}

}  // namespace

Result<TexturedMesh> textured(const TriangleMesh& plain, const std::vector<View>& views,
                              const std::optional<Light>& light, int threads, Progress& progress,
                              const std::stop_token& stop) {
  TriangleMesh mesh = plain;
  if (mesh.normals.size() != mesh.vertices.size()) mesh.normals = model::vertexNormals(mesh);
  const double pixel_mm = finestPixel_mm(mesh, views);
  if (pixel_mm <= 0) return nothingShown();
  const std::vector<Chart> charts = chartsOf(mesh, pixel_mm);
  if (charts.empty()) return nothingShown();
  const Atlas atlas = packed(charts, pixel_mm);
  Result<Texture> texture = bake(mesh, charts, atlas, views, light, threads, progress, stop);
  if (!texture) return texture.error();
  if (texture->seen_share <= 0) return nothingShown();
  UnwrappedMesh unwrapped = texture::unwrapped(mesh, charts, atlas);
  return TexturedMesh{std::move(unwrapped.mesh), std::move(unwrapped.uv), std::move(*texture),
                      atlas.texel_mm};
}

Result<TexturedMesh> opened(const TexturedModel& model, const std::string& where) {
  Result<cv::Mat> picture = decoded(model.texture.jpeg, where);
  if (!picture) return picture.error();
  TexturedMesh opened{model.mesh, model.texture.uv, {}, 0};
  opened.texture.picture = *picture;
  opened.texture.seen = cv::Mat1b(picture->size(), 255);
  opened.texture.lit = model.extras.texture != "albedo";
  if (model.texture.seen_png.empty()) return opened;
  const Result<cv::Mat> seen = decoded(model.texture.seen_png, where);
  if (!seen) return seen.error();
  if (seen->size() == picture->size()) cv::extractChannel(*seen, opened.texture.seen, 0);
  return opened;
}

Result<std::optional<TexturedMesh>> openedGlb(std::string_view glb, const std::string& where) {
  using Textured = std::optional<TexturedMesh>;
  const Result<std::optional<TexturedModel>> read = parseTexturedGlb(glb, where);
  if (!read) return read.error();
  if (!*read) return Textured();
  Result<TexturedMesh> made = opened(**read, where);
  return made ? Result<Textured>(std::move(*made)) : made.error();
}

Result<std::optional<TexturedMesh>> openedBeside(std::filesystem::path model,
                                                 const TriangleMesh& shape) {
  Result<std::optional<TexturedMesh>> textured = openedBeside(model);
  if (textured && *textured && !areOfOneShape(shape, (*textured)->mesh))
    return Error::unusable(message("The GLB beside this model has another shape, so it is that of "
                                   "another sherd or of an earlier run; put its own beside it."),
                           model.string());
  return textured;
}

Result<std::optional<TexturedMesh>> openedBeside(std::filesystem::path model) {
  model.replace_extension(".glb");
  std::error_code code;
  if (!std::filesystem::is_regular_file(model, code)) return std::optional<TexturedMesh>();
  const Result<std::string> bytes = readFile(model);
  if (!bytes) return bytes.error();
  return openedGlb(*bytes, model.string());
}

cv::Vec3f levelAt(const cv::Mat3b& picture, const Eigen::Vector2f& place) {
  // Texel centres lie half a texel within the picture's edge.
  const float x = std::clamp(place.x() * static_cast<float>(picture.cols) - 0.5f, 0.f,
                             static_cast<float>(picture.cols - 1)),
              y = std::clamp(place.y() * static_cast<float>(picture.rows) - 0.5f, 0.f,
                             static_cast<float>(picture.rows - 1));
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, picture.cols - 1), y1 = std::min(y0 + 1, picture.rows - 1);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  return (1 - fy) * ((1 - fx) * cv::Vec3f(picture(y0, x0)) + fx * cv::Vec3f(picture(y0, x1))) +
         fy * ((1 - fx) * cv::Vec3f(picture(y1, x0)) + fx * cv::Vec3f(picture(y1, x1)));
}

Eigen::Vector3d colourAt(const TexturedMesh& model, const std::array<int, 3>& triangle,
                         const std::array<double, 3>& weights) {
  Eigen::Vector2f place = Eigen::Vector2f::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    place += static_cast<float>(weights[k]) * model.uv[static_cast<std::size_t>(triangle[k])];
  const cv::Vec3f bgr = levelAt(model.texture.picture, place);
  return {bgr[2], bgr[1], bgr[0]};
}

std::vector<Color> vertexColours(const TexturedMesh& model) {
  std::vector<Color> colours;
  colours.reserve(model.uv.size());
  for (const Eigen::Vector2f& place : model.uv) {
    const cv::Vec3f bgr = levelAt(model.texture.picture, place);
    colours.push_back({cv::saturate_cast<std::uint8_t>(bgr[2]),
                       cv::saturate_cast<std::uint8_t>(bgr[1]),
                       cv::saturate_cast<std::uint8_t>(bgr[0])});
  }
  return colours;
}

GlbTexture filesOf(const TexturedMesh& model) {
  GlbTexture files{model.uv, images::encodedJpeg(model.texture.picture),
                   images::encodedPng(model.texture.seen)};
  if (model.relief.empty()) return files;
  files.normals_png = images::encodedPng(model.relief);
  files.tangents = tangentsOf(model.mesh, model.uv);
  return files;
}

std::string nameOf(const Texture& texture) {
  return texture.lit ? "photo" : "albedo";
}

Result<std::string> formatGlb(const TexturedMesh& model, const GlbExtras& extras) {
  GlbExtras named = extras;
  named.texture = nameOf(model.texture);
  return ostraka::formatGlb(model.mesh, filesOf(model), named);
}

std::string previewOf(const TexturedMesh& model) {
  model::PreviewOptions options;
  options.color_at = [&](const std::array<int, 3>& triangle, const std::array<double, 3>& weights) {
    return colourAt(model, triangle, weights);
  };
  return images::encodedPng(model::renderPreview(model.mesh, options));
}

}  // namespace ostraka::texture
