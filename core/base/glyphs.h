#pragma once
#include <optional>
#include <string>

namespace ostraka {

/// A text as filled outlines, for paper whose own fonts do not have its letters.
struct GlyphPath {
  std::string operators;  ///< PDF path operators (m, l, c, h), y up, the letters' size 1
  double width = 0;       ///< of the whole text at that size
};

/// From the first of the computer's fonts that has all these letters (Greek, Armenian, Cyrillic,
/// Turkish and the like; letters stand side by side, so no script that joins or turns them).
/// Nothing where no font has them all, or there is no font.
std::optional<GlyphPath> glyphPath(const std::string& utf8, bool bold);

}  // namespace ostraka
