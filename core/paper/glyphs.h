#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace ostraka {

/// A letter's outline. Thousandths of the letters' size, y up.
struct Glyph {
  std::string letter;       ///< UTF-8
  std::string font;         ///< which file it is from
  std::string operators;    ///< PDF path operators (m, l, c, h); none for a blank
  double advance = 0;       ///< to where the next letter begins
  Eigen::AlignedBox2d box;  ///< of the outline; empty for a blank
};

/// The letters of a text from this computer's fonts: from one font where one has them all (Latin,
/// Greek, Armenian, Cyrillic and the like; letters stand side by side, so no script that joins or
/// turns them). A letter that no font has becomes a question mark. Nothing where there is no font.
/// Any thread may call it.
std::optional<std::vector<Glyph>> glyphsOf(const std::string& utf8, bool bold);

}  // namespace ostraka
