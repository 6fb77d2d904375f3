#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace ostraka {

/// The letters of a text by their numbers in Unicode.
std::vector<std::uint32_t> codePoints(const std::string& utf8);

/// A text in the encoding of PDF's built-in fonts; what they do not know becomes '?'.
std::string winAnsi(const std::string& utf8);

}  // namespace ostraka
