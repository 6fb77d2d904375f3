#include "base/glyphs.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>

#include <memory>
#include <mutex>
#include <vector>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "base/text.h"

namespace ostraka {
namespace {

template <auto Free>
struct Freed {
  template <class T>
  void operator()(T* object) const {
    Free(object);
  }
};
using Pattern = std::unique_ptr<FcPattern, Freed<FcPatternDestroy>>;
using CharSet = std::unique_ptr<FcCharSet, Freed<FcCharSetDestroy>>;
using FontSet = std::unique_ptr<FcFontSet, Freed<FcFontSetDestroy>>;

struct FontFile {
  std::string path;
  int face = 0;
};

std::vector<FcChar32> lettersOf(const std::string& utf8) {
  std::vector<FcChar32> letters;
  const auto* at = reinterpret_cast<const FcChar8*>(utf8.data());
  for (int left = static_cast<int>(utf8.size()); left > 0;) {
    FcChar32 letter = 0;
    const int bytes = FcUtf8ToUcs4(at, &letter, left);
    if (bytes <= 0) break;
    letters.push_back(letter);
    at += bytes;
    left -= bytes;
  }
  return letters;
}

std::optional<FontFile> fontWith(const std::vector<FcChar32>& letters, bool bold) {
  static FcConfig* fonts = FcInitLoadConfigAndFonts();  // read once for the whole run
  if (fonts == nullptr) return std::nullopt;
  const CharSet wanted(FcCharSetCreate());
  for (const FcChar32 letter : letters) FcCharSetAddChar(wanted.get(), letter);
  const Pattern pattern(FcPatternCreate());
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted.get());
  FcConfigSubstitute(fonts, pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultNoMatch;
  const FontSet sorted(FcFontSort(fonts, pattern.get(), FcFalse, nullptr, &result));
  if (!sorted) return std::nullopt;
  for (int i = 0; i < sorted->nfont; ++i) {
    FcPattern* font = sorted->fonts[i];
    FcCharSet* has = nullptr;
    FcChar8* path = nullptr;
    int face = 0;
    if (FcPatternGetCharSet(font, FC_CHARSET, 0, &has) != FcResultMatch ||
        FcPatternGetString(font, FC_FILE, 0, &path) != FcResultMatch ||
        !FcCharSetIsSubset(wanted.get(), has))
      continue;
    FcPatternGetInteger(font, FC_INDEX, 0, &face);
    return FontFile{reinterpret_cast<const char*>(path), face};
  }
  return std::nullopt;
}

// Writes a letter's outline, in units of the font, as operators at its place in the line.
class PathWriter {
 public:
  PathWriter(double unit, double x, std::string& out) : unit_(unit), x_(x), out_(out) {}
  bool write(FT_Outline& outline) {
    FT_Outline_Funcs hooks{};
    hooks.move_to = [](const FT_Vector* to, void* me) { return of(me).begin(*to); };
    hooks.line_to = [](const FT_Vector* to, void* me) { return of(me).line(*to); };
    hooks.conic_to = [](const FT_Vector* c, const FT_Vector* to, void* me) {
      return of(me).conic(*c, *to);
    };
    hooks.cubic_to = [](const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* me) {
      return of(me).cubic({double(a->x), double(a->y)}, {double(b->x), double(b->y)}, *to);
    };
    if (FT_Outline_Decompose(&outline, &hooks, this) != 0) return false;
    if (open_) out_ += "h\n";
    return true;
  }

 private:
  struct Point {
    double x = 0, y = 0;
  };
  static PathWriter& of(void* me) { return *static_cast<PathWriter*>(me); }
  std::string text(const Point& p) const {
    return fixed(x_ + p.x * unit_, 5) + " " + fixed(p.y * unit_, 5) + " ";
  }
  int begin(const FT_Vector& to) {
    out_ += (open_ ? "h\n" : "") + text(at(to)) + "m\n";
    open_ = true;
    return 0;
  }
  int line(const FT_Vector& to) {
    out_ += text(at(to)) + "l\n";
    return 0;
  }
  int conic(const FT_Vector& c, const FT_Vector& to) {
    const auto third = [&](const Point& end) {
      return Point{(end.x + 2 * double(c.x)) / 3, (end.y + 2 * double(c.y)) / 3};
    };
    const Point first = third(now_);
    return cubic(first, third({double(to.x), double(to.y)}), to);
  }
  int cubic(const Point& a, const Point& b, const FT_Vector& to) {
    out_ += text(a) + text(b) + text(at(to)) + "c\n";
    return 0;
  }
  const Point& at(const FT_Vector& to) { return now_ = {double(to.x), double(to.y)}; }

  double unit_, x_;
  std::string& out_;
  Point now_;
  bool open_ = false;
};

}  // namespace

std::optional<GlyphPath> glyphPath(const std::string& utf8, bool bold) {
  static std::mutex one;  // both libraries want one caller at a time
  const std::scoped_lock lock(one);
  const std::vector<FcChar32> letters = lettersOf(utf8);
  const std::optional<FontFile> font = fontWith(letters, bold);
  if (!font) return std::nullopt;
  FT_Library raw_library = nullptr;
  if (FT_Init_FreeType(&raw_library) != 0) return std::nullopt;
  const std::unique_ptr<FT_LibraryRec_, Freed<FT_Done_FreeType>> library(raw_library);
  FT_Face raw_face = nullptr;
  if (FT_New_Face(raw_library, font->path.c_str(), font->face, &raw_face) != 0) return std::nullopt;
  const std::unique_ptr<FT_FaceRec_, Freed<FT_Done_Face>> face(raw_face);
  GlyphPath path;
  const double unit = 1.0 / face->units_per_EM;
  for (const FcChar32 letter : letters) {
    if (FT_Load_Char(face.get(), letter, FT_LOAD_NO_SCALE) != 0 ||
        face->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
      return std::nullopt;
    if (!PathWriter(unit, path.width, path.operators).write(face->glyph->outline))
      return std::nullopt;
    path.width += unit * static_cast<double>(face->glyph->advance.x);
  }
  return path;
}

}  // namespace ostraka
