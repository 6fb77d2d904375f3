#include "paper/glyphs.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>

#include <map>
#include <memory>
#include <mutex>
#include <utility>
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

std::string utf8Of(FcChar32 letter) {
  FcChar8 bytes[FC_UTF8_MAX_LEN];
  const int count = FcUcs4ToUtf8(letter, bytes);
  return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count)};
}

// Writes a letter's outline, in units of the font, as operators.
class PathWriter {
 public:
  PathWriter(double unit, std::string& out) : unit_(unit), out_(out) {}
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
    return fixed(p.x * unit_, 2) + " " + fixed(p.y * unit_, 2) + " ";
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

  double unit_;
  std::string& out_;
  Point now_;
  bool open_ = false;
};

// The computer's fonts and those of them that are open. Fontconfig and FreeType want one caller at
// a time.
class Fonts {
 public:
  static std::optional<std::vector<Glyph>> glyphsOf(const std::string& utf8, bool bold) {
    static std::mutex one;
    const std::scoped_lock lock(one);
    static Fonts fonts;  // read once for the whole run
    return fonts.find(lettersOf(utf8), bold);
  }

 private:
  struct Face {
    FT_Face face = nullptr;
    std::string path;
  };

  Fonts() : all_(FcInitLoadConfigAndFonts()) {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) == 0) library_.reset(library);
  }

  std::optional<std::vector<Glyph>> find(const std::vector<FcChar32>& letters, bool bold) {
    if (!all_ || !library_) return std::nullopt;
    std::vector<Glyph> glyphs;
    const Face* shared = faceWith(letters, bold);
    for (const FcChar32 letter : letters) {
      const Face* face = shared != nullptr ? shared : faceWith({letter}, bold);
      if (face == nullptr) face = faceWith({'?'}, bold);
      std::optional<Glyph> glyph;
      if (face != nullptr) glyph = glyphOf(*face, letter);
      if (!glyph && face != nullptr) glyph = glyphOf(*face, '?');
      if (!glyph) return std::nullopt;
      glyphs.push_back(std::move(*glyph));
    }
    return glyphs;
  }

  struct Found {
    const Face* face = nullptr;
    CharSet letters;
  };

  // Most texts are of letters that the usual font has; which one that is, no text decides.
  const Face* faceWith(const std::vector<FcChar32>& letters, bool bold) {
    const auto [usual, fresh] = usual_.try_emplace(bold);
    if (fresh) {
      std::vector<FcChar32> plain;
      for (FcChar32 letter = ' '; letter <= '~'; ++letter) plain.push_back(letter);
      usual->second = search(plain, bold);
    }
    if (usual->second.face != nullptr &&
        FcCharSetIsSubset(setOf(letters).get(), usual->second.letters.get()))
      return usual->second.face;
    return search(letters, bold).face;
  }

  static CharSet setOf(const std::vector<FcChar32>& letters) {
    CharSet set(FcCharSetCreate());
    for (const FcChar32 letter : letters) FcCharSetAddChar(set.get(), letter);
    return set;
  }

  Found search(const std::vector<FcChar32>& letters, bool bold) {
    const CharSet wanted = setOf(letters);
    const Pattern pattern(FcPatternCreate());
    for (const char* family : {"Helvetica", "sans-serif"})
      FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
    FcPatternAddInteger(pattern.get(), FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
    FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
    FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted.get());
    FcConfigSubstitute(all_.get(), pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultNoMatch;
    const FontSet sorted(FcFontSort(all_.get(), pattern.get(), FcFalse, nullptr, &result));
    for (int i = 0; sorted && i < sorted->nfont; ++i) {
      FcCharSet* own = nullptr;
      if (FcPatternGetCharSet(sorted->fonts[i], FC_CHARSET, 0, &own) != FcResultMatch ||
          !FcCharSetIsSubset(wanted.get(), own))
        continue;
      if (const Face* face = open(sorted->fonts[i])) return {face, CharSet(FcCharSetCopy(own))};
    }
    return {};
  }

  const Face* open(FcPattern* font) {
    FcChar8* path = nullptr;
    int index = 0;
    if (FcPatternGetString(font, FC_FILE, 0, &path) != FcResultMatch) return nullptr;
    FcPatternGetInteger(font, FC_INDEX, 0, &index);
    const std::string file = reinterpret_cast<const char*>(path);
    const auto [at, fresh] = faces_.try_emplace({file, index});
    if (fresh) {
      FT_Face face = nullptr;
      if (FT_New_Face(library_.get(), file.c_str(), index, &face) == 0)
        at->second = {face, file + " " + std::to_string(index)};
    }
    return at->second.face == nullptr ? nullptr : &at->second;
  }

  static std::optional<Glyph> glyphOf(const Face& from, FcChar32 letter) {
    constexpr double kSize = 1000;
    if (FT_Get_Char_Index(from.face, letter) == 0 ||
        FT_Load_Char(from.face, letter, FT_LOAD_NO_SCALE) != 0 ||
        from.face->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
      return std::nullopt;
    const double unit = kSize / from.face->units_per_EM;
    Glyph glyph{utf8Of(letter), from.path, {}, unit * double(from.face->glyph->advance.x), {}};
    FT_Outline& outline = from.face->glyph->outline;
    if (outline.n_points == 0) return glyph;
    if (!PathWriter(unit, glyph.operators).write(outline)) return std::nullopt;
    FT_BBox box;
    FT_Outline_Get_CBox(&outline, &box);
    glyph.box.extend(unit * Eigen::Vector2d(double(box.xMin), double(box.yMin)));
    glyph.box.extend(unit * Eigen::Vector2d(double(box.xMax), double(box.yMax)));
    return glyph;
  }

  std::unique_ptr<FcConfig, Freed<FcConfigDestroy>> all_;
  std::unique_ptr<FT_LibraryRec_, Freed<FT_Done_FreeType>> library_;  // closes its faces, too
  std::map<std::pair<std::string, int>, Face> faces_;
  std::map<bool, Found> usual_;
};

}  // namespace

std::optional<std::vector<Glyph>> glyphsOf(const std::string& utf8, bool bold) {
  return Fonts::glyphsOf(utf8, bold);
}

}  // namespace ostraka
