#include "shown.h"

#include <cstdarg>

#include "base/text.h"

namespace ostraka::app {
namespace {

// How many bytes of a character that a terminal acts on stand there; 0: none.
std::size_t controlAt(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned a = byte(0), b = byte(1), c = byte(2);
  if ((a < 0x20 && a != '\n' && a != '\t') || a == 0x7F) return 1;
  if (a == 0xC2 && b >= 0x80 && b < 0xA0) return 2;  // U+0080 to U+009F
  // U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069: directions
  if (a == 0xE2 && b == 0x80 && (c == 0x8E || c == 0x8F || (c >= 0xAA && c <= 0xAE))) return 3;
  if (a == 0xE2 && b == 0x81 && c >= 0xA6 && c <= 0xA9) return 3;
  return 0;
}

std::string spelt(char c) {
  constexpr const char* kDigits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
}

}  // namespace

std::string shown(std::string_view text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t control = controlAt(text.substr(i));
    if (control == 0) safe += text[i++];
    for (const std::size_t end = i + control; control > 0 && i < end; ++i) safe += spelt(text[i]);
  }
  return safe;
}

std::string shownName(std::string_view name) {
  std::string safe;
  for (const char c : shown(name)) safe += c == '\n' || c == '\t' ? spelt(c) : std::string(1, c);
  return safe;
}

void show(std::FILE* out, const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::fputs(shown(vformatted(format, arguments)).c_str(), out);
  va_end(arguments);
}

}  // namespace ostraka::app
