#pragma once
#include <functional>
#include <string>

#include "base/message.h"

namespace ostraka::drawing {

/// How the texts of a sheet are said; as it is, in English.
struct Wording {
  /// An English sentence or phrase in the reader's language; none: as it is. Any thread may call
  /// it.
  std::function<std::string(const Message& english)> translated;
  std::string decimal = ".";

  std::string said(const Message& english) const;
  std::string number(double value, int decimals) const;
  /// Four digits at most, and no noughts at the end.
  std::string shortNumber(double value) const;
};

}  // namespace ostraka::drawing
