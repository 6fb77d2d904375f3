#pragma once
#include "drawing/drawing.h"

namespace ostraka::drawing {

/// Number, mouth and measures below what is drawn; the box grows by them. Long lines are
/// broken at the drawing's width, so that they need no more room on a plate.
void addCaption(SherdDrawing& drawing, const Wording& wording);

}  // namespace ostraka::drawing
