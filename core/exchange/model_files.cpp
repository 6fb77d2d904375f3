#include "exchange/model_files.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/message.h"
#include "cloud/obj.h"
#include "cloud/ply.h"
#include "exchange/lighter_model.h"
#include "files/json.h"
#include "files/json_text.h"
#include "metadata/json_fields.h"
#include "store/values.h"

namespace ostraka::exchange {
namespace {

using nlohmann::ordered_json;

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

// Whole lines, each begun with what makes it a comment in the file.
std::string comments(const ModelLabel& label, const std::string& begin) {
  std::string text = label.program + " id " + label.id;
  if (!label.number.empty()) text += " number " + label.number;
  if (!label.licence.empty()) text += " licence " + label.licence;
  std::string lines = begin + oneLine(text) + "\n";
  if (label.deviation_mm >= 0)
    lines += begin + "simplified from the full-detail model: 99.9 % within " +
             store::numberText(label.deviation_mm) + " mm, all within " +
             store::numberText(label.farthest_mm) + " mm\n";
  std::istringstream doubts(label.scale_doubts);
  for (std::string doubt; std::getline(doubts, doubt);)
    if (!doubt.empty()) lines += begin + "measurements in doubt: " + oneLine(doubt) + "\n";
  return lines;
}

std::uint32_t u32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

void append(std::string& out, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>(value >> (8 * i) & 0xFF);
}

constexpr std::string_view kPlyDoubt = "comment measurements in doubt: ",
                           kPlyPicture = "comment TextureFile ";

// A model that was read back from an export may carry a doubt that is settled since, and the name
// of a picture that lies elsewhere: lines gives both anew.
Result<std::string> withComments(std::string_view ply, const std::string& lines,
                                 const std::string& where) {
  const std::size_t end = ply.find("end_header\n");
  const std::size_t first = ply.find("format ");
  if (!ply.starts_with("ply\n") || end == std::string_view::npos ||
      first == std::string_view::npos || first > end)
    return Error::unusable(message("Not a PLY file."), where);
  const std::size_t at = ply.find('\n', first) + 1;
  std::string rest;
  std::istringstream header(std::string(ply.substr(at, end - at)));
  for (std::string line; std::getline(header, line);)
    if (!line.starts_with(kPlyDoubt) && !line.starts_with(kPlyPicture)) rest += line + "\n";
  return std::string(ply.substr(0, at)) + lines + rest + std::string(ply.substr(end));
}

// Where the label stands: objects, or nothing yet.
bool takesLabel(const ordered_json& model) {
  const auto object = [](const ordered_json& parent, const char* name) {
    return !parent.contains(name) || parent[name].is_object();
  };
  if (!model.is_object() || !object(model, "asset") || !model.contains("nodes")) return false;
  const ordered_json& nodes = model["nodes"];
  if (!nodes.is_array() || nodes.empty() || !nodes[0].is_object()) return false;
  if (!object(nodes[0], "extras")) return false;
  return !nodes[0].contains("extras") || object(nodes[0]["extras"], "ostraka");
}

constexpr std::uint32_t kGlb = 0x46546C67, kJson = 0x4E4F534A;

}  // namespace

Result<std::string> labelledPly(std::string_view ply, const ModelLabel& label,
                                const std::string& where) {
  return withComments(ply, comments(label, "comment "), where);
}

Result<std::string> labelledTexturedPly(const TriangleMesh& mesh,
                                        const texture::TexturedMesh& model, const ModelLabel& label,
                                        const std::string& picture_file) {
  return withComments(formatPly(mesh, "plate_front", placesOn(mesh, model)),
                      comments(label, "comment ") + std::string(kPlyPicture) + picture_file + "\n",
                      picture_file);
}

Result<std::string> labelledGlb(std::string_view glb, const ModelLabel& label,
                                const std::string& where) {
  const Error no_glb = Error::unusable(message("Not a GLB file."), where);
  if (glb.size() < 20 || u32(glb, 0) != kGlb || u32(glb, 8) != glb.size() || u32(glb, 16) != kJson)
    return no_glb;
  const std::size_t size = u32(glb, 12);
  if (size > glb.size() - 20) return no_glb;
  Result<ordered_json> parsed = parseOrderedJson(glb.substr(20, size), where);
  if (!parsed) return parsed.error();
  ordered_json json = std::move(*parsed);
  if (!takesLabel(json)) return no_glb;
  if (!label.licence.empty()) json["asset"]["copyright"] = label.licence;
  json["asset"]["generator"] = label.program;
  ordered_json& extras = json["nodes"][0]["extras"]["ostraka"];
  extras["id"] = label.id;
  extras["number"] = label.number;
  extras["unit"] = "m";
  extras.erase("scale_doubts");
  if (label.deviation_mm >= 0) extras["deviation_mm"] = label.deviation_mm;
  if (label.farthest_mm >= 0) extras["farthest_mm"] = label.farthest_mm;
  if (!label.scale_doubts.empty()) extras["scale_doubts"] = label.scale_doubts;
  Result<std::string> written = metadata::jsonText(json, where, -1);
  if (!written) return written;
  std::string& text = *written;
  text.append((4 - text.size() % 4) % 4, ' ');
  const std::string_view rest = glb.substr(20 + size);
  std::string out;
  append(out, kGlb);
  append(out, 2);
  append(out, static_cast<std::uint32_t>(20 + text.size() + rest.size()));
  append(out, static_cast<std::uint32_t>(text.size()));
  append(out, kJson);
  return out + text + std::string(rest);
}

Result<std::string> labelledObj(std::string_view ply, const ModelLabel& label,
                                const std::string& where) {
  const Result<PlyContents> read = parsePly(ply, where);
  if (!read) return read.error();
  const Result<std::string> obj = formatObj(read->mesh);
  if (!obj) return obj;
  return comments(label, "# ") + *obj;
}

Result<TexturedObj> labelledTexturedObj(const texture::TexturedMesh& model, const ModelLabel& label,
                                        const std::string& name) {
  const Result<std::string> obj = formatObj(model.mesh, model.uv, name + ".mtl");
  if (!obj) return obj.error();
  const std::string begin = comments(label, "# ");
  return TexturedObj{begin + *obj, begin + formatMtl(name + ".png")};
}

}  // namespace ostraka::exchange
