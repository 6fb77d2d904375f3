#pragma once
#include <QString>

#include "catalogue/sherd.h"

namespace ostraka::ui {

class TermWords;

/// What people call a field of a sherd, with its unit: "length, mm".
QString fieldLabel(const std::string& field);
/// A line of the filter with the fields' names as people call them put into those of the catalogue:
/// "Dicke>5" is "thickness>5" in a German window. Names in quotation marks, values and English
/// names stay as they are.
QString withFieldNames(const QString& filter);
/// A value as people read it: numbers in the language's form with a sensible number of digits.
QString fieldText(const catalogue::SherdRecord& sherd, const std::string& field,
                  const TermWords& words);
/// What people call a measure, with its unit, and its value in the language's form.
QString measureLabel(const std::string& kind);
QString measureText(double value);
/// A measure of the program whose batch has a doubtful scale; its text ends with a question mark.
bool isDoubtful(const catalogue::SherdRecord& sherd, const std::string& field);
QString stateLabel(catalogue::SherdState state);
/// How a value was measured: "by the program", "on a scale".
QString methodLabel(const std::string& method);
QString when(std::int64_t ms);  ///< day and time in the language's form

}  // namespace ostraka::ui
