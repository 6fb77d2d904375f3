#pragma once
#include <utility>

#include "paper/sheet.h"

namespace ostraka {

/// 100 by 50 mm, the sheet's origin at (10, 5).
inline Page pageWith(Sheet sheet) {
  return {100, 50, {{std::move(sheet), {10, 5}, {}}}};
}

}  // namespace ostraka
