#pragma once
#include <QString>

#include "base/result.h"

namespace ostraka::ui {

/// What the core says, in the person's language where that sentence is translated.
QString wordsOf(const std::string& what);
/// What a person reads of an error: where, what, and what to do.
QString sentenceOf(const Error& error);

}  // namespace ostraka::ui
