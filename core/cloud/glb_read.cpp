#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "cloud/glb.h"
#include "files/json.h"

namespace ostraka {
namespace {

using nlohmann::json;

constexpr std::uint32_t kReadMagic = 0x46546C67, kReadJson = 0x4E4F534A, kReadBinary = 0x004E4942;
constexpr std::size_t kHeader = 12, kChunkHeader = 8;
constexpr std::size_t kMostHead = 1 << 20;  // bytes of JSON; formatGlb writes some thousand

Error noTexture(const std::string& where) {
  return Error::unusable(message("The texture of this GLB model cannot be read, so the model is "
                                 "used without it; reprocess its batch to write the file again."),
                         where);
}

template <class T>
T valueAt(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// Nothing where a key is absent or its parent has none.
const json& memberOf(const json& parent, const char* key) {
  static const json kNothing;
  const auto found = parent.is_object() ? parent.find(key) : parent.end();
  return parent.is_object() && found != parent.end() ? *found : kNothing;
}

// The element with this index of a list at the file's top.
const json& entryOf(const json& root, const char* list, const json& index) {
  static const json kNothing;
  const json& all = memberOf(root, list);
  return all.is_array() && index.is_number_unsigned() && index.get<std::uint64_t>() < all.size()
             ? all[index.get<std::size_t>()]
             : kNothing;
}

std::optional<std::size_t> sizeIn(const json& object, const char* key) {
  const json& value = memberOf(object, key);
  if (!value.is_number_unsigned()) return std::nullopt;
  return value.get<std::size_t>();
}

// Absent: 0.
std::optional<std::size_t> offsetIn(const json& object) {
  return memberOf(object, "byteOffset").is_null() ? 0 : sizeIn(object, "byteOffset");
}

struct Chunks {
  std::string_view text, binary;
};

std::optional<Chunks> chunksOf(std::string_view glb) {
  if (glb.size() < kHeader + kChunkHeader || valueAt<std::uint32_t>(glb, 0) != kReadMagic ||
      valueAt<std::uint32_t>(glb, 4) != 2 || valueAt<std::uint32_t>(glb, 8) != glb.size())
    return std::nullopt;
  Chunks chunks;
  std::string_view rest = glb.substr(kHeader);
  for (const std::uint32_t type : {kReadJson, kReadBinary}) {
    if (rest.size() < kChunkHeader || valueAt<std::uint32_t>(rest, 4) != type) return std::nullopt;
    const std::size_t size = valueAt<std::uint32_t>(rest, 0);
    if (size > rest.size() - kChunkHeader) return std::nullopt;
    (type == kReadJson ? chunks.text : chunks.binary) = rest.substr(kChunkHeader, size);
    rest.remove_prefix(kChunkHeader + size);
  }
  return chunks;
}

class GlbReader {
 public:
  GlbReader(const json& root, std::string_view binary) : root_(root), binary_(binary) {}

  // One mesh in its place, of one part, in the file's own bytes.
  bool isPlain() const {
    const json &node = entryOf(root_, "nodes", 0u), &meshes = memberOf(root_, "meshes");
    for (const char* key : {"matrix", "translation", "rotation", "scale", "skin", "children"})
      if (!memberOf(node, key).is_null()) return false;
    const json& buffers = memberOf(root_, "buffers");
    return node.is_object() && memberOf(root_, "nodes").size() == 1 && meshes.is_array() &&
           meshes.size() == 1 && memberOf(meshes[0], "primitives").is_array() &&
           memberOf(meshes[0], "primitives").size() == 1 && buffers.is_array() &&
           buffers.size() == 1 && memberOf(buffers[0], "uri").is_null() &&
           memberOf(root_, "extensionsRequired").empty();
  }

  bool readMesh(TriangleMesh& mesh, std::vector<Eigen::Vector2f>& uv) const {
    const json& part = primitive();
    const json& attributes = memberOf(part, "attributes");
    std::vector<float> values;
    if (memberOf(part, "mode") != 4u || !floats(attributes, "POSITION", "VEC3", 3, values))
      return false;
    for (std::size_t i = 0; i < values.size(); i += 3)
      mesh.vertices.push_back(1000 * zUp(values.data() + i));
    if (memberOf(attributes, "NORMAL").is_number()) {
      if (!floats(attributes, "NORMAL", "VEC3", 3, values)) return false;
      for (std::size_t i = 0; i < values.size(); i += 3)
        mesh.normals.push_back(zUp(values.data() + i));
    }
    if (memberOf(attributes, "_SEEN").is_number()) {
      if (!floats(attributes, "_SEEN", "SCALAR", 1, values)) return false;
      for (const float seen : values) mesh.seen.push_back(seen > 0.5f ? 1 : 0);
    }
    if (!floats(attributes, "TEXCOORD_0", "VEC2", 2, values)) return false;
    for (std::size_t i = 0; i < values.size(); i += 2) uv.emplace_back(values[i], values[i + 1]);
    const std::size_t n = mesh.vertices.size();
    return uv.size() == n && (mesh.normals.empty() || mesh.normals.size() == n) &&
           (mesh.seen.empty() || mesh.seen.size() == n) && readFaces(part, mesh);
  }

  // The part's picture, a whole file; null where its material has none.
  const json& picture() const {
    const json& material = entryOf(root_, "materials", memberOf(primitive(), "material"));
    const json& shown = memberOf(memberOf(material, "pbrMetallicRoughness"), "baseColorTexture");
    return entryOf(root_, "images",
                   memberOf(entryOf(root_, "textures", memberOf(shown, "index")), "source"));
  }

  // Empty where it does not lie in the file's own bytes.
  std::string image(const json& image) const {
    if (!memberOf(image, "uri").is_null()) return {};
    return std::string(view(memberOf(image, "bufferView")).value_or(std::string_view()));
  }

  const json& seenImage() const {
    const json& extras = memberOf(memberOf(entryOf(root_, "nodes", 0u), "extras"), "ostraka");
    return entryOf(root_, "images", memberOf(extras, "seen_image"));
  }

 private:
  static Eigen::Vector3f zUp(const float* p) { return {p[0], -p[2], p[1]}; }

  const json& primitive() const { return memberOf(root_["meshes"][0], "primitives")[0]; }

  std::optional<std::string_view> view(const json& index) const {
    const json& view = entryOf(root_, "bufferViews", index);
    const std::optional<std::size_t> size = sizeIn(view, "byteLength");
    const std::optional<std::size_t> begin = offsetIn(view);
    if (!size || !begin || memberOf(view, "buffer") != 0u ||
        !memberOf(view, "byteStride").is_null() || *begin > binary_.size() ||
        *size > binary_.size() - *begin)
      return std::nullopt;
    return binary_.substr(*begin, *size);
  }

  // The bytes of an accessor's elements, one after the other.
  std::optional<std::string_view> elements(const json& accessor, std::size_t bytes_each) const {
    const std::optional<std::size_t> count = sizeIn(accessor, "count");
    const std::optional<std::string_view> all = view(memberOf(accessor, "bufferView"));
    const std::optional<std::size_t> begin = offsetIn(accessor);
    if (!count || !all || !begin || !memberOf(accessor, "sparse").is_null() ||
        *begin > all->size() || *count > (all->size() - *begin) / bytes_each)
      return std::nullopt;
    return all->substr(*begin, *count * bytes_each);
  }

  bool floats(const json& attributes, const char* name, const char* type, std::size_t each,
              std::vector<float>& values) const {
    constexpr unsigned kFloatType = 5126;
    const json& accessor = entryOf(root_, "accessors", memberOf(attributes, name));
    if (memberOf(accessor, "type") != type || memberOf(accessor, "componentType") != kFloatType)
      return false;
    const std::optional<std::string_view> bytes = elements(accessor, each * sizeof(float));
    if (!bytes) return false;
    values.resize(bytes->size() / sizeof(float));
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = valueAt<float>(*bytes, i * sizeof(float));
      if (!std::isfinite(values[i])) return false;
    }
    return true;
  }

  template <class Index>
  bool readFacesAs(const json& accessor, TriangleMesh& mesh) const {
    const std::optional<std::string_view> bytes = elements(accessor, sizeof(Index));
    if (!bytes || bytes->empty() || bytes->size() % (3 * sizeof(Index)) != 0) return false;
    mesh.triangles.resize(bytes->size() / (3 * sizeof(Index)));
    for (std::size_t i = 0; i < 3 * mesh.triangles.size(); ++i) {
      const auto vertex = valueAt<Index>(*bytes, i * sizeof(Index));
      if (vertex >= mesh.vertices.size()) return false;
      mesh.triangles[i / 3][i % 3] = static_cast<int>(vertex);
    }
    return true;
  }

  bool readFaces(const json& part, TriangleMesh& mesh) const {
    const json& accessor = entryOf(root_, "accessors", memberOf(part, "indices"));
    if (memberOf(accessor, "type") != "SCALAR") return false;
    const json& type = memberOf(accessor, "componentType");
    if (type == 5123u) return readFacesAs<std::uint16_t>(accessor, mesh);
    return type == 5125u && readFacesAs<std::uint32_t>(accessor, mesh);
  }

  const json& root_;
  std::string_view binary_;
};

// A file from elsewhere may contain anything there.
GlbExtras extrasOf(const json& root) {
  const json& about = memberOf(memberOf(entryOf(root, "nodes", 0u), "extras"), "ostraka");
  GlbExtras extras;
  if (const json& munsell = memberOf(about, "munsell"); munsell.is_object())
    extras.munsell = munsell.dump();
  if (const json& texture = memberOf(about, "texture"); texture == "photo" || texture == "albedo")
    extras.texture = texture.get<std::string>();
  return extras;
}

}  // namespace

GlbExtras extrasInGlb(const std::filesystem::path& path) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return {};  // a pipe would never end
  std::ifstream file(path, std::ios::binary);
  std::string head(kHeader + kChunkHeader, '\0');
  if (!file.read(head.data(), static_cast<std::streamsize>(head.size())) ||
      valueAt<std::uint32_t>(head, 0) != kReadMagic ||
      valueAt<std::uint32_t>(head, kHeader + 4) != kReadJson)
    return {};
  const std::size_t size = valueAt<std::uint32_t>(head, kHeader);
  if (size > kMostHead) return {};
  std::string text(size, '\0');
  if (!file.read(text.data(), static_cast<std::streamsize>(size))) return {};
  const Result<json> root = parseJson(text, path.string());
  if (!root) return {};
  return extrasOf(*root);
}

Result<std::optional<TexturedModel>> parseTexturedGlb(std::string_view bytes,
                                                      const std::string& where) {
  const std::optional<Chunks> chunks = chunksOf(bytes);
  if (!chunks) return noTexture(where);
  const Result<json> root = parseJson(chunks->text, where);
  if (!root) return root.error();
  const GlbReader reader(*root, chunks->binary);
  if (memberOf(*root, "images").empty()) return std::optional<TexturedModel>();
  if (!reader.isPlain()) return noTexture(where);
  TexturedModel model;
  if (!reader.readMesh(model.mesh, model.texture.uv)) return noTexture(where);
  model.texture.jpeg = reader.image(reader.picture());
  if (model.texture.jpeg.empty()) return noTexture(where);
  if (!reader.seenImage().is_null()) model.texture.seen_png = reader.image(reader.seenImage());
  model.extras = extrasOf(*root);
  return std::optional(std::move(model));
}

}  // namespace ostraka
