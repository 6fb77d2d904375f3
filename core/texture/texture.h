#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "cloud/glb.h"
#include "cloud/point_cloud.h"
#include "texture/bake.h"
#include "texture/light.h"
#include "texture/view.h"

namespace ostraka::texture {

/// A mesh with its page of photographs.
struct TexturedMesh {
  TriangleMesh mesh;  ///< vertices on the borders of charts are there once for each chart
  std::vector<Eigen::Vector2f> uv;  ///< per vertex, 0..1 from the page's top left corner
  Texture texture;
  double texel_mm = 0;
  cv::Mat3b relief{};  ///< reliefOf a fuller mesh (relief.h), or empty
};

/// mesh: closed, outward, mm. A texel is as large as a pixel of the photograph that
/// was taken from nearest. light: divided out (bake.h). Errors: Cancelled; NotEnough when no
/// photograph shows the mesh.
Result<TexturedMesh> textured(const TriangleMesh& mesh, const std::vector<View>& views,
                              const std::optional<Light>& light, int threads, Progress& progress,
                              const std::stop_token& stop);

/// What parseTexturedGlb read, with its pictures decoded; without a mask of the same size all of it
/// counts as seen, and the texel's size is not known. Errors: UnusableInput (no picture, or one
/// that is larger than limits::kTexturePixels).
Result<TexturedMesh> opened(const TexturedModel& model, const std::string& where);

/// The same from a GLB's bytes; nothing where it has no texture. Errors: those of both.
Result<std::optional<TexturedMesh>> openedGlb(std::string_view glb, const std::string& where);

/// The same of the GLB that `process` leaves beside a model (its name, ending in .glb); nothing
/// where there is none. shape: the model itself. Errors: also UnusableInput for the GLB of another
/// model, whose bounding box differs by more than simplifying can make it.
Result<std::optional<TexturedMesh>> openedBeside(std::filesystem::path model,
                                                 const TriangleMesh& shape);
/// Without looking at the model itself.
Result<std::optional<TexturedMesh>> openedBeside(std::filesystem::path model);

/// The picture's level, BGR 0..255, at a place of 0..1 from its top left corner, by the four texels
/// around.
cv::Vec3f levelAt(const cv::Mat3b& picture, const Eigen::Vector2f& place);

/// The colour, red, green and blue 0..255, at a place of a triangle by the weights of its corners.
Eigen::Vector3d colourAt(const TexturedMesh& model, const std::array<int, 3>& triangle,
                         const std::array<double, 3>& weights);

/// The picture's colour at each vertex, for what shows no pictures.
std::vector<Color> vertexColours(const TexturedMesh& model);

/// What formatGlb takes: the picture, the mask of what was seen, the relief.
GlbTexture filesOf(const TexturedMesh& model);
/// Of a texture, as `process --texture` and GlbExtras call it: "photo", or "albedo" without light.
std::string nameOf(const Texture& texture);
/// As a GLB with them and with this name. Errors: those of formatGlb.
Result<std::string> formatGlb(const TexturedMesh& model, const GlbExtras& extras);
/// A PNG file of model::renderPreview, each pixel by its texel.
std::string previewOf(const TexturedMesh& model);

}  // namespace ostraka::texture
