#pragma once

class QStyle;

namespace ostraka::ui {

/// Flat controls of two heights with rounded edges that are seen in every theme; the caller owns
/// it.
QStyle* makeStyle();

}  // namespace ostraka::ui
