#pragma once
#include <string>
#include <string_view>

namespace ostraka {

/// Text as it may stand in XML or HTML, in attributes too; control characters and
/// what else XML forbids become blanks, each byte that is of no character of UTF-8 becomes U+FFFD.
std::string markupText(std::string_view text);

/// Bytes as base64 (RFC 4648, section 4), with padding and without line breaks.
std::string base64(std::string_view bytes);

}  // namespace ostraka
