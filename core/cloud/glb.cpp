#include "cloud/glb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "files/files.h"
#include "files/json.h"

namespace ostraka {
namespace {

using nlohmann::ordered_json;

constexpr int kFloat = 5126, kUnsignedShort = 5123, kUnsignedInt = 5125;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

template <class T>
void appendBytes(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof raw);
}

// The binary chunk with its views and accessors.
struct Buffer {
  std::string bytes;
  ordered_json views = ordered_json::array(), accessors = ordered_json::array();

  // A whole file; returns the number of its view.
  int addImage(const std::string& file) {
    views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", file.size()}});
    bytes += file;
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    return static_cast<int>(views.size()) - 1;
  }

  // Closes what was appended since `begin` as one accessor; returns its number.
  int close(std::size_t begin, int target, int component, std::size_t count, const char* type) {
    views.push_back({{"buffer", 0},
                     {"byteOffset", begin},
                     {"byteLength", bytes.size() - begin},
                     {"target", target}});
    accessors.push_back({{"bufferView", views.size() - 1},
                         {"componentType", component},
                         {"count", count},
                         {"type", type}});
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    return static_cast<int>(accessors.size()) - 1;
  }
};

Eigen::Vector3f yUp(const Eigen::Vector3f& v) {
  return {v[0], v[2], -v[1]};
}

// IEC 61966-2-1, to 16 bits: COLOR_0 is linear.
std::uint16_t linear(std::uint8_t level) {
  const double c = level / 255.0;
  const double value = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  return static_cast<std::uint16_t>(std::lround(value * 65535));
}

int addPositions(Buffer& buffer, const TriangleMesh& mesh) {
  const std::size_t begin = buffer.bytes.size();
  Eigen::Vector3f low = Eigen::Vector3f::Constant(INFINITY), high = -low;
  for (const Eigen::Vector3f& v : mesh.vertices) {
    const Eigen::Vector3f p = yUp(v) / 1000.0f;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    for (int k = 0; k < 3; ++k) appendBytes(buffer.bytes, p[k]);
  }
  const int index = buffer.close(begin, kArrayBuffer, kFloat, mesh.vertices.size(), "VEC3");
  // Doubles hold the float's exact value, and so does their shortest text.
  buffer.accessors[index]["min"] = {double{low[0]}, double{low[1]}, double{low[2]}};
  buffer.accessors[index]["max"] = {double{high[0]}, double{high[1]}, double{high[2]}};
  return index;
}

int addNormals(Buffer& buffer, const TriangleMesh& mesh) {
  const std::size_t begin = buffer.bytes.size();
  for (const Eigen::Vector3f& v : mesh.normals) {
    // The standard wants unit length; a vertex without a normal points up.
    const float length = v.norm();
    const Eigen::Vector3f n =
        length > 1e-6f ? Eigen::Vector3f(yUp(v) / length) : Eigen::Vector3f::UnitY();
    for (int k = 0; k < 3; ++k) appendBytes(buffer.bytes, n[k]);
  }
  return buffer.close(begin, kArrayBuffer, kFloat, mesh.normals.size(), "VEC3");
}

int addTangents(Buffer& buffer, const std::vector<Eigen::Vector3f>& tangents) {
  const std::size_t begin = buffer.bytes.size();
  for (const Eigen::Vector3f& v : tangents) {
    const Eigen::Vector3f tangent = yUp(v);
    for (int k = 0; k < 3; ++k) appendBytes(buffer.bytes, tangent[k]);
    appendBytes(buffer.bytes, 1.0f);  // right-handed
  }
  return buffer.close(begin, kArrayBuffer, kFloat, tangents.size(), "VEC4");
}

int addColors(Buffer& buffer, const TriangleMesh& mesh) {
  const std::size_t begin = buffer.bytes.size();
  for (const Color& c : mesh.colors) {
    for (const std::uint8_t level : c) appendBytes(buffer.bytes, linear(level));
    appendBytes(buffer.bytes, std::uint16_t{65535});
  }
  const int index = buffer.close(begin, kArrayBuffer, kUnsignedShort, mesh.colors.size(), "VEC4");
  buffer.accessors[index]["normalized"] = true;
  return index;
}

int addPlaces(Buffer& buffer, const std::vector<Eigen::Vector2f>& uv) {
  const std::size_t begin = buffer.bytes.size();
  for (const Eigen::Vector2f& place : uv) {
    appendBytes(buffer.bytes, place.x());
    appendBytes(buffer.bytes, place.y());
  }
  return buffer.close(begin, kArrayBuffer, kFloat, uv.size(), "VEC2");
}

int addSeen(Buffer& buffer, const TriangleMesh& mesh) {
  const std::size_t begin = buffer.bytes.size();
  for (const std::uint8_t s : mesh.seen) appendBytes(buffer.bytes, s ? 1.0f : 0.0f);
  return buffer.close(begin, kArrayBuffer, kFloat, mesh.seen.size(), "SCALAR");
}

int addIndices(Buffer& buffer, const TriangleMesh& mesh) {
  const std::size_t begin = buffer.bytes.size();
  // 65535 itself would mean 'restart'.
  const bool is_short = mesh.vertices.size() <= 65535;
  for (const auto& t : mesh.triangles)
    for (const int v : t) {
      if (is_short)
        appendBytes(buffer.bytes, static_cast<std::uint16_t>(v));
      else
        appendBytes(buffer.bytes, static_cast<std::uint32_t>(v));
    }
  return buffer.close(begin, kElementArrayBuffer, is_short ? kUnsignedShort : kUnsignedInt,
                      mesh.triangles.size() * 3, "SCALAR");
}

ordered_json describe(const GlbExtras& extras) {
  ordered_json about = ordered_json::object();
  if (!extras.id.empty()) about["id"] = extras.id;
  if (!extras.number.empty()) about["number"] = extras.number;
  about["unit"] = "m";
  if (extras.filled_percent >= 0) about["filled_pct"] = extras.filled_percent;
  if (!extras.texture.empty()) about["texture"] = extras.texture;
  if (const auto munsell = parseJson(extras.munsell, {})) about["munsell"] = *munsell;
  return about;
}

void appendChunk(std::string& file, std::uint32_t type, std::string chunk, char padding) {
  chunk.resize((chunk.size() + 3) / 4 * 4, padding);
  appendBytes(file, static_cast<std::uint32_t>(chunk.size()));
  appendBytes(file, type);
  file += chunk;
}

}  // namespace

namespace {

Result<void> checkFaces(const TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.size());
  if (mesh.triangles.empty()) return Error::unusable(message("The mesh has no faces."));
  for (const auto& t : mesh.triangles)
    if (std::min({t[0], t[1], t[2]}) < 0 || std::max({t[0], t[1], t[2]}) >= n)
      return Error::unusable(message("A face refers to a vertex that does not exist."));
  return {};
}

std::string joined(const ordered_json& root, std::string binary) {
  std::string file = "glTF";
  appendBytes(file, std::uint32_t{2});
  appendBytes(file, std::uint32_t{0});
  appendChunk(file, kJsonChunk, root.dump(), ' ');
  appendChunk(file, kBinaryChunk, std::move(binary), '\0');
  const auto size = static_cast<std::uint32_t>(file.size());
  std::memcpy(file.data() + 8, &size, sizeof size);
  return file;
}

// The number of a PNG among the file's images.
std::size_t addPng(Buffer& buffer, const std::string& png, ordered_json& root) {
  root["images"].push_back({{"bufferView", buffer.addImage(png)}, {"mimeType", "image/png"}});
  return root["images"].size() - 1;
}

void addTexture(Buffer& buffer, const GlbTexture& texture, ordered_json& root) {
  root["images"] = ordered_json::array(
      {{{"bufferView", buffer.addImage(texture.jpeg)}, {"mimeType", "image/jpeg"}}});
  // Smaller copies in between, as from afar; what lies beyond the edge is the edge.
  root["samplers"] = ordered_json::array(
      {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33071}}});
  root["textures"] = ordered_json::array({{{"sampler", 0}, {"source", 0}}});
  root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  if (!texture.seen_png.empty())
    root["nodes"][0]["extras"]["ostraka"]["seen_image"] = addPng(buffer, texture.seen_png, root);
  if (texture.normals_png.empty()) return;
  const std::size_t normals = addPng(buffer, texture.normals_png, root);
  root["textures"].push_back({{"sampler", 0}, {"source", normals}});
  root["materials"][0]["normalTexture"] = {{"index", 1}};
}

Result<std::string> formatted(const TriangleMesh& mesh, const GlbTexture* texture,
                              const GlbExtras& extras) {
  if (const Result<void> good = checkFaces(mesh); !good) return good.error();
  if (texture != nullptr && texture->uv.size() != mesh.vertices.size())
    return Error::unusable(message("Not every vertex has a place in the texture."));
  const bool has_relief = texture != nullptr && !texture->normals_png.empty();
  if (has_relief && (texture->tangents.size() != mesh.vertices.size() ||
                     mesh.normals.size() != mesh.vertices.size()))
    return Error::unusable(message("Not every vertex has a place in the texture."));
  Buffer buffer;
  ordered_json attributes = {{"POSITION", addPositions(buffer, mesh)}};
  if (mesh.normals.size() == mesh.vertices.size()) attributes["NORMAL"] = addNormals(buffer, mesh);
  if (has_relief) attributes["TANGENT"] = addTangents(buffer, texture->tangents);
  if (texture != nullptr)
    attributes["TEXCOORD_0"] = addPlaces(buffer, texture->uv);
  else if (mesh.colors.size() == mesh.vertices.size())
    attributes["COLOR_0"] = addColors(buffer, mesh);
  if (mesh.seen.size() == mesh.vertices.size()) attributes["_SEEN"] = addSeen(buffer, mesh);
  const int indices = addIndices(buffer, mesh);

  ordered_json root;
  root["asset"] = {{"version", "2.0"}, {"generator", "Ostraka"}};
  if (!extras.copyright.empty()) root["asset"]["copyright"] = extras.copyright;
  root["scene"] = 0;
  root["scenes"] = ordered_json::array({{{"nodes", {0}}}});
  root["nodes"] = ordered_json::array({{{"mesh", 0}, {"extras", {{"ostraka", describe(extras)}}}}});
  // Fired clay: no metal, no gloss.
  root["materials"] = ordered_json::array(
      {{{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}}});
  root["meshes"] =
      ordered_json::array({{{"primitives", ordered_json::array({{{"attributes", attributes},
                                                                 {"indices", indices},
                                                                 {"material", 0},
                                                                 {"mode", 4}}})}}});
  if (texture != nullptr) addTexture(buffer, *texture, root);
  root["accessors"] = buffer.accessors;
  root["bufferViews"] = buffer.views;
  root["buffers"] = ordered_json::array({{{"byteLength", buffer.bytes.size()}}});
  return joined(root, std::move(buffer.bytes));
}

}  // namespace

Result<std::string> formatGlb(const TriangleMesh& mesh, const GlbExtras& extras) {
  return formatted(mesh, nullptr, extras);
}

Result<std::string> formatGlb(const TriangleMesh& mesh, const GlbTexture& texture,
                              const GlbExtras& extras) {
  return formatted(mesh, &texture, extras);
}

Result<void> writeGlb(const std::filesystem::path& path, const Result<std::string>& bytes) {
  if (!bytes) return Error{bytes.error().code, bytes.error().what, path.string()};
  return writeFileAtomically(path, *bytes);
}

}  // namespace ostraka
