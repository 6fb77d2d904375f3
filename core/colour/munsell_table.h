#pragma once
#include <string_view>

namespace ostraka::colour {

/// resources/munsell/renotation.txt: a hue and a value a line, then x and y of chromas 2, 4, 6, …
std::string_view munsellTable();

}  // namespace ostraka::colour
