#pragma once
#include <optional>

namespace ostraka::records {

/// How many decimals of a measurement people read. A number that a person typed has few, and is
/// shown as it was typed. A computed one has a double's fifteen digits, of which its uncertainty
/// bears those up to its own first one (its second after a 1); without an uncertainty `usual`
/// count, and none from 1000 on.
int decimalsShown(double value, const std::optional<double>& uncertainty, int usual);

}  // namespace ostraka::records
