#include "catalogue/search.h"

namespace ostraka::catalogue {

std::string searched(std::string word) {
  for (const std::string_view other : {"İ", "ı"})
    for (std::size_t at; (at = word.find(other)) != std::string::npos;)
      word.replace(at, other.size(), "i");
  return word;
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

}  // namespace ostraka::catalogue
