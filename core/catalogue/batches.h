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
  /// One above the largest, B0031; a number whose folder is there is passed over: what somebody put
  /// into it would become part of the batch.
  Result<std::string> nextNumber() const;
  /// The lowest that no batch has, whatever lies in its folder: that of files which were copied
  /// before their batch enters, though another batch began meanwhile.
  Result<std::string> lowestFreeNumber() const;
  /// Gets the next number (B0031) within the transaction, unless it has one.
  Result<store::BatchRow> add(const records::BatchRecord&, const records::Provenance&);
  Result<void> save(const records::BatchRecord&, const records::Provenance&);
  Result<void> setState(store::BatchRow, records::BatchState, const records::Provenance&);

  Result<std::vector<records::PhotographRecord>> photographs(store::BatchRow) const;
  Result<bool> isInvented(store::BatchRow) const;  ///< photographed by the virtual rig
  /// Row none: added, or the one with its key changed.
  Result<store::PhotographRow> save(const records::PhotographRecord&, const records::Provenance&);
  Result<std::vector<records::ScanRecord>> scans(store::BatchRow) const;
  /// Row none: added, or the one of its batch, side and index changed.
  Result<store::ScanRow> save(const records::ScanRecord&, const records::Provenance&);
};

}  // namespace ostraka::catalogue
