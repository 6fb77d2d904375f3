#include "cloud/obj.h"

#include <charconv>

namespace ostraka {
namespace {

void append(std::string& text, float value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  text += ' ';
  text.append(digits, end.ptr);
}

}  // namespace

Result<std::string> formatObj(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.size());
  const bool colors = mesh.colors.size() == mesh.vertices.size(),
             normals = mesh.normals.size() == mesh.vertices.size();
  std::string text = "# Ostraka, unit mm\n";
  for (int v = 0; v < n; ++v) {
    text += 'v';
    for (int k = 0; k < 3; ++k) append(text, mesh.vertices[v][k]);
    if (colors)
      for (int k = 0; k < 3; ++k) append(text, static_cast<float>(mesh.colors[v][k]) / 255.0f);
    text += '\n';
  }
  if (normals)
    for (int v = 0; v < n; ++v) {
      text += "vn";
      for (int k = 0; k < 3; ++k) append(text, mesh.normals[v][k]);
      text += '\n';
    }
  for (const auto& t : mesh.triangles) {
    text += 'f';
    for (const int v : t) {
      if (v < 0 || v >= n)
        return Error::unusable("A face of the mesh refers to a vertex that does not exist.");
      const std::string number = std::to_string(v + 1);
      text += ' ' + number + (normals ? "//" + number : "");
    }
    text += '\n';
  }
  return text;
}

}  // namespace ostraka
