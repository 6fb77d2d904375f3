#include "drawing/wording.h"

#include <cstdio>

namespace ostraka::drawing {
namespace {

std::string withDecimal(std::string number, const std::string& decimal) {
  if (const std::size_t at = number.find('.'); at != std::string::npos)
    number.replace(at, 1, decimal);
  return number;
}

}  // namespace

std::string Wording::said(const std::string& english) const {
  return translated ? translated(english) : english;
}

std::string Wording::number(double value, int decimals) const {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return withDecimal(text, decimal);
}

std::string Wording::shortNumber(double value) const {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g", value);
  return withDecimal(text, decimal);
}

}  // namespace ostraka::drawing
