#include "store/names.h"

#include <unicode/uchar.h>
#include <unicode/unorm2.h>
#include <unicode/ustring.h>

#include <algorithm>
#include <cctype>

namespace ostraka::store {
namespace {

std::u16string wide(std::string_view text) {
  std::u16string out(text.size() + 1, u'\0');
  int32_t length = 0;
  UErrorCode status = U_ZERO_ERROR;
  u_strFromUTF8WithSub(out.data(), static_cast<int32_t>(out.size()), &length, text.data(),
                       static_cast<int32_t>(text.size()), 0xFFFD, nullptr, &status);
  out.resize(static_cast<std::size_t>(length));
  return out;
}

std::string narrow(const std::u16string& text) {
  std::string out(text.size() * 3 + 1, '\0');
  int32_t length = 0;
  UErrorCode status = U_ZERO_ERROR;
  u_strToUTF8(out.data(), static_cast<int32_t>(out.size()), &length, text.data(),
              static_cast<int32_t>(text.size()), &status);
  out.resize(static_cast<std::size_t>(length));
  return out;
}

std::u16string nfc(const std::u16string& text) {
  UErrorCode status = U_ZERO_ERROR;
  const UNormalizer2* normalizer = unorm2_getNFCInstance(&status);
  std::u16string out(text.size() * 3 + 16, u'\0');  // 3: the most that NFC expands UTF-16 by
  const int32_t length =
      unorm2_normalize(normalizer, text.data(), static_cast<int32_t>(text.size()), out.data(),
                       static_cast<int32_t>(out.size()), &status);
  if (U_FAILURE(status)) return text;
  out.resize(static_cast<std::size_t>(length));
  return out;
}

bool isAscii(std::string_view text) {
  for (const char c : text)
    if (static_cast<unsigned char>(c) >= 0x80) return false;
  return true;
}

}  // namespace

bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == 0) return false;
    const std::size_t more = c < 0x80   ? 0
                             : c < 0xC2 ? 9
                             : c < 0xE0 ? 1
                             : c < 0xF0 ? 2
                             : c < 0xF5 ? 3
                                        : 9;
    if (more == 9 || i + more >= text.size()) return false;
    unsigned code = more == 0 ? c : c & (0x3Fu >> more);
    for (std::size_t k = 1; k <= more; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      if ((next & 0xC0) != 0x80) return false;
      code = code << 6 | (next & 0x3F);
    }
    if ((more == 2 && code < 0x800) || (more == 3 && (code < 0x10000 || code > 0x10FFFF)) ||
        (code >= 0xD800 && code <= 0xDFFF))
      return false;
    i += more + 1;
  }
  return true;
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
  const std::u16string letters = nfc(wide(text));
  std::u16string folded(letters.size() * 3 + 1, u'\0');
  UErrorCode status = U_ZERO_ERROR;
  const int32_t length =
      u_strFoldCase(folded.data(), static_cast<int32_t>(folded.size()), letters.data(),
                    static_cast<int32_t>(letters.size()), U_FOLD_CASE_DEFAULT, &status);
  folded.resize(static_cast<std::size_t>(length));
  return narrow(nfc(folded));
}

std::string plainKey(std::string_view text) {
  const std::u16string letters = wide(uniqueKey(text));
  UErrorCode status = U_ZERO_ERROR;
  const UNormalizer2* normalizer = unorm2_getNFKDInstance(&status);
  std::u16string apart(letters.size() * 18 + 16, u'\0');  // 18: the most that NFKD expands by
  const int32_t length =
      unorm2_normalize(normalizer, letters.data(), static_cast<int32_t>(letters.size()),
                       apart.data(), static_cast<int32_t>(apart.size()), &status);
  if (U_FAILURE(status)) return {};
  std::u16string plain;
  for (int32_t i = 0; i < length; ++i) {
    const char16_t letter = apart[static_cast<std::size_t>(i)];
    if (u_isalnum(letter) || U16_IS_SURROGATE(letter)) plain += letter == u'\u0131' ? u'i' : letter;
  }
  return narrow(plain);
}

std::string sortKey(std::string_view text) {
  // A run of digits is written with its length in front: longer runs are larger numbers.
  const std::string key = uniqueKey(text);
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
  for (const char16_t c : wide(text))
    if ((c >= 0x200B && c <= 0x200F) || (c >= 0x202A && c <= 0x202E) ||
        (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF)
      return true;
  return false;
}

std::string trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

}  // namespace ostraka::store
