#include "paper/sheet.h"

#include <array>
#include <cmath>
#include <numbers>

#include "base/message.h"
#include "base/text.h"
#include "paper/glyphs.h"
#include "paper/markup.h"
#include "paper/sheet_text.h"

namespace ostraka {
namespace {

// Advance widths of Helvetica from the blank to the tilde, thousandths of the size.
constexpr std::array<int, 95> kWidths{
    278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,  // blank to /
    556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,  // 0 to ?
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,  // @ to O
    667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,  // P to _
    333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,  // ` to o
    556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};      // p to ~

int widthOf(unsigned char c) {
  if (c >= 32 && c < 127) return kWidths[c - 32u];
  if (c == 0xB0) return 400;  // degree
  if (c == 0xB1 || c == 0xD7) return 584;
  return c >= 0xC0 && c < 0xE0 ? 700 : 556;
}

std::string number(double value) {
  std::string out = fixed(value, 4);
  while (out.back() == '0') out.pop_back();
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string colour(const Grey& grey) {
  if (!grey) return "none";
  const int level = static_cast<int>(std::lround(255 * std::clamp(*grey, 0.0, 1.0)));
  return formatted("#%02x%02x%02x", level, level, level);
}

struct SvgItem {
  std::string operator()(const Shape& shape) const {
    std::string d;
    for (const auto& line : shape.lines) {
      for (std::size_t i = 0; i < line.size(); ++i)
        d += (i == 0 ? "M" : "L") + number(line[i].x()) + " " + number(line[i].y());
      if (shape.closed) d += "Z";
    }
    std::string out = "<path d=\"" + d + "\" fill=\"" + colour(shape.fill) + "\"";
    if (shape.fill) out += " fill-rule=\"evenodd\"";
    if (shape.stroke)
      out += " stroke=\"" + colour(shape.stroke) + "\" stroke-width=\"" + number(shape.stroke_mm) +
             "\" stroke-linejoin=\"round\"";
    if (shape.dash_mm > 0) out += " stroke-dasharray=\"" + number(shape.dash_mm) + "\"";
    return out + "/>\n";
  }
  std::string operator()(const Text& text) const {
    constexpr const char* kAnchors[] = {"start", "middle", "end"};
    return "<text x=\"" + number(text.at.x()) + "\" y=\"" + number(text.at.y()) +
           "\" font-size=\"" + number(text.size_mm) + "\" text-anchor=\"" +
           kAnchors[static_cast<int>(text.anchor)] + "\"" +
           (text.weight == Weight::Bold ? " font-weight=\"bold\"" : "") + ">" +
           markupText(text.text) + "</text>\n";
  }
  std::string operator()(const Picture& picture) const {
    return "<image x=\"" + number(picture.corner.x()) + "\" y=\"" + number(picture.corner.y()) +
           "\" width=\"" + number(picture.size.x()) + "\" height=\"" + number(picture.size.y()) +
           "\" preserveAspectRatio=\"none\" xlink:href=\"data:image/jpeg;base64," +
           base64(picture.jpeg) + "\"/>\n";
  }
};

}  // namespace

void Sheet::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double stroke_mm,
                 double dash_mm) {
  items.push_back(Shape{{{from, to}}, false, {}, 0.0, stroke_mm, dash_mm});
}

void Sheet::polygon(std::vector<Eigen::Vector2d> corners, Grey fill, Grey stroke,
                    double stroke_mm) {
  items.push_back(Shape{{std::move(corners)}, true, fill, stroke, stroke_mm, 0});
}

void Sheet::circle(const Eigen::Vector2d& centre, double radius_mm, Grey fill, Grey stroke,
                   double stroke_mm, double dash_mm) {
  // Chords that stray from the arc by 0.002 mm at most.
  const int count = std::max(24, static_cast<int>(std::numbers::pi * std::sqrt(radius_mm / 0.004)));
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * i / count;
    corners.push_back(centre + radius_mm * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
  }
  items.push_back(Shape{{std::move(corners)}, true, fill, stroke, stroke_mm, dash_mm});
}

void Sheet::text(const Eigen::Vector2d& at, double size_mm, std::string words, Anchor anchor,
                 Weight weight) {
  items.push_back(Text{at, size_mm, std::move(words), anchor, weight});
}

void Sheet::add(const Sheet& other, const Eigen::Vector2d& at) {
  for (auto item : other.items) {
    if (auto* shape = std::get_if<Shape>(&item)) {
      for (auto& line : shape->lines)
        for (Eigen::Vector2d& p : line) p += at;
    } else if (auto* text = std::get_if<Text>(&item)) {
      text->at += at;
    } else {
      std::get<Picture>(item).corner += at;
    }
    items.push_back(std::move(item));
  }
}

Eigen::Vector2d paperSize(Paper paper) {
  return paper == Paper::A4 ? Eigen::Vector2d(210, 297) : Eigen::Vector2d(297, 420);
}

std::vector<std::uint32_t> codePoints(const std::string& utf8) {
  std::vector<std::uint32_t> codes;
  for (std::size_t i = 0; i < utf8.size();) {
    const auto first = static_cast<unsigned char>(utf8[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    std::uint32_t code = length == 1 ? first : first & (0x7Fu >> length);
    for (std::size_t k = 1; k < length && i + k < utf8.size(); ++k)
      code = code << 6 | (static_cast<unsigned char>(utf8[i + k]) & 0x3F);
    i += length;
    codes.push_back(code);
  }
  return codes;
}

std::string winAnsi(const std::string& utf8) {
  // What WinAnsiEncoding puts where Latin-1 has control characters, as far as people type it.
  constexpr std::array<std::pair<std::uint32_t, unsigned char>, 9> kOthers{{{0x20AC, 0x80},
                                                                            {0x2026, 0x85},
                                                                            {0x2018, 0x91},
                                                                            {0x2019, 0x92},
                                                                            {0x201C, 0x93},
                                                                            {0x201D, 0x94},
                                                                            {0x2022, 0x95},
                                                                            {0x2013, 0x96},
                                                                            {0x2014, 0x97}}};
  std::string out;
  for (const std::uint32_t code : codePoints(utf8)) {
    char drawn = '?';
    if ((code >= 32 && code < 127) || (code >= 0xA0 && code < 0x100))
      drawn = static_cast<char>(code);
    for (const auto& [unicode, byte] : kOthers)
      if (code == unicode) drawn = static_cast<char>(byte);
    out += drawn;
  }
  return out;
}

double textWidth(const Text& text) {
  double sum = 0;
  if (const auto glyphs = glyphsOf(text.text, text.weight == Weight::Bold)) {
    for (const Glyph& glyph : *glyphs) sum += glyph.advance;
    return sum * text.size_mm / 1000;
  }
  for (const char c : winAnsi(text.text)) sum += widthOf(static_cast<unsigned char>(c));
  // Bold letters are wider by about a twentieth.
  return sum * text.size_mm / 1000 * (text.weight == Weight::Bold ? 1.05 : 1);
}

std::string formatSvg(const Page& page, const std::string& title) {
  const std::string width = number(page.width_mm), height = number(page.height_mm);
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"" +
      width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height +
      "\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n<title>" +
      markupText(title) + "</title>\n<rect width=\"" + width + "\" height=\"" + height +
      "\" fill=\"#ffffff\"/>\n";
  int windows = 0;
  for (const Layer& layer : page.layers) {
    std::string clip;
    if (layer.window) {
      const std::string name = "window" + std::to_string(windows++);
      const Eigen::Vector2d size = layer.window->sizes();
      out += "<clipPath id=\"" + name + "\"><rect x=\"" + number(layer.window->min().x()) +
             "\" y=\"" + number(layer.window->min().y()) + "\" width=\"" + number(size.x()) +
             "\" height=\"" + number(size.y()) + "\"/></clipPath>\n";
      clip = " clip-path=\"url(#" + name + ")\"";
    }
    out += "<g" + clip + "><g transform=\"translate(" + number(layer.at.x()) + " " +
           number(layer.at.y()) + ")\">\n";
    for (const auto& item : layer.sheet.items) out += std::visit(SvgItem{}, item);
    out += "</g></g>\n";
  }
  return out + "</svg>\n";
}

}  // namespace ostraka
