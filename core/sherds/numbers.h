#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "catalogue/subject.h"
#include "records/numbering.h"
#include "records/records.h"

namespace ostraka::sherds {

/// Of this computer, so that no two in the field give the same number.
Result<records::NumberBlock> numberBlock(const catalogue::Catalogue&);

/// The inventory numbers of sherds, by the project's scheme.
class Numbers : public catalogue::Subject {
 public:
  using catalogue::Subject::Subject;

  /// The next free numbers of a context (and bag, batch), above all that were given there in
  /// whichever spelling of the place (store::codeKey), and in the place's own, similar to none
  /// of another sherd; not reserved.
  Result<std::vector<std::string>> propose(std::span<const store::SherdRow>) const;
  /// Gives drafts their numbers. Returns them in the order of the rows.
  Result<std::vector<std::string>> assign(std::span<const store::SherdRow>,
                                          const records::Provenance&);
  /// The next running number in a context, which may be none, by this scheme and its tokens, within
  /// first..last; not reserved.
  Result<int> next(const records::Numbering& scheme,
                   const std::map<std::string, std::string>& tokens, store::ContextRow context,
                   int first, int last) const;
  /// Of other sherds, those that people read as this one: they differ in leading zeros, letter case
  /// or punctuation at most (store::sortKey), or in being 12.0 for 12. The number itself is none of
  /// them.
  Result<std::vector<std::string>> similar(store::SherdRow, const std::string& number) const;
  /// What to look at again before the sherd gets this number; empty: nothing.
  Result<Message> doubt(store::SherdRow, const std::string& number) const;
  /// No sherd has it or ever had it.
  Result<bool> isFree(const std::string& number) const;
  /// Running numbers of this computer's block, below the highest, that were never given.
  Result<std::vector<int>> gaps(store::ContextRow) const;
};

}  // namespace ostraka::sherds
