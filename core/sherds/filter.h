#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "records/sherd.h"

namespace ostraka::store {
class Database;
}  // namespace ostraka::store

namespace ostraka::sherds {

/// One condition of the filter line; all of a filter must hold.
struct Condition {
  enum class Is { Word, Contains, Equal, Less, LessEqual, Greater, GreaterEqual, Empty, NotEmpty };
  Is is = Is::Word;
  /// Of filterFields(), extra.NAME in small letters, or what a label says.
  std::string field;
  std::string value;
  bool negated = false;  ///< -word, -part:lid
  std::string text;      ///< as typed, for the chip
};

/// `rim T3 thickness>6 -burnt ware:grey surface_out:"" note:*`: words are looked for in all texts,
/// short ones (below three letters) as whole place or term; name:word is a text that has the word
/// in it (short words and digits only whole), number:t3-12 a number that has these parts after each
/// other, another field one that equals it; name:"value" equality, name:* any value, name:"" none;
/// extra.NAME:word or "Its name":word a custom field; < <= > >= compare numbers (12,5 and 12.5 mean
/// the same; equality holds as far as digits are typed) and days, months or years:
/// entered>=2026-07-01 excavated:2025. The code of a sherd's label finds the sherd that carries it,
/// though its number is another by now.
struct Filter {
  std::vector<Condition> conditions;
  std::string text() const;  ///< the line again
};

/// Errors: UnusableInput with a sentence that names the word that is not understood.
Result<Filter> parseFilter(std::string_view line);

/// The sherds that it finds, in this order; drafts behind all that have a number.
std::vector<store::SherdRow> matching(store::Database& database, const Filter& filter,
                                      const records::SherdOrder& order);

}  // namespace ostraka::sherds
