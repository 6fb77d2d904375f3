#include "tables/damaged_number.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <string>
#include <vector>

#include "store/names.h"

namespace ostraka::tables {
namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kMonths[] = {
    "Jan", "Feb", "Mar", "Apr", "May", "Jun",  "Jul",  "Aug",  "Sep", "Sept", "Oct",  "Nov",  "Dec",
    "Mrz", "Mär", "Mai", "Okt", "Dez", "janv", "févr", "mars", "avr", "juin", "juil", "août", "déc",
    "ene", "abr", "ago", "dic", "Ιαν", "Φεβ",  "Μαρ",  "Απρ",  "Μαϊ", "Ιουν", "Ιουλ", "Αυγ",  "Σεπ",
    "Οκτ", "Νοε", "Δεκ", "Oca", "Şub", "Nis",  "Haz",  "Tem",  "Ağu", "Eyl",  "Eki",  "Kas",  "Ara",
    "հնվ", "փտվ", "մրտ", "ապր", "մյս", "հնս",  "հլս",  "օգս",  "սեպ", "հոկ",  "նոյ",  "դեկ"};

bool isShortened(std::string_view text) {
  const std::size_t power = text.find_first_of("Ee");
  return power != std::string_view::npos && power > 0 && power + 2 < text.size() &&
         text.find_first_not_of("0123456789.,") == power && text[power + 1] == '+' &&
         text.find_first_not_of(kDigits, power + 2) == std::string_view::npos;
}

bool isMonth(const std::string& word) {
  static const std::set<std::string> kKeys = [] {
    std::set<std::string> keys;
    for (const std::string_view month : kMonths) keys.insert(store::plainKey(month));
    return keys;
  }();
  const auto second = std::find_if(word.begin() + 1, word.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  });
  const std::string behind_first(second, word.end());
  return kKeys.contains(store::plainKey(word)) &&
         store::uniqueKey(behind_first) == store::composed(behind_first);
}

// Of a few digits; 0: none.
int numberOf(std::string_view word) {
  if (word.size() > 4 || word.find_first_not_of(kDigits) != std::string_view::npos) return 0;
  int value = 0;
  std::from_chars(word.data(), word.data() + word.size(), value);
  return value;
}

bool isDate(std::string_view text) {
  constexpr std::string_view kBetweenNumbers = "-./ ";
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(kBetweenNumbers); at < text.size();
       at = text.find_first_not_of(kBetweenNumbers, at)) {
    const std::size_t end = std::min(text.find_first_of(kBetweenNumbers, at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = end;
  }
  if (words.size() < 2 || words.size() > 3) return false;
  const auto numbers = static_cast<std::size_t>(
      std::count_if(words.begin(), words.end(), [](const auto& word) { return numberOf(word); }));
  if (numbers + 1 == words.size()) return std::any_of(words.begin(), words.end(), isMonth);
  if (numbers < 3) return false;
  const auto [month, day] = std::minmax({numberOf(words[0]), numberOf(words[1])});
  const int year = numberOf(words[2]);
  return month <= 12 && day <= 31 && year >= 1900 && year < 2100;
}

}  // namespace

bool isDamagedNumber(std::string_view number) {
  return isShortened(number) || isDate(number);
}

}  // namespace ostraka::tables
