#pragma once
#include <string>

namespace ostraka::records {

/// The unit of a measurement by its kind or by its field: mm of length and of length_mm.
std::string unitOfMeasure(const std::string& kind_or_field);

/// How many decimals of a measurement people read, whoever measured it and wherever it stands:
/// tenths of a millimetre and of a gram, whole mm2, mm3 and %. Files of data keep every digit.
int decimalsShown(const std::string& unit);
/// Rounded to them, halves away from zero; never -0.
double shownValue(double value, const std::string& unit);
/// A 95 % uncertainty beside such a value: at least one in its last place.
double shownUncertainty(double uncertainty, const std::string& unit);
/// Those of a number that can be edited: as it was typed, where that is more; a computed one has a
/// double's fifteen digits, and as many as are read.
int decimalsEdited(double value, const std::string& unit);

}  // namespace ostraka::records
