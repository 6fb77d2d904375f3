#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "decisions/decisions.h"
#include "records/sherd.h"
#include "sherds/photographed_again.h"

namespace ostraka::intake {

/// What becomes of the numbers of two sherds whose fronts are joined; empty: it had none.
struct JoinedNumbers {
  std::string kept;  ///< of the joined sherd
  std::string left;  ///< stays without a piece
};

/// The sherds of one batch by where their fronts lie on its plate: results may be newer than those
/// in the catalogue, or older, and number the pieces otherwise.
class PlateSherds {
 public:
  /// None where the catalogue does not know the batch.
  PlateSherds(const catalogue::Catalogue& catalogue, const std::string& batch_number);

  /// Whose front lies there; null: no sherd's. Valid as long as this.
  const records::SherdRecord* at(const Eigen::Vector2d& place_mm) const;

  /// As what the piece that lies there was photographed again since; null: it was not.
  const sherds::PhotographedAgain* again(const Eigen::Vector2d& place_mm) const;

  /// When the batch is computed with this Join of two fronts. Of a piece that no sherd has the
  /// number is empty; both are for a join of backs.
  JoinedNumbers afterJoin(const decisions::PairDecision& join) const;

 private:
  int scanAt(const Eigen::Vector2d& place_mm) const;
  const records::SherdRecord* ofScan(int scan) const;

  std::vector<records::ScanRecord> fronts_;  ///< those with a place
  std::vector<decisions::ScanRef> places_;
  std::vector<records::SherdRecord> sherds_;
  std::vector<sherds::PhotographedAgain> again_;
};

}  // namespace ostraka::intake
