#pragma once

#include <QPalette>

class QStyle;

namespace ostraka::ui {

/// The role of secondary text in the palettes of paletteOf: captions, what stands below a title.
inline constexpr QPalette::ColorRole kSecondaryText = QPalette::BrightText;

/// Flat controls of two heights with rounded edges that are seen in every theme; the caller owns
/// it.
QStyle* makeStyle();

}  // namespace ostraka::ui
