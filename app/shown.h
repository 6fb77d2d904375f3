#pragma once
#include <cstdio>
#include <string>
#include <string_view>

namespace ostraka::app {

/// Text as a terminal may show it: names from strangers can hold characters that clear the screen,
/// move the cursor or turn the direction of writing. Those become \xHH, byte by byte; line ends and
/// tabs stay. Bytes that are no UTF-8 stay, too.
std::string shown(std::string_view text);

/// What printf makes of it, as shown().
[[gnu::format(printf, 2, 3)]] void show(std::FILE* out, const char* format, ...);

}  // namespace ostraka::app
