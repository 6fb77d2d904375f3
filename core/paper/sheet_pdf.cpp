#include <algorithm>
#include <map>

#include "base/text.h"
#include "paper/glyphs.h"
#include "paper/sheet.h"
#include "paper/sheet_text.h"

namespace ostraka {
namespace {

constexpr double kPointsPerMm = 72 / 25.4;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '(' || c == ')' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string reference(int id) {
  return std::to_string(id) + " 0 R";
}

std::string hex(unsigned value, int digits) {
  return formatted("%0*X", digits, value);
}

// Letters as PDF names them: in UTF-16 with the larger byte first.
std::string utf16(const std::string& utf8) {
  std::string out;
  for (const std::uint32_t code : codePoints(utf8)) {
    if (code < 0x10000)
      out += hex(code, 4);
    else
      out += hex(0xD800 + ((code - 0x10000) >> 10), 4) + hex(0xDC00 + (code & 0x3FF), 4);
  }
  return out;
}

// The letters that a document uses, in fonts of its own: no printer or publisher puts another font
// in their place. A font has at most 255 of them.
class Letters {
 public:
  struct Run {
    std::size_t font = 0;
    std::string codes;  ///< in hexadecimal digits
    double width = 0;   ///< of letters of size 1
  };
  std::vector<Run> runsOf(const std::vector<Glyph>& glyphs) {
    std::vector<Run> runs;
    for (const Glyph& glyph : glyphs) {
      const auto [at, fresh] =
          places_.try_emplace(std::pair(glyph.font, glyph.letter), glyphs_.size());
      if (fresh) glyphs_.push_back(glyph);
      const std::size_t font = at->second / kMost;
      if (runs.empty() || runs.back().font != font) runs.push_back({font, {}, 0});
      runs.back().codes += hex(static_cast<unsigned>(at->second % kMost) + 1, 2);
      runs.back().width += glyph.advance / kUnits;
    }
    return runs;
  }
  /// The fonts by their names, for the pages.
  template <class Objects>
  std::string write(Objects& objects) const {
    std::string named;
    for (std::size_t from = 0; from < glyphs_.size(); from += kMost)
      named += "/F" + std::to_string(from / kMost) + " " +
               reference(writeFont(objects, from, std::min(glyphs_.size(), from + kMost))) + " ";
    return named;
  }

 private:
  static constexpr std::size_t kMost = 255;
  static constexpr double kUnits = 1000;

  template <class Objects>
  int writeFont(Objects& objects, std::size_t from, std::size_t to) const {
    std::string procedures, names, widths, meanings;
    Eigen::AlignedBox2d all(Eigen::Vector2d(0, 0));
    for (std::size_t i = from; i < to; ++i) {
      const Glyph& glyph = glyphs_[i];
      Eigen::AlignedBox2d box = glyph.box;
      box.extend(Eigen::Vector2d(0, 0));
      all.extend(box);
      const std::string drawn = fixed(glyph.advance, 2) + " 0 " + boxText(box) + "d1\n" +
                                glyph.operators + (glyph.operators.empty() ? "" : "f");
      const std::string name = "/g" + std::to_string(i - from + 1) + " ";
      procedures += name + reference(objects.addStream("", drawn)) + " ";
      names += name;
      widths += fixed(glyph.advance, 2) + " ";
      // A list of meanings has 100 entries at most.
      if ((i - from) % 100 == 0)
        meanings += (i == from ? "" : "endbfchar\n") +
                    std::to_string(std::min<std::size_t>(100, to - i)) + " beginbfchar\n";
      meanings +=
          "<" + hex(static_cast<unsigned>(i - from) + 1, 2) + "> <" + utf16(glyph.letter) + ">\n";
    }
    const int unicode = objects.addStream(
        "",
        "/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap\n/CIDSystemInfo << "
        "/Registry (Adobe) /Ordering (UCS) /Supplement 0 >> def\n/CMapName /Letters def\n"
        "/CMapType 2 def\n1 begincodespacerange\n<00> <FF>\nendcodespacerange\n" +
            meanings +
            "endbfchar\nendcmap\nCMapName currentdict /CMap defineresource pop\nend\nend");
    return objects.add("<< /Type /Font /Subtype /Type3 /FontBBox [" + boxText(all) +
                       "] /FontMatrix [0.001 0 0 0.001 0 0] /FirstChar 1 /LastChar " +
                       std::to_string(to - from) + " /Widths [" + widths +
                       "] /Encoding << /Type /Encoding /Differences [1 " + names +
                       "] >> /CharProcs << " + procedures + ">> /Resources << >> /ToUnicode " +
                       reference(unicode) + " >>");
  }
  static std::string boxText(const Eigen::AlignedBox2d& box) {
    std::string out;
    for (const double side : {box.min().x(), box.min().y(), box.max().x(), box.max().y()})
      out += fixed(side, 2) + " ";
    return out;
  }

  std::map<std::pair<std::string, std::string>, std::size_t> places_;
  std::vector<Glyph> glyphs_;
};

// A page's content in mm with y down, and the pictures that it names.
class Content {
 public:
  Content(const Page& page, Letters& letters, std::vector<const Picture*>& pictures)
      : letters_(letters), pictures_(pictures) {
    // To points with y up: one matrix for all.
    out_ = fixed(kPointsPerMm, 4) + " 0 0 " + fixed(-kPointsPerMm, 4) + " 0 " +
           fixed(page.height_mm * kPointsPerMm, 4) + " cm 1 j\n";
    for (const Layer& layer : page.layers) {
      out_ += "q\n";
      if (layer.window) {
        const Eigen::Vector2d size = layer.window->sizes();
        out_ += fixed(layer.window->min().x(), 4) + " " + fixed(layer.window->min().y(), 4) + " " +
                fixed(size.x(), 4) + " " + fixed(size.y(), 4) + " re W n\n";
      }
      out_ += "1 0 0 1 " + fixed(layer.at.x(), 4) + " " + fixed(layer.at.y(), 4) + " cm\n";
      for (const auto& item : layer.sheet.items) std::visit(*this, item);
      out_ += "Q\n";
    }
  }
  std::string take() { return std::move(out_); }

  void operator()(const Shape& shape) {
    if (!shape.fill && !shape.stroke) return;
    if (shape.fill) out_ += fixed(*shape.fill, 4) + " g\n";
    if (shape.stroke) out_ += fixed(*shape.stroke, 4) + " G " + fixed(shape.stroke_mm, 4) + " w\n";
    out_ += shape.dash_mm > 0 ? "[" + fixed(shape.dash_mm, 4) + "] 0 d\n" : std::string("[] 0 d\n");
    for (const auto& line : shape.lines) {
      for (std::size_t i = 0; i < line.size(); ++i)
        out_ += fixed(line[i].x(), 4) + " " + fixed(line[i].y(), 4) + (i == 0 ? " m\n" : " l\n");
      if (shape.closed) out_ += "h\n";
    }
    out_ += shape.fill && shape.stroke ? "B*\n" : shape.fill ? "f*\n" : "S\n";
  }
  void operator()(const Text& text) {
    const double shift = text.anchor == Anchor::Left ? 0 : text.anchor == Anchor::Middle ? 0.5 : 1;
    if (const auto glyphs = glyphsOf(text.text, text.weight == Weight::Bold)) {
      double x = text.at.x() - shift * textWidth(text);
      for (const Letters::Run& run : letters_.runsOf(*glyphs)) {
        out_ += "0 g BT /F" + std::to_string(run.font) + " " + fixed(text.size_mm, 4) +
                " Tf 1 0 0 -1 " + fixed(x, 4) + " " + fixed(text.at.y(), 4) + " Tm <" + run.codes +
                "> Tj ET\n";
        x += run.width * text.size_mm;
      }
      return;
    }
    // A computer without any font: the reader's own take their place.
    out_ += std::string("0 g BT /") + (text.weight == Weight::Bold ? "B" : "R") + " " +
            fixed(text.size_mm, 4) + " Tf 1 0 0 -1 " +
            fixed(text.at.x() - shift * textWidth(text), 4) + " " + fixed(text.at.y(), 4) +
            " Tm (" + escaped(winAnsi(text.text)) + ") Tj ET\n";
  }
  void operator()(const Picture& picture) {
    pictures_.push_back(&picture);
    out_ += "q " + fixed(picture.size.x(), 4) + " 0 0 " + fixed(-picture.size.y(), 4) + " " +
            fixed(picture.corner.x(), 4) + " " + fixed(picture.corner.y() + picture.size.y(), 4) +
            " cm /P" + std::to_string(pictures_.size() - 1) + " Do Q\n";
  }

 private:
  Letters& letters_;
  std::vector<const Picture*>& pictures_;
  std::string out_;
};

// Numbered objects with the table of where they are.
class Objects {
 public:
  int reserve() {
    offsets_.push_back(0);
    return static_cast<int>(offsets_.size());
  }
  void write(int id, const std::string& body) {
    offsets_[static_cast<std::size_t>(id) - 1] = out_.size();
    out_ += std::to_string(id) + " 0 obj\n" + body + "\nendobj\n";
  }
  int add(const std::string& body) {
    const int id = reserve();
    write(id, body);
    return id;
  }
  int addStream(const std::string& dictionary, const std::string& bytes) {
    return add("<< " + dictionary + "/Length " + std::to_string(bytes.size()) + " >>\nstream\n" +
               bytes + "\nendstream");
  }
  std::string finish(int catalog, int information) {
    const std::size_t table = out_.size();
    const std::string count = std::to_string(offsets_.size() + 1);
    out_ += "xref\n0 " + count + "\n0000000000 65535 f \n";
    for (const std::size_t offset : offsets_) out_ += formatted("%010zu 00000 n \n", offset);
    out_ += "trailer\n<< /Size " + count + " /Root " + reference(catalog) + " /Info " +
            reference(information) + " >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
    return std::move(out_);
  }

 private:
  std::string out_ = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";
  std::vector<std::size_t> offsets_;
};

int addFont(Objects& objects, const char* name) {
  return objects.add(std::string("<< /Type /Font /Subtype /Type1 /BaseFont /") + name +
                     " /Encoding /WinAnsiEncoding >>");
}

}  // namespace

std::string formatPdf(const std::vector<Page>& pages, const std::string& title) {
  Objects objects;
  const int catalog = objects.reserve(), tree = objects.reserve();
  const int fonts = objects.reserve();
  Letters letters;
  std::string kids;
  for (const Page& page : pages) {
    std::vector<const Picture*> pictures;
    const int content = objects.addStream("", Content(page, letters, pictures).take());
    std::string named;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      const Picture& p = *pictures[i];
      const int id = objects.addStream(std::string("/Type /XObject /Subtype /Image /ColorSpace ") +
                                           (p.ink == Ink::Black ? "/DeviceGray" : "/DeviceRGB") +
                                           " /BitsPerComponent 8 /Filter /DCTDecode /Width " +
                                           std::to_string(p.width_px) + " /Height " +
                                           std::to_string(p.height_px) + " ",
                                       p.jpeg);
      named += "/P" + std::to_string(i) + " " + reference(id) + " ";
    }
    const int id = objects.add("<< /Type /Page /Parent " + reference(tree) + " /MediaBox [0 0 " +
                               fixed(page.width_mm * kPointsPerMm, 4) + " " +
                               fixed(page.height_mm * kPointsPerMm, 4) + "] /Contents " +
                               reference(content) + " /Resources << /Font " + reference(fonts) +
                               " /XObject << " + named + ">> >> >>");
    kids += reference(id) + " ";
  }
  std::string named = letters.write(objects);
  if (named.empty())
    named = "/R " + reference(addFont(objects, "Helvetica")) + " /B " +
            reference(addFont(objects, "Helvetica-Bold")) + " ";
  objects.write(fonts, "<< " + named + ">>");
  objects.write(
      tree, "<< /Type /Pages /Count " + std::to_string(pages.size()) + " /Kids [ " + kids + "] >>");
  objects.write(catalog, "<< /Type /Catalog /Pages " + reference(tree) +
                             " /ViewerPreferences << /PrintScaling /None >> >>");
  const int information =
      objects.add("<< /Title <FEFF" + utf16(title) + "> /Producer (Ostraka) >>");
  return objects.finish(catalog, information);
}

}  // namespace ostraka
