#pragma once
#include <cstdio>
#include <string>

namespace ostraka::rendering {

/// A name of a file from a printf pattern with up to two whole numbers, as "cam%d_pos%02d.jpg".
inline std::string numbered(const char* pattern, int a, int b = 0) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, a, b);
  return text;
}

}  // namespace ostraka::rendering
