#pragma once
#include <optional>
#include <string>
#include <utility>

#include "catalogue/catalogue.h"

namespace ostraka::catalogue {

/// Writes a value in one transaction and returns what stood there before. expected: what has to
/// stand there still, else nothing is written (Error::changedMeanwhile with `field`); none:
/// anything.
template <class Value, class Read, class Write>
Result<Value> replaceValue(Catalogue& catalogue, const std::string& field,
                           const std::optional<Value>& expected, const Value& value,
                           const Read& read, const Write& write) {
  std::optional<Value> before;
  const Result<void> done = catalogue.together([&]() -> Result<void> {
    Result<Value> now = read();
    if (!now) return now.error();
    if (expected && !(*now == *expected)) return Error::changedMeanwhile(field);
    before = std::move(*now);
    return write(value);
  });
  if (!done) return done.error();
  return std::move(*before);
}

}  // namespace ostraka::catalogue
