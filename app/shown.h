#pragma once
#include <cstdio>
#include <string>
#include <string_view>

namespace ostraka::app {

/// Text that is safe to print on a terminal. Names in files of others may contain characters that
/// clear the screen, move the cursor or reverse the direction of writing; each of their bytes is
/// printed as \xHH. Line ends and tabs stay, and so do bytes that are not valid UTF-8.
std::string shown(std::string_view text);
/// A name in a line or a table: its line ends and tabs are printed as \xHH, too.
std::string shownName(std::string_view name);

/// Prints as std::fprintf does, after shown().
[[gnu::format(printf, 2, 3)]] void show(std::FILE* out, const char* format, ...);

}  // namespace ostraka::app
