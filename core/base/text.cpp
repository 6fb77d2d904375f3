#include "base/text.h"

#include <locale.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <ctime>

#include "base/limits.h"
#include "base/message.h"

namespace ostraka {
namespace {

std::string utcText(std::time_t seconds, const char* form) {
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, form, &parts)};
}

// Of the character at `at` of a text in UTF-8; 0 where there is none (RFC 3629).
std::size_t bytesOfCharacter(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const unsigned first = byte(at), second = byte(at + 1);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4) return 0;
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool half_of_pair = first == 0xED && second >= 0xA0;
  const bool beyond_unicode = first == 0xF4 && second >= 0x90;
  if (overlong || half_of_pair || beyond_unicode) return 0;
  const std::size_t bytes = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (std::size_t i = 1; i < bytes; ++i)
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  return bytes;
}

}  // namespace

std::string fixed(double value, int digits) {
  char text[400];  // the largest double has 309 digits before the point
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits).ptr;
  return {text, end};
}

int wholePercent(double share) {
  return static_cast<int>(std::floor(std::clamp(share, 0.0, 1.0) * 100 + 1e-9));
}

std::string formatted(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::string text = vformatted(format, arguments);
  va_end(arguments);
  return text;
}

std::string vformatted(const char* format, std::va_list arguments) {
  static const locale_t plain = ::newlocale(LC_ALL_MASK, "C", nullptr);
  const locale_t before = ::uselocale(plain);  // of this thread alone
  std::va_list again;
  va_copy(again, arguments);
  const int length = std::max(0, std::vsnprintf(nullptr, 0, format, arguments));
  std::string text(static_cast<std::size_t>(length), ' ');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  ::uselocale(before);
  return text;
}

std::string lowerCase(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::string hexadecimal(std::span<const unsigned char> bytes) {
  std::string text;
  for (const unsigned char byte : bytes) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

std::size_t forbiddenInXml(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  if (byte(at) < 0x20) return text[at] == '\t' || text[at] == '\n' || text[at] == '\r' ? 0 : 1;
  const bool no_character = byte(at) == 0xEF && byte(at + 1) == 0xBF && byte(at + 2) >= 0xBE;
  const bool half_of_pair = byte(at) == 0xED && byte(at + 1) >= 0xA0;
  return no_character || half_of_pair ? std::min<std::size_t>(3, text.size() - at) : 0;
}

bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t bytes = bytesOfCharacter(text, i);
    if (bytes == 0 || text[i] == '\0') return false;
    i += bytes;
  }
  return true;
}

Result<void> checkText(std::string_view text) {
  if (text.size() > limits::kValueBytes.most)
    return Error::unusable(message("The text is longer than 1 MB."));
  if (!isUtf8(text))
    return Error::unusable(message("The text is not valid UTF-8 or contains a zero byte."));
  for (std::size_t i = 0; i < text.size(); ++i)
    if (forbiddenInXml(text, i) > 0)
      return Error::unusable(message(
          "The text contains control characters, which documents cannot contain; type it again."));
  return {};
}

std::string joined(std::span<const std::string> words, const char* between) {
  std::string text;
  for (const std::string& word : words) {
    if (&word != words.data()) text += between;
    text += word;
  }
  return text;
}

std::string utcNow() {
  return utcText(std::time(nullptr), "%Y-%m-%dT%H:%M:%SZ");
}

std::string utcDay(std::int64_t ms) {
  return utcText(static_cast<std::time_t>(ms / 1000), "%Y-%m-%d");
}

Decimal shortDecimal(double value, int most_digits) {
  int digits = most_digits;
  double last = std::round(value * std::pow(10.0, most_digits));
  for (; digits > 0 && std::fmod(last, 10) == 0; --digits) last /= 10;
  return {value, digits};
}

}  // namespace ostraka
