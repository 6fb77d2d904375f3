#pragma once
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/subject.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::sherds {

struct Filter;

/// The sherds themselves; sherd_changes.h changes their fields, numbers.h numbers them.
class Sherds : public catalogue::Subject {
 public:
  using catalogue::Subject::Subject;

  Result<std::vector<store::SherdRow>> rows(const Filter&, const records::SherdOrder&) const;
  Result<std::vector<store::SherdRow>> rows(store::BatchRow) const;
  Result<std::vector<records::SherdRecord>> of(
      std::span<const store::SherdRow>) const;  ///< in this order
  Result<records::SherdRecord> get(store::SherdRow) const;
  Result<store::SherdRow> byNumber(const std::string&) const;  ///< none when there is no such sherd
  Result<store::SherdRow> byId(const std::string& uuid) const;  ///< likewise
  /// Custom fields that any sherd has, as a change names them: extra.NAME, in order.
  Result<std::vector<std::string>> customFields() const;
  /// As a draft, or with its number.
  Result<store::SherdRow> add(const records::SherdRecord&, const records::Provenance&);
  /// Which model and picture show it; relative paths.
  Result<void> setModel(store::SherdRow, const std::string& model_path,
                        const std::string& preview_path);
  /// Its number stays taken.
  Result<void> voidSherd(store::SherdRow, const std::string& reason, const records::Provenance&);
};

}  // namespace ostraka::sherds
