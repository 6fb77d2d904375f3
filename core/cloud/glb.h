#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "cloud/point_cloud.h"

namespace ostraka {

/// What travels with a model (asset.copyright and nodes[0].extras.ostraka); empty texts are left
/// out.
struct GlbExtras {
  std::string id, number, copyright;
  double filled_percent = -1;  ///< < 0: left out
  std::string munsell{};       ///< proposals for its Munsell colours: a JSON object as text
  std::string texture{};       ///< "photo", or "albedo": without the light that fell on the sherd
};

/// A picture on the mesh.
struct GlbTexture {
  std::vector<Eigen::Vector2f> uv;  ///< per vertex, 0..1 from the picture's top left corner
  std::string jpeg;                 ///< the picture, sRGB, a whole file
  std::string seen_png;  ///< a mask of the same size, 0: filled in; extras.ostraka.seen_image; or
                         ///< empty
  /// A normal map on the same places, linear, green up; or empty.
  std::string normals_png{};
  /// Per vertex, only with a normal map: unit length, mm's axes; the third direction of a texel's
  /// frame is the cross product of normal and tangent.
  std::vector<Eigen::Vector3f> tangents{};
};

/// glTF 2.0 binary: metres, +Y up, baked into the positions ((x, y, z) mm -> (x, z, -y) / 1000),
/// normals, COLOR_0 linear 16 bit RGBA, _SEEN as float 0 or 1, 16 or 32 bit indices. One mesh, one
/// node. Errors: UnusableInput for a mesh without triangles or with a wrong index.
Result<std::string> formatGlb(const TriangleMesh& mesh, const GlbExtras& extras);
/// With a texture in place of COLOR_0, which readers would multiply it with. A normal map needs
/// normals and brings TANGENT.
Result<std::string> formatGlb(const TriangleMesh& mesh, const GlbTexture& texture,
                              const GlbExtras& extras);
/// A mesh in mm, z up, with a picture on it.
struct TexturedModel {
  TriangleMesh mesh;  ///< without colours
  GlbTexture texture;
  GlbExtras extras{};  ///< munsell and texture alone
};
/// What formatGlb made with a texture; nothing where the file has no picture. Everything lies
/// within the bytes: what names another file or address is refused, and so is what formatGlb does
/// not write (several meshes, moved nodes, extensions). Pictures are not decoded. Errors:
/// UnusableInput.
Result<std::optional<TexturedModel>> parseTexturedGlb(std::string_view bytes,
                                                      const std::string& where);
/// GlbExtras::munsell and texture of a file that formatGlb made, of which only the head is read;
/// empty where it has none or is no such file, or no regular one.
GlbExtras extrasInGlb(const std::filesystem::path& path);
/// What formatGlb made, into this file; its error names the file.
Result<void> writeGlb(const std::filesystem::path& path, const Result<std::string>& bytes);

}  // namespace ostraka
