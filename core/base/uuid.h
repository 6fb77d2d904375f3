#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace ostraka {

/// UUID, version 7 (RFC 9562): 48 bits of time (milliseconds UTC), then chance.
std::string newId(std::int64_t now_ms);
bool isUuid(std::string_view text);

}  // namespace ostraka
