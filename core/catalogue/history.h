#pragma once
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "catalogue/subject.h"
#include "records/records.h"
#include "records/sherd.h"
#include "store/values.h"

namespace ostraka::catalogue {

/// Who changed what, when and why; newest first.
class History : public Subject {
 public:
  using Subject::Subject;

  /// The sherd's; its scans and batches by name, B0001 b004.
  Result<std::vector<records::HistoryEntry>> of(store::SherdRow) const;
  Result<std::vector<records::HistoryEntry>> of(const std::string& table, std::int64_t row) const;
  std::int64_t length() const;  ///< rows: grows with every change
};

/// For the files of this folder: one row of the history. Nothing is written when old == new.
void remember(const Catalogue& catalogue, const records::Provenance& provenance, const char* table,
              std::int64_t row, const std::string& field, const std::string& old_value,
              const std::string& new_value);

/// A number as the history names it; nothing for none.
template <class Number>
std::string optionalText(const std::optional<Number>& value) {
  if (!value) return {};
  if constexpr (std::is_floating_point_v<Number>)
    return store::numberText(*value);
  else
    return std::to_string(*value);
}

}  // namespace ostraka::catalogue
