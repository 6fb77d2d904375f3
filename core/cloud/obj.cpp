#include "cloud/obj.h"

#include <charconv>

#include "base/message.h"

namespace ostraka {
namespace {

void append(std::string& text, float value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  text += ' ';
  text.append(digits, end.ptr);
}

struct ObjTexture {
  const std::vector<Eigen::Vector2f>& uv;
  const std::string& material_file;
};

constexpr const char* kMaterial = "photographs";

template <class Vector>
void appendLine(std::string& text, const char* word, const Vector& vector) {
  text += word;
  for (Eigen::Index k = 0; k < vector.size(); ++k) append(text, vector[k]);
  text += '\n';
}

Result<std::string> formatted(const TriangleMesh& mesh, const ObjTexture* texture) {
  const int n = static_cast<int>(mesh.vertices.size());
  const bool colors = texture == nullptr && mesh.colors.size() == mesh.vertices.size(),
             normals = mesh.normals.size() == mesh.vertices.size();
  if (texture != nullptr && texture->uv.size() != mesh.vertices.size())
    return Error::unusable(message("Not every vertex has a place in the texture."));
  std::string text = "# Ostraka, unit mm\n";
  if (texture != nullptr) text += "mtllib " + texture->material_file + '\n';
  for (int v = 0; v < n; ++v) {
    text += 'v';
    for (int k = 0; k < 3; ++k) append(text, mesh.vertices[v][k]);
    if (colors)
      for (int k = 0; k < 3; ++k) append(text, static_cast<float>(mesh.colors[v][k]) / 255.0f);
    text += '\n';
  }
  if (texture != nullptr) {
    // From the picture's lower left corner.
    for (const Eigen::Vector2f& place : texture->uv)
      appendLine(text, "vt", Eigen::Vector2f(place.x(), 1 - place.y()));
    text += std::string("usemtl ") + kMaterial + '\n';
  }
  if (normals)
    for (const Eigen::Vector3f& normal : mesh.normals) appendLine(text, "vn", normal);
  for (const auto& t : mesh.triangles) {
    text += 'f';
    for (const int v : t) {
      if (v < 0 || v >= n)
        return Error::unusable(message("A face refers to a vertex that does not exist."));
      const std::string number = std::to_string(v + 1);
      text += ' ' + number;
      if (texture != nullptr || normals) text += '/';
      if (texture != nullptr) text += number;
      if (normals) text += '/' + number;
    }
    text += '\n';
  }
  return text;
}

}  // namespace

Result<std::string> formatObj(const TriangleMesh& mesh) {
  return formatted(mesh, nullptr);
}

Result<std::string> formatObj(const TriangleMesh& mesh, const std::vector<Eigen::Vector2f>& uv,
                              const std::string& material_file) {
  const ObjTexture texture{uv, material_file};
  return formatted(mesh, &texture);
}

// No ambient light beside the diffuse one: viewers add the two, and the photographs turn white.
std::string formatMtl(const std::string& picture_file) {
  return std::string("newmtl ") + kMaterial + "\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " +
         picture_file + '\n';
}

}  // namespace ostraka
