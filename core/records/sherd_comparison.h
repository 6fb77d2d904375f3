#pragma once
#include <string>

#include "records/sherd.h"

namespace ostraka::records {

/// How two sherds stand to each other in one field.
enum class Agreement {
  Same,
  OneBlank,           ///< nothing is known of one of them
  WithinUncertainty,  ///< measured apart, but no farther than both uncertainties explain
  Differs,
};

/// Values of a field as texts (sherds::textOf). The order of several terms says nothing.
Agreement compareTexts(FieldKind kind, const std::string& a, const std::string& b);

/// Two measurements of one kind. A hundredth of the unit is less than anybody measures; above it
/// they differ where they lie farther apart than the root of the sum of the squares of their
/// uncertainties, which are taken as independent; one that states none adds none.
Agreement compareMeasurements(const Measurement& a, const Measurement& b);

}  // namespace ostraka::records
