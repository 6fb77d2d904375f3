#include "store/values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <unordered_set>

#include "base/message.h"
#include "base/text.h"
#include "files/contained_path.h"
#include "files/json_text.h"
#include "store/names.h"

namespace ostraka::store {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

// No form has so many letters, and the library recurses with each.
bool matches(std::string_view text, const std::regex& form) {
  return text.size() < 100 && std::regex_match(text.begin(), text.end(), form);
}

// 2026-07-14, with the digits of year, month and day at these places.
bool isDay(std::string_view text) {
  const auto number = [&](std::size_t from, std::size_t count) {
    int value = 0;
    std::from_chars(text.data() + from, text.data() + from + count, value);
    return value;
  };
  using namespace std::chrono;
  return year_month_day(year(number(0, 4)), month(static_cast<unsigned>(number(5, 2))),
                        day(static_cast<unsigned>(number(8, 2))))
      .ok();
}

bool looksLikeADay(std::string_view text) {
  static const std::regex kForm("[0-9]{4}-[0-9]{2}-[0-9]{2}");
  return matches(text, kForm);
}

// One end of an EDTF interval: -0599, 2026-07, 19XX, Y-12000, 2026-21 (a season), with ? ~ or %.
bool isEdtfDate(std::string_view text) {
  static const std::regex kForm(
      "(Y-?[0-9]{5,9}|-?[0-9]{2}([0-9]{2}|[0-9]X|XX)"
      "(-(0[1-9]|1[0-2]|2[1-4]|XX)|-(0[1-9]|1[0-2]|XX)-(0[1-9]|[12][0-9]|3[01]|XX))?)[?~%]?");
  if (!matches(text, kForm)) return false;
  const std::string_view day = text.substr(text[0] == '-' ? 1 : 0, 10);
  return !looksLikeADay(day) || isDay(day);
}

enum class Bound { Earliest, Latest };

// Year, month and day that a date has at the earliest or latest: what it leaves open may be any; a
// season, which has no agreed months, is anywhere in its year.
std::array<int, 3> boundOf(std::string_view date, Bound bound) {
  const bool latest = bound == Bound::Latest, any_length = date.starts_with('Y');
  if (any_length) date.remove_prefix(1);
  const bool negative = date.starts_with('-');
  if (negative) date.remove_prefix(1);
  std::string year(date.substr(0, any_length ? date.find_first_of("?~%") : 4));
  const std::string_view rest = date.substr(year.size());
  std::replace(year.begin(), year.end(), 'X', latest == negative ? '0' : '9');
  const auto part = [&](std::size_t at, int most) {
    int value = 0;
    if (at < rest.size()) std::from_chars(rest.data() + at, rest.data() + rest.size(), value);
    const bool open = value == 0 || value > most;
    return !open ? value : latest ? most : 1;
  };
  const int years = std::stoi(year);
  return {negative ? -years : years, part(1, 12), part(4, 31)};
}

}  // namespace

Result<std::string> checkedText(std::string_view text) {
  if (const Result<void> good = checkText(text); !good) return good.error();
  return composed(trimmed(text));
}

bool holdsSystemNames(std::string_view table) {
  return table == "history" || table == "setting";
}

Result<std::string> checkedDay(std::string_view typed) {
  const std::string text = trimmed(typed);
  if (text.empty()) return text;
  if (looksLikeADay(text) && isDay(text)) return text;
  return Error::unusable(message("Write the day as 2026-07-14 (year-month-day)."));
}

Result<std::string> checkedEdtf(std::string_view typed) {
  const std::string text = trimmed(typed);
  if (text.empty()) return text;
  const std::size_t slash = text.find('/');
  bool good = false;
  if (slash == std::string::npos) {
    good = isEdtfDate(text);
  } else {
    const std::string_view from = std::string_view(text).substr(0, slash);
    const std::string_view to = std::string_view(text).substr(slash + 1);
    const auto isEnd = [](std::string_view end) {
      return end.empty() || end == ".." || isEdtfDate(end);
    };
    good = isEnd(from) && isEnd(to) && (isEdtfDate(from) || isEdtfDate(to));
    if (isEdtfDate(from) && isEdtfDate(to) &&
        boundOf(to, Bound::Latest) < boundOf(from, Bound::Earliest))
      return Error::unusable(message(
          "The interval ends before it begins: %1 is earlier than %2; write the earlier date "
          "first, and years BC with a minus sign.",
          std::string(to), std::string(from)));
  }
  if (good) return text;
  return Error::unusable(message(
      "Write the date in EDTF, for example -0599/-0549~ (600 to about 550 BC), -1149? or 0350/..; "
      "years have four digits, and words such as MB II belong in the field for the period."));
}

Result<std::string> checkedMunsell(std::string_view typed) {
  std::string text = trimmed(typed);
  if (text.empty()) return text;
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  static const std::regex kForm("(N|[0-9.]+(R|YR|Y|GY|G|BG|B|PB|P|RP)) [0-9.]+/[0-9.]*");
  if (matches(text, kForm)) return text;
  return Error::unusable(message("Write the Munsell colour as 10YR 3/1 or N 4/."));
}

namespace {

// 1.204,5 and 1,204.5: the mark that the other one follows stands between groups of three digits.
// One mark alone is the decimal one: 1.204 is not 1204.
std::string withoutGroupMarks(const std::string& text) {
  const std::size_t decimal = text.find_last_of(".,");
  if (decimal == std::string::npos) return text;
  const char group = text[decimal] == '.' ? ',' : '.';
  std::string whole = text.substr(0, decimal);
  std::size_t end = decimal;
  for (std::size_t at = whole.rfind(group); at != std::string::npos; at = whole.rfind(group)) {
    if (end - at != 4) return text;
    whole.erase(at, 1);
    end = at;
  }
  if (end == decimal) return text;
  const std::size_t first = whole.find_first_not_of("+-");
  if (first >= end || end - first > 3 || whole[first] == '0') return text;
  return whole + '.' + text.substr(decimal + 1);
}

// Without what else languages write between groups of three digits, as in 1 234 567,5: blanks,
// those that do not break, too, and apostrophes.
std::string withoutGroups(const std::string& text) {
  constexpr std::string_view kMarks[] = {" ", "\u00A0", "\u2009", "\u202F", "'", "\u2019"};
  std::string out;
  std::size_t i = 0;
  for (; i < text.size() && text[i] != '.' && text[i] != ','; ++i) {
    const auto mark = std::ranges::find_if(kMarks, [&](std::string_view m) {
      return std::string_view(text).substr(i).starts_with(m);
    });
    if (mark != std::end(kMarks) && !out.empty() && isDigit(out.back())) {
      const std::string_view rest = std::string_view(text).substr(i + mark->size());
      const auto digits = static_cast<std::size_t>(
          std::find_if_not(rest.begin(), rest.end(), isDigit) - rest.begin());
      if (digits != 3) return text;
      i += mark->size();
    }
    out += text[i];
  }
  return out + text.substr(i);
}

}  // namespace

Result<double> parsedNumber(std::string_view typed) {
  const std::string whole = trimmed(typed);
  std::string text = withoutGroupMarks(withoutGroups(whole));
  if (std::count(text.begin(), text.end(), ',') == 1 && text.find('.') == std::string::npos)
    text[text.find(',')] = '.';
  double value = 0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, code] = std::from_chars(begin, text.data() + text.size(), value);
  if (text.empty() || code != std::errc() || end != text.data() + text.size() ||
      !std::isfinite(value))
    return Error::unusable(
        message("'%1' is not a number; write 12.5 or 12,5, without a unit.", whole));
  return value;
}

namespace {

// With a fourth digit behind the mark: what is offered can be read in one way.
Error inTwoWays(const std::string& whole, char mark, const std::string& rest) {
  const char decimal = mark == ',' ? '.' : ',';
  return Error::unusable(message("'%1' can be read as %2 or as %3; write one of the two.",
                                 whole + mark + rest, whole + rest, whole + decimal + rest + "0"));
}

}  // namespace

Result<void> readsOneWay(std::string_view number, char mark) {
  constexpr std::string_view kDigits = "0123456789";
  // Of 1,250 ± 2,5 each; 1 250,125 has its thousands apart already.
  for (std::size_t at = number.find(mark); at != std::string_view::npos;
       at = number.find(mark, at + 1)) {
    const std::size_t before = number.find_last_not_of(kDigits, at - (at > 0 ? 1 : 0));
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::size_t end = std::min(number.find_first_not_of(kDigits, at + 1), number.size());
    const std::string ahead = trimmed(number.substr(0, begin));
    const std::string behind = trimmed(number.substr(end));
    const bool alone =
        (ahead.empty() || ahead.ends_with("±") || ahead.back() == '-' || ahead.back() == '+') &&
        (behind.empty() || behind.starts_with("±") || behind.front() == '+');
    const std::size_t digits = at - std::min(begin, at);
    if (!alone || digits < 1 || digits > 3 || number[begin] == '0' || end - at != 4) continue;
    return inTwoWays(std::string(number.substr(begin, digits)), mark,
                     std::string(number.substr(at + 1, 3)));
  }
  return {};
}

double halfStep(std::string_view typed) {
  const std::string number = trimmed(typed);
  const std::size_t end = std::min(number.find_first_of("eE"), number.size());
  const std::size_t mark = number.find_last_of(".,", end);
  int power = 0;
  if (const std::size_t digits = number.find_first_not_of("eE+", end); digits < number.size())
    std::from_chars(number.data() + digits, number.data() + number.size(), power);
  if (mark != std::string::npos) power -= static_cast<int>(end - mark) - 1;
  return 0.5 * std::pow(10, power);
}

std::pair<std::string, std::optional<std::string>> splitPlusMinus(std::string_view text) {
  for (const std::string_view sign : {"\u00b1", "+-", "+/-"})
    if (const std::size_t at = text.find(sign); at != std::string_view::npos)
      return {trimmed(text.substr(0, at)), trimmed(text.substr(at + sign.size()))};
  return {trimmed(text), std::nullopt};
}

std::string numberText(double value) {
  char buffer[40];
  const auto end = std::to_chars(std::begin(buffer), std::end(buffer), value).ptr;
  return {std::begin(buffer), end};
}

Result<void> checkFinite(double value) {
  if (std::isfinite(value)) return {};
  return Error::unusable(
      message("'%1' is not a number; write 12.5 or 12,5, without a unit.", numberText(value)));
}

std::vector<std::string> splitTerms(std::string_view text) {
  std::vector<std::string> terms;
  std::unordered_set<std::string> known;
  while (true) {
    const std::size_t at = text.find(';');
    std::string term = trimmed(text.substr(0, at));
    if (!term.empty() && known.insert(term).second) terms.push_back(std::move(term));
    if (at == std::string_view::npos) return terms;
    text.remove_prefix(at + 1);
  }
}

std::string joinTerms(const std::vector<std::string>& terms) {
  return joined(terms, "; ");
}

std::string termsJson(const std::vector<std::string>& terms) {
  return nlohmann::json(terms).dump();
}

std::vector<std::string> termsFromJson(std::string_view text) {
  const nlohmann::json json = jsonOrDiscarded(text);
  std::vector<std::string> terms;
  if (json.is_array())
    for (const nlohmann::json& term : json)
      if (term.is_string()) terms.push_back(term.get<std::string>());
  return terms;
}

Result<std::string> checkedNumber(std::string_view number) {
  if (number.find_first_of("\r\n\t%") != std::string_view::npos)
    return Error::unusable(message("A number cannot contain a line break, a tab or '%'."));
  if (hasInvisible(number))
    return Error::unusable(
        message("A number or code cannot contain invisible characters; type it again."));
  if (number.size() > 120) return Error::unusable(message("A number has at most 120 characters."));
  return std::string(number);
}

namespace {

std::size_t lettersOf(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

Result<std::string> checkedBatchNumber(std::string_view number) {
  constexpr std::size_t kMostLetters = 64;
  const std::string_view digits = number.substr(number.starts_with('B') ? 1 : number.size());
  const auto counted = static_cast<std::size_t>(
      std::find_if_not(digits.begin(), digits.end(), isDigit) - digits.begin());
  if (slug(number) == number && !hasInvisible(number) && lettersOf(number) <= kMostLetters &&
      counted <= kBatchDigits)
    return std::string(number);
  return Error::unusable(
      message("The number of a batch is also the name of its folder; use letters and digits."),
      std::string(number));
}

Result<std::string> checkedPath(std::string_view typed) {
  if (!isUtf8(typed))
    return Error::unusable(message("The text is not valid UTF-8 or contains a zero byte."));
  const Result<ContainedPath> path = ContainedPath::parse(typed);
  if (!path) return path.error();
  return path->text();
}

}  // namespace ostraka::store
