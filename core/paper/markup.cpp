#include "paper/markup.h"

#include <openssl/evp.h>

#include <algorithm>

#include "base/text.h"

namespace ostraka {
namespace {

// Of the character of UTF-8 at `at`; 0 where there is none.
std::size_t characterBytes(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t bytes = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  return bytes == 1 || isUtf8(text.substr(at, bytes)) ? bytes : 0;
}

}  // namespace

std::string markupText(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (const std::size_t bytes = forbiddenInXml(text, i); bytes > 0) {
      out += ' ';
      i += bytes - 1;
      continue;
    }
    const std::size_t bytes = characterBytes(text, i);
    if (bytes != 1) {
      out += bytes == 0 ? "\uFFFD" : text.substr(i, bytes);
      i += std::max<std::size_t>(bytes, 1) - 1;
      continue;
    }
    switch (text[i]) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(text[i]) < 32 ? ' ' : text[i];
    }
  }
  return out;
}

std::string base64(std::string_view bytes) {
  // OpenSSL writes a closing zero as well.
  std::string out((bytes.size() + 2) / 3 * 4 + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(out.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  out.resize(static_cast<std::size_t>(length));
  return out;
}

}  // namespace ostraka
