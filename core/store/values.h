#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace ostraka::store {

// Each takes a text as typed or imported and gives its canonical form, or an error whose sentence
// says what is expected. An empty text stays empty.

/// Composed, trimmed; refuses what checkText refuses, as every statement that writes does.
Result<std::string> checkedText(std::string_view text);
/// The settings and the history contain file names as the system gave them: any bytes.
bool holdsSystemNames(std::string_view table);
/// 2026-07-14, a day that exists.
Result<std::string> checkedDay(std::string_view text);
/// Extended Date/Time Format, level 1: years to days, ? ~ %, intervals with / and .., XX. An
/// interval may not end, at the latest, before it begins at the earliest.
Result<std::string> checkedEdtf(std::string_view text);
/// 10YR 3/1, N 4/0.
Result<std::string> checkedMunsell(std::string_view text);
/// 12.5 or 12,5; finite. Groups of three digits, as in 1 204,5 or 1.204,5; of 1.204 alone, which is
/// 1.204 here, readsOneWay says the doubt.
Result<double> parsedNumber(std::string_view text);
/// "1,250" is 1250 to those who write points and 1.25 to those who write commas. Errors: such a
/// number; 0,125 and 12,5 and 1250,125 are read in one way.
/// mark: ',' or '.', which may stand between thousands.
Result<void> readsOneWay(std::string_view number, char mark = ',');
/// Half a unit of a typed number's last digit: 0.05 for 12.5, 0.5 for 12, 500 for 1e3.
double halfStep(std::string_view number);
/// 12.5 ± 0.4, 12.5 +- 0.4 or 12.5+/-0.4 -> the trimmed text before the sign, and that behind it.
std::pair<std::string, std::optional<std::string>> splitPlusMinus(std::string_view text);
/// Shortest text that reads back as the same number, with a point.
std::string numberText(double value);
/// Refuses the infinite and what is not a number.
Result<void> checkFinite(double value);
/// rim; neck -> {rim, neck}, without doubles.
std::vector<std::string> splitTerms(std::string_view text);
std::string joinTerms(const std::vector<std::string>& terms);
/// A JSON array of texts, and back; what is no array of texts reads as empty.
std::string termsJson(const std::vector<std::string>& terms);
std::vector<std::string> termsFromJson(std::string_view json);
/// The number of a sherd: one line without '%' and without letters that nobody sees, of at most 120
/// bytes.
Result<std::string> checkedNumber(std::string_view number);
/// The number of a new batch, which names its folders on any system: a folder's name without
/// letters that nobody sees, of at most 64 characters, not one of those that Windows keeps for
/// devices, and after a B at most kBatchDigits digits. What is read must only be a folder's name.
constexpr std::size_t kBatchDigits = 9;
Result<std::string> checkedBatchNumber(std::string_view number);
/// A ContainedPath in UTF-8: the name on the disk byte for byte, composed or not.
Result<std::string> checkedPath(std::string_view path);

}  // namespace ostraka::store
