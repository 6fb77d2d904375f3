#include <optional>
#include <sstream>

#include "base/text.h"
#include "capture/label_code.h"
#include "catalogue/label_codes.h"
#include "cloud/glb.h"
#include "exchange/model_files.h"
#include "must.h"
#include "tables/ods.h"
#include "targets.h"

namespace ostraka::fuzz {

void modelLabel(std::string_view bytes) {
  exchange::ModelLabel label;
  label.id = "019f5ff6-39c0-7b3a-9c55-2f7e8d104ab6";
  label.number = "ARM1-T3-0012-0007";
  label.licence = "CC-BY-4.0";
  label.program = "ostraka";
  label.scale_doubts = "One.\nTwo.";
  const Result<std::string> glb = exchange::labelledGlb(bytes, label, "fuzz.glb");
  mustNameItself(glb);
  if (glb) {
    const Result<std::string> again = exchange::labelledGlb(*glb, label, "again.glb");
    must(again.has_value() && *again == *glb, "a label that is renewed stays the same");
  }
  const Result<std::optional<TexturedModel>> textured = parseTexturedGlb(bytes, "fuzz.glb");
  mustNameItself(textured);
  if (textured && *textured) {
    const TexturedModel& model = **textured;
    const auto count = static_cast<int>(model.mesh.vertices.size());
    must(model.texture.uv.size() == model.mesh.vertices.size(), "each vertex has its place");
    for (const auto& t : model.mesh.triangles)
      for (const int v : t) must(v >= 0 && v < count, "faces refer to vertices that exist");
  }
  const Result<std::string> ply = exchange::labelledPly(bytes, label, "fuzz.ply");
  mustNameItself(ply);
  mustNameItself(exchange::labelledObj(bytes, label, "fuzz.ply"));
}

void spreadsheet(std::string_view bytes) {
  tables::OdsSheet sheet("Sherds", {{"text"}, {"number", true}, {"text 2"}});
  std::istringstream lines{std::string(bytes)};
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> values(3);
    std::istringstream fields(line);
    for (std::string& value : values) std::getline(fields, value, '\t');
    // The writer takes UTF-8, which every reader of a table has checked.
    for (std::string& value : values)
      if (!isUtf8(value)) value.clear();
    sheet.row(values);
  }
  const Result<std::string> written = tables::formatOds({sheet});
  mustNameItself(written);
  if (!written) return;
  const std::size_t begin = written->find("<office:document-content");
  const std::size_t end = written->find("</office:document-content>");
  must(begin != std::string::npos && end != std::string::npos, "the sheet is in the archive");
  int depth = 0;
  for (const char c : std::string_view(*written).substr(begin, end - begin)) {
    if (c == '<') must(++depth == 1, "no value opens an element");
    if (c == '>') must(--depth == 0, "no value closes an element");
    must(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t' || c == '\r',
         "XML holds no control characters");
  }
}

void labelCode(std::string_view bytes) {
  if (const auto code = catalogue::readLabelCode(bytes)) {
    must(!code->number.empty(), "a code has a number");
    must(isUtf8(code->number) || !isUtf8(bytes), "a number is a text");
  }
  mustNameItself(capture::codesIn(bytes));
}

}  // namespace ostraka::fuzz
