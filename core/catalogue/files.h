#pragma once
#include <vector>

#include "base/result.h"
#include "catalogue/subject.h"
#include "records/records.h"
#include "records/sherd.h"

namespace ostraka::catalogue {

/// The files that a project keeps, with their checksums.
class Files : public Subject {
 public:
  using Subject::Subject;

  Result<std::vector<records::FileRecord>> all() const;
  Result<std::vector<records::FileRecord>> of(store::SherdRow) const;
  Result<std::vector<records::FileRecord>> of(store::BatchRow) const;
  /// Row none: added, or the one with its path changed.
  Result<store::FileRow> save(const records::FileRecord&, const records::Provenance&);
};

}  // namespace ostraka::catalogue
