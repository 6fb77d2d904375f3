#pragma once
#include <cstdint>
#include <string>

#include "store/database.h"
#include "store/row.h"

namespace ostraka::catalogue {

/// As the search has them: with one i, dotted or not (see searched()).
inline constexpr const char* kSearchedWords = "replace(replace(words, 'İ', 'i'), 'ı', 'i')";
/// A word as it is searched for: İ and ı are i, I is folded by the index.
std::string searched(std::string word);
/// What two words are compared by: capitals make no difference, nor which i.
std::string searchKey(const std::string& word);
/// Below three letters, of which the search has no index.
bool isShort(const std::string& word);
/// Whether the text has the word in it; a number or a short word only as a whole word: 1 is not in
/// 12.
bool hasWord(const std::string& text, const std::string& word);
/// The search finds the sherd by what it says now.
void searchAnew(store::Database& database, store::SherdRow sherd);
/// The same of all sherds whose context has this row in that column ("row": the context itself):
/// its place is called otherwise.
void searchAnewIn(store::Database& database, const char* column, std::int64_t row);

}  // namespace ostraka::catalogue
