#include <cstdio>

#include "base/glyphs.h"
#include "base/sheet.h"
#include "base/sheet_text.h"
#include "base/text.h"

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

// A page's content in mm with y down, and the pictures that it names.
class Content {
 public:
  Content(const Page& page, std::vector<const Picture*>& pictures) : pictures_(pictures) {
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
    if (!isWinAnsi(text.text))
      if (const auto drawn = glyphPath(text.text, text.weight == Weight::Bold)) {
        const double x = text.at.x() - shift * drawn->width * text.size_mm;
        out_ += "q 0 g " + fixed(text.size_mm, 4) + " 0 0 " + fixed(-text.size_mm, 4) + " " +
                fixed(x, 4) + " " + fixed(text.at.y(), 4) + " cm\n" + drawn->operators + "f Q\n";
        return;
      }
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
    for (const std::size_t offset : offsets_) {
      char entry[24];
      std::snprintf(entry, sizeof entry, "%010zu 00000 n \n", offset);
      out_ += entry;
    }
    out_ += "trailer\n<< /Size " + count + " /Root " + reference(catalog) + " /Info " +
            reference(information) + " >>\nstartxref\n" + std::to_string(table) + "\n%%EOF\n";
    return std::move(out_);
  }
  static std::string reference(int id) { return std::to_string(id) + " 0 R"; }

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
  const int plain = addFont(objects, "Helvetica"), bold = addFont(objects, "Helvetica-Bold");
  std::string kids;
  for (const Page& page : pages) {
    std::vector<const Picture*> pictures;
    const int content = objects.addStream("", Content(page, pictures).take());
    std::string named;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      const Picture& p = *pictures[i];
      const int id = objects.addStream(
          "/Type /XObject /Subtype /Image /ColorSpace /DeviceGray /BitsPerComponent 8 "
          "/Filter /DCTDecode /Width " +
              std::to_string(p.width_px) + " /Height " + std::to_string(p.height_px) + " ",
          p.jpeg);
      named += "/P" + std::to_string(i) + " " + Objects::reference(id) + " ";
    }
    const int id = objects.add("<< /Type /Page /Parent " + Objects::reference(tree) +
                               " /MediaBox [0 0 " + fixed(page.width_mm * kPointsPerMm, 4) + " " +
                               fixed(page.height_mm * kPointsPerMm, 4) + "] /Contents " +
                               Objects::reference(content) + " /Resources << /Font << /R " +
                               Objects::reference(plain) + " /B " + Objects::reference(bold) +
                               " >> /XObject << " + named + ">> >> >>");
    kids += Objects::reference(id) + " ";
  }
  objects.write(
      tree, "<< /Type /Pages /Count " + std::to_string(pages.size()) + " /Kids [ " + kids + "] >>");
  objects.write(catalog, "<< /Type /Catalog /Pages " + Objects::reference(tree) +
                             " /ViewerPreferences << /PrintScaling /None >> >>");
  const int information =
      objects.add("<< /Title (" + escaped(winAnsi(title)) + ") /Producer (Ostraka) >>");
  return objects.finish(catalog, information);
}

}  // namespace ostraka
