#include "paper/markup.h"

#include <openssl/evp.h>

#include "base/text.h"

namespace ostraka {

std::string markupText(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (const std::size_t bytes = forbiddenInXml(text, i); bytes > 0) {
      out += ' ';
      i += bytes - 1;
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
