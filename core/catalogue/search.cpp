#include "catalogue/search.h"

#include <algorithm>
#include <cctype>

#include "store/names.h"

namespace ostraka::catalogue {

std::string searched(std::string word) {
  for (const std::string_view other : {"İ", "ı"})
    for (std::size_t at; (at = word.find(other)) != std::string::npos;)
      word.replace(at, other.size(), "i");
  return word;
}

std::string searchKey(const std::string& word) {
  return store::uniqueKey(searched(word));
}

bool isShort(const std::string& word) {
  return std::count_if(word.begin(), word.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }) < 3;
}

bool hasWord(const std::string& text, const std::string& word) {
  const std::string in = searchKey(text), sought = searchKey(word);
  const bool whole =
      isShort(sought) || sought.find_first_not_of("0123456789.,") == std::string::npos;
  const auto isLetter = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) > 127;
  };
  for (std::size_t at = in.find(sought); at != std::string::npos; at = in.find(sought, at + 1)) {
    const std::size_t end = at + sought.size();
    if (!whole || ((at == 0 || !isLetter(in[at - 1])) && (end == in.size() || !isLetter(in[end]))))
      return true;
  }
  return false;
}

void searchAnew(store::Database& database, store::SherdRow sherd) {
  database.run("DELETE FROM sherd_term WHERE sherd = ?", sherd);
  database.run(
      "INSERT INTO sherd_term SELECT DISTINCT term, field, sherd FROM sherd_terms WHERE sherd "
      "= ?",
      sherd);
  database.run(std::string("INSERT OR REPLACE INTO sherd_text (rowid, words) SELECT sherd, ") +
                   kSearchedWords + " FROM sherd_words WHERE sherd = ?",
               sherd);
}

void searchAnewIn(store::Database& database, const char* column, std::int64_t row) {
  database.run(std::string("UPDATE sherd_text SET words = (SELECT ") + kSearchedWords +
                   " FROM sherd_words WHERE sherd = sherd_text.rowid) WHERE rowid IN (SELECT "
                   "sherd.row FROM sherd JOIN context ON context.row = sherd.context WHERE "
                   "context." +
                   column + " = ?)",
               row);
}

}  // namespace ostraka::catalogue
