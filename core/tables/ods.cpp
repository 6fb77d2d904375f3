#include "tables/ods.h"

#include <algorithm>

#include "archive/zip.h"
#include "paper/markup.h"

namespace ostraka::tables {
namespace {

constexpr const char* kType = "application/vnd.oasis.opendocument.spreadsheet";

constexpr const char* kManifest =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<manifest:manifest xmlns:manifest=\"urn:oasis:names:tc:opendocument:xmlns:manifest:1.0\" "
    "manifest:version=\"1.2\">\n"
    "<manifest:file-entry manifest:full-path=\"/\" manifest:version=\"1.2\" "
    "manifest:media-type=\"application/vnd.oasis.opendocument.spreadsheet\"/>\n"
    "<manifest:file-entry manifest:full-path=\"content.xml\" manifest:media-type=\"text/xml\"/>\n"
    "</manifest:manifest>\n";

constexpr const char* kHead =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<office:document-content xmlns:office="urn:oasis:names:tc:opendocument:xmlns:office:1.0" )"
    R"(xmlns:table="urn:oasis:names:tc:opendocument:xmlns:table:1.0" )"
    R"(xmlns:text="urn:oasis:names:tc:opendocument:xmlns:text:1.0" )"
    R"(xmlns:style="urn:oasis:names:tc:opendocument:xmlns:style:1.0" )"
    R"(xmlns:fo="urn:oasis:names:tc:opendocument:xmlns:xsl-fo-compatible:1.0" office:version="1.2">
<office:automatic-styles><style:style style:name="head" style:family="table-cell">)"
    R"(<style:text-properties fo:font-weight="bold"/></style:style></office:automatic-styles>
<office:body><office:spreadsheet>
)";

constexpr const char* kTail = "</office:spreadsheet></office:body></office:document-content>\n";

// Paragraphs for lines; runs of blanks, which XML would make one, are counted.
std::string paragraphs(std::string_view text) {
  std::string out = "<text:p>";
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') {
      out += "</text:p><text:p>";
    } else if (text[i] == '\t') {
      out += "<text:tab/>";
    } else if (text[i] == ' ') {
      std::size_t count = 1;
      while (i + 1 < text.size() && text[i + 1] == ' ') ++count, ++i;
      out += " ";
      if (count > 1) out += "<text:s text:c=\"" + std::to_string(count - 1) + "\"/>";
    } else if (text[i] != '\r') {
      const std::size_t end = std::min(text.find_first_of("\n\t\r ", i), text.size());
      out += markupText(text.substr(i, end - i));
      i = end - 1;
    }
  }
  return out + "</text:p>";
}

}  // namespace

OdsSheet::OdsSheet(const std::string& name, std::vector<Column> columns)
    : columns_(std::move(columns)) {
  xml_ = "<table:table table:name=\"" + markupText(name) + "\"><table:table-column " +
         "table:number-columns-repeated=\"" + std::to_string(columns_.size()) +
         "\"/><table:table-header-rows><table:table-row>";
  for (const Column& column : columns_)
    xml_ += "<table:table-cell table:style-name=\"head\" office:value-type=\"string\">" +
            paragraphs(column.name) + "</table:table-cell>";
  xml_ += "</table:table-row></table:table-header-rows>\n";
}

void OdsSheet::row(const std::vector<std::string>& values) {
  xml_ += "<table:table-row>";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].empty())
      xml_ += "<table:table-cell/>";
    else if (columns_[i].number)
      xml_ += "<table:table-cell office:value-type=\"float\" office:value=\"" +
              markupText(values[i]) + "\">" + paragraphs(values[i]) + "</table:table-cell>";
    else
      xml_ += "<table:table-cell office:value-type=\"string\">" + paragraphs(values[i]) +
              "</table:table-cell>";
  }
  xml_ += "</table:table-row>\n";
}

Result<std::string> formatOds(const std::vector<OdsSheet>& sheets) {
  std::string content = kHead;
  for (const OdsSheet& sheet : sheets) content += sheet.xml_ + "</table:table>\n";
  content += kTail;
  // The type comes first, so that it stands at a known place of the file.
  return archive::zipped(
      {{"mimetype", kType}, {"content.xml", content}, {"META-INF/manifest.xml", kManifest}});
}

}  // namespace ostraka::tables
