#include "base/uuid.h"

#include <array>
#include <cctype>
#include <random>

#include "base/text.h"

namespace ostraka {

std::string newId(std::int64_t now_ms) {
  thread_local std::random_device device;
  std::array<unsigned char, 16> bytes;
  for (std::size_t i = 0; i < 6; ++i)
    bytes[i] = static_cast<unsigned char>(now_ms >> (8 * (5 - static_cast<int>(i))));
  for (std::size_t i = 6; i < 16; i += 2) {
    const unsigned chance = device();
    bytes[i] = static_cast<unsigned char>(chance);
    bytes[i + 1] = static_cast<unsigned char>(chance >> 8);
  }
  bytes[6] = static_cast<unsigned char>(0x70 | (bytes[6] & 0x0F));
  bytes[8] = static_cast<unsigned char>(0x80 | (bytes[8] & 0x3F));
  std::string text = hexadecimal(bytes);
  for (const std::size_t at : {8, 13, 18, 23}) text.insert(at, 1, '-');
  return text;
}

bool isUuid(std::string_view text) {
  if (text.size() != 36) return false;
  for (std::size_t i = 0; i < 36; ++i) {
    const bool dash = i == 8 || i == 13 || i == 18 || i == 23;
    if (dash ? text[i] != '-' : std::isxdigit(static_cast<unsigned char>(text[i])) == 0)
      return false;
  }
  return true;
}

}  // namespace ostraka
