#include "drawing/wording.h"

#include "base/text.h"

namespace ostraka::drawing {
namespace {

std::string withDecimal(std::string number, const std::string& decimal) {
  if (const std::size_t at = number.find('.'); at != std::string::npos)
    number.replace(at, 1, decimal);
  return number;
}

}  // namespace

std::string Wording::said(const Message& english) const {
  return translated ? translated(english) : english.english();
}

std::string Wording::number(double value, int decimals) const {
  return withDecimal(fixed(value, decimals), decimal);
}

std::string Wording::shortNumber(double value) const {
  return withDecimal(formatted("%.4g", value), decimal);
}

}  // namespace ostraka::drawing
