#pragma once
#include "drawing/wording.h"

namespace ostraka::ui {

/// Sheets for print in the window's language and with its decimal sign, as both are now.
drawing::Wording printWording();

}  // namespace ostraka::ui
