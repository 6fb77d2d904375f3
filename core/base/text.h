#pragma once
#include <charconv>
#include <cstdarg>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace ostraka {

/// A number with this many digits after the decimal point, independent of the locale.
/// digits: 0 to 80.
std::string fixed(double value, int digits);
/// Of a share, 0 to 1: rounded down, so that what is not certain never reads as 100 %.
int wholePercent(double share);

/// As printf writes it, but with a decimal point in every locale.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);
/// The same for arguments that are passed on.
[[gnu::format(printf, 1, 0)]] std::string vformatted(const char* format, std::va_list arguments);

/// The number that the whole text is, with a decimal point in every locale.
template <class Number>
std::optional<Number> wholeText(std::string_view text) {
  Number value{};
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// A to Z as a to z; other characters, those of UTF-8 too, stay as they are.
std::string lowerCase(std::string text);

/// Two small letters or digits for each byte.
std::string hexadecimal(std::span<const unsigned char> bytes);

/// The bytes of the character at `at` of a text in UTF-8 if XML 1.0 forbids it, else 0: control
/// characters other than tab and line ends, U+FFFE, U+FFFF and halves of surrogate pairs.
std::size_t forbiddenInXml(std::string_view text, std::size_t at);

bool isUtf8(std::string_view text);  ///< well formed, and without NUL

/// Whether a text can be stored and written into any document: UTF-8, without what XML forbids, of
/// at most limits::kValueBytes. Errors: UnusableInput, with a sentence for whoever wrote it.
Result<void> checkText(std::string_view text);

std::string joined(std::span<const std::string> words, const char* between);

/// This moment, as 2026-03-01T12:00:00Z.
std::string utcNow();

/// The day of a moment, as 2026-03-01, in UTC. ms: since 1970.
std::string utcDay(std::int64_t ms);

}  // namespace ostraka
