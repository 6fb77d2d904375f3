#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "records/numbering.h"
#include "records/records.h"

namespace ostraka::catalogue {

/// The running numbers that were ever given in a place. Numbers stand on their sherds: a place that
/// is called otherwise by now, or became one with another, counts those that name it as it was
/// called before, too. All calls throw as Statement does.
class GivenNumbers {
 public:
  /// tokens: of a sherd in this context and bag, which may be none.
  GivenNumbers(const Catalogue& catalogue, const records::Numbering& scheme,
               const std::map<std::string, std::string>& tokens, store::ContextRow context,
               store::BagRow bag);

  std::set<std::int64_t> all() const;  ///< to whichever sherd
  /// After the highest within first..last.
  std::int64_t next(std::int64_t first, std::int64_t last) const;
  /// The last that the sherd had; empty: none.
  std::string ownOf(store::SherdRow sherd) const;

 private:
  std::optional<std::int64_t> of(const std::string& number) const;
  const Catalogue& catalogue_;
  std::vector<records::NumberCount> counts_;
};

}  // namespace ostraka::catalogue
