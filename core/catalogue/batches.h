#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "catalogue/subject.h"
#include "records/records.h"

namespace ostraka::catalogue {

/// Batches with their photographs and scans.
class Batches : public Subject {
 public:
  using Subject::Subject;

  Result<std::vector<records::BatchRecord>> all() const;  ///< newest first
  Result<records::BatchRecord> get(store::BatchRow) const;
  Result<records::BatchRecord> byNumber(const std::string&) const;
  /// None when it is not there.
  Result<std::optional<records::BatchRecord>> byId(const std::string& id) const;
  /// One above the largest, B0031. What somebody put into a folder of that name would become part
  /// of the batch: such a number is passed over, unless the folders are the caller's own.
  enum class Folders { Avoided, Own };
  Result<std::string> nextNumber(Folders = Folders::Avoided) const;
  /// Gets the next number (B0031) within the transaction, unless it has one.
  Result<store::BatchRow> add(const records::BatchRecord&, const records::Provenance&);
  Result<void> save(const records::BatchRecord&, const records::Provenance&);
  Result<void> setState(store::BatchRow, records::BatchState, const records::Provenance&);

  Result<std::vector<records::PhotographRecord>> photographs(store::BatchRow) const;
  /// Row none: added, or the one with its key changed.
  Result<store::PhotographRow> save(const records::PhotographRecord&, const records::Provenance&);
  Result<std::vector<records::ScanRecord>> scans(store::BatchRow) const;
  /// Row none: added, or the one of its batch, side and index changed.
  Result<store::ScanRow> save(const records::ScanRecord&, const records::Provenance&);
};

}  // namespace ostraka::catalogue
