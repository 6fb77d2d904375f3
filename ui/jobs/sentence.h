#pragma once
#include <QString>

#include "base/result.h"

namespace ostraka::ui {

/// What a person reads of an error: where, what, and what to do.
inline QString sentenceOf(const Error& error) {
  return QString::fromStdString(error.sentence());
}

}  // namespace ostraka::ui
