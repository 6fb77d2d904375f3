#pragma once
#include <string>

namespace ostraka {

/// A text in the encoding of PDF's built-in fonts; what they do not know becomes '?'.
std::string winAnsi(const std::string& utf8);

}  // namespace ostraka
