#include "store/names.h"

#include <unicode/normalizer2.h>
#include <unicode/uchar.h>
#include <unicode/unistr.h>
#include <unicode/utf16.h>
#include <unicode/utf8.h>

#include <algorithm>
#include <cctype>

namespace ostraka::store {
namespace {

icu::UnicodeString wide(std::string_view text) {
  return icu::UnicodeString::fromUTF8(text);
}

std::string narrow(const icu::UnicodeString& text) {
  std::string out;
  return text.toUTF8String(out);
}

icu::UnicodeString nfc(const icu::UnicodeString& text) {
  UErrorCode status = U_ZERO_ERROR;
  return icu::Normalizer2::getNFCInstance(status)->normalize(text, status);
}

bool isAscii(std::string_view text) {
  for (const char c : text)
    if (static_cast<unsigned char>(c) >= 0x80) return false;
  return true;
}

}  // namespace

std::string fromUtf16(std::u16string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    UChar32 letter = 0;
    U16_NEXT(text.data(), i, text.size(), letter);
    char bytes[U8_MAX_LENGTH];
    std::size_t size = 0;
    U8_APPEND_UNSAFE(bytes, size, letter);
    out.append(bytes, size);
  }
  return out;
}

std::string composed(std::string_view text) {
  return isAscii(text) ? std::string(text) : narrow(nfc(wide(text)));
}

std::string uniqueKey(std::string_view text) {
  if (isAscii(text)) {
    std::string key(text);
    for (char& c : key) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return key;
  }
  return narrow(nfc(nfc(wide(text)).foldCase()));
}

std::string codeKey(std::string_view text) {
  icu::UnicodeString key;
  const icu::UnicodeString letters = wide(uniqueKey(text));
  for (int32_t i = 0; i < letters.length(); ++i)
    if (!u_isUWhiteSpace(letters[i])) key += letters[i];
  return narrow(key);
}

std::string plainKey(std::string_view text) {
  UErrorCode status = U_ZERO_ERROR;
  const icu::Normalizer2* normalizer = icu::Normalizer2::getNFKDInstance(status);
  if (U_FAILURE(status)) return {};
  const icu::UnicodeString apart = normalizer->normalize(wide(uniqueKey(text)), status);
  icu::UnicodeString plain;
  for (int32_t i = 0; i < apart.length(); ++i) {
    const char16_t letter = apart[i];
    if (u_isalnum(letter) || U16_IS_SURROGATE(letter)) plain += letter == u'\u0131' ? u'i' : letter;
  }
  return narrow(plain);
}

namespace {

// A-1, A/1 and A – 1 are "A-1".
std::string withOneMark(std::string_view text) {
  icu::UnicodeString out;
  const icu::UnicodeString letters = wide(text);
  for (int32_t i = 0; i < letters.length(); ++i) {
    const char16_t letter = letters[i];
    if (u_isalnum(letter) || U16_IS_SURROGATE(letter) || (U_GET_GC_MASK(letter) & U_GC_M_MASK))
      out += letter;
    else if (out.isEmpty() || out[out.length() - 1] != u'-')
      out += u'-';
  }
  return narrow(out);
}

}  // namespace

std::string sortKey(std::string_view text) {
  // A run of digits is written with its length in front: longer runs are larger numbers.
  const std::string key = withOneMark(uniqueKey(text));
  std::string out;
  for (std::size_t i = 0; i < key.size();) {
    if (std::isdigit(static_cast<unsigned char>(key[i])) == 0) {
      out += key[i++];
      continue;
    }
    std::size_t end = i;
    while (end < key.size() && std::isdigit(static_cast<unsigned char>(key[end])) != 0) ++end;
    while (i + 1 < end && key[i] == '0') ++i;
    const std::string digits = key.substr(i, end - i);
    out += static_cast<char>('0' + std::min<std::size_t>(digits.size() / 10, 9));
    out += static_cast<char>('0' + digits.size() % 10);
    out += digits;
    i = end;
  }
  return out;
}

namespace {

std::string inPlainLetters(std::string_view text) {
  std::string out;
  for (const char c : composed(text)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 || c == '-' || c == '.' || byte >= 0x80;
    out += plain && !(c == '.' && out.empty()) ? c : '_';
  }
  return out.empty() ? "_" : out;
}

// Windows keeps these for devices.
bool isDevice(std::string_view name) {
  const std::string key = uniqueKey(name);
  if (key == "con" || key == "prn" || key == "aux" || key == "nul") return true;
  return key.size() == 4 && (key.starts_with("com") || key.starts_with("lpt")) &&
         std::isdigit(static_cast<unsigned char>(key[3])) != 0;
}

}  // namespace

std::string slug(std::string_view text) {
  std::string name = inPlainLetters(text);
  // Also with an ending: CON.txt is the console.
  const std::size_t stem = std::min(name.find('.'), name.size());
  if (isDevice(name.substr(0, stem))) name.insert(stem, "_");
  if (name.ends_with('.')) name += '_';
  return name;
}

bool isFolderName(std::string_view text) {
  return !text.empty() && inPlainLetters(text) == text;
}

bool hasInvisible(std::string_view text) {
  const icu::UnicodeString letters = wide(text);
  for (int32_t i = 0; i < letters.length(); ++i) {
    const char16_t c = letters[i];
    if ((c >= 0x200B && c <= 0x200F) || (c >= 0x202A && c <= 0x202E) ||
        (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF)
      return true;
  }
  return false;
}

std::string trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

}  // namespace ostraka::store
