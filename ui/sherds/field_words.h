#pragma once
#include <QString>

#include "intake/sherd_moves.h"
#include "records/sherd.h"
#include "sherds/filter.h"

namespace ostraka::ui {

class TermWords;

/// What people call a field of a sherd, with its unit: "length, mm"; one of their own by its name.
QString fieldLabel(const std::string& field);
bool isNumber(const std::string& field);
/// A line of the filter with the fields' names as people call them put into those of the catalogue:
/// "Dicke>5" is "thickness>5" in a German window, and so are the names that the import of tables
/// takes, in every language. Names in quotation marks, values and English
/// names stay as they are.
QString withFieldNames(const QString& filter);
/// A value as people read it: numbers in the language's form with a sensible number of digits.
QString fieldText(const records::SherdRecord& sherd, const std::string& field,
                  const TermWords& words);
/// A value as it stands in the line where it is typed: a number has the language's decimal mark, no
/// blanks, and not a computed length's fifteen digits.
QString typedText(const records::SherdField& field, const std::string& text);
/// Why a typed value is refused: 1,250 is 1.25 to one, 1250 to whose language it has thousands so.
/// Empty: it reads in one way, or the field holds no number.
QString inTwoWays(const std::string& field, const QString& typed);
/// What sherds leave behind that are moved to another context, in sentences; empty: nothing.
QString leftBehindWords(const intake::Move& move);
/// A condition of the filter with its field's name as people call it.
QString conditionText(const sherds::Condition& condition);
/// What people call a measure, with its unit, and its value in the language's form.
QString measureLabel(const std::string& kind);
/// With the decimals of records::decimalsShown.
QString measureText(double value, const std::string& unit);
/// As it was typed, for what tells two values apart.
QString enteredText(double value, const std::string& unit);
QString measuredText(const records::Measurement& measurement);  ///< with its uncertainty
/// A measure of the program whose batch has a doubtful scale; its text ends with a question mark.
bool isDoubtful(const records::SherdRecord& sherd, const std::string& field);
/// A measurement by hand that stands in place of another, computed one; null: it does not.
const double* computedBeside(const records::SherdRecord& sherd, const std::string& field);
/// What speaks against a measurement, in sentences, and the act that saves it all the same.
QString questionWords(const std::vector<records::MeasureFinding>& findings);
QString confirmWords(const std::vector<records::MeasureFinding>& findings);
/// Its number, or what stands on its batch's map and in the review before it has one: "sherd 3 of
/// B0004".
QString sherdName(const records::SherdRecord& sherd);
QString stateLabel(records::SherdState state);
/// How a value was measured: "by the program", "on a scale".
QString methodLabel(const std::string& method);
QString when(std::int64_t ms);  ///< day and time in the language's form

}  // namespace ostraka::ui
