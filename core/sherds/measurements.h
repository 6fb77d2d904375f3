#pragma once
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/subject.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::sherds {

/// Measurements of sherds. A new value is a new row that replaces the older one.
class Measurements : public catalogue::Subject {
 public:
  using catalogue::Subject::Subject;

  Result<void> add(const records::Measurement&, const records::Provenance&);
  Result<std::vector<records::Measurement>> of(store::SherdRow) const;  ///< those that count now
  /// Those of them that persons took, by sherd.
  Result<std::vector<records::Measurement>> byHand(std::span<const store::SherdRow>) const;
  /// All values of a kind that the program has taken from the sherd's models, old ones too.
  Result<std::vector<double>> everComputed(store::SherdRow, const std::string& kind) const;
};

}  // namespace ostraka::sherds
