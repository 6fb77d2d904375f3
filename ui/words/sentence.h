#pragma once
#include <QString>

#include "base/result.h"

namespace ostraka::ui {

/// What the core says, in the person's language. The core speaks English and knows no Qt; its
/// sentences are found again by their patterns (core_sentences.h), and so are those within them:
/// "depth.png: The file cannot be read.", or two after each other. What is not known stays as it
/// is.
QString wordsOf(const std::string& what);
/// What a person reads of an error: where, what, and what to do.
QString sentenceOf(const Error& error);

}  // namespace ostraka::ui
