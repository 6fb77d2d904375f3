#include "intake/plate_sherds.h"

#include <algorithm>
#include <utility>

#include "catalogue/batches.h"
#include "intake/same_pieces.h"
#include "sherds/sherds.h"

namespace ostraka::intake {

PlateSherds::PlateSherds(const catalogue::Catalogue& catalogue, const std::string& batch_number) {
  const auto batch = catalogue::Batches(catalogue).byNumber(batch_number);
  if (!batch) return;
  const auto scans = catalogue::Batches(catalogue).scans(batch->row);
  const auto rows = sherds::Sherds(catalogue).rows(batch->row);
  if (!scans || !rows) return;
  auto sherds = sherds::Sherds(catalogue).of(*rows);
  if (!sherds) return;
  sherds_ = std::move(*sherds);
  if (auto again = sherds::photographedAgain(catalogue, batch->row)) again_ = std::move(*again);
  for (const records::ScanRecord& scan : *scans) {
    if (scan.side != batch::Side::Front || !scan.isThere()) continue;
    if (!scan.plate_x_mm || !scan.plate_y_mm) continue;
    places_.push_back({scan.side, scan.name, {*scan.plate_x_mm, *scan.plate_y_mm}, {}});
    fronts_.push_back(scan);
  }
}

int PlateSherds::scanAt(const Eigen::Vector2d& place_mm) const {
  return decisions::resolved({batch::Side::Front, {}, place_mm, {}}, places_);
}

const records::SherdRecord* PlateSherds::ofScan(int scan) const {
  if (scan < 0) return nullptr;
  const store::ScanRow front = fronts_[static_cast<std::size_t>(scan)].row;
  const auto sherd = std::ranges::find(sherds_, front, &records::SherdRecord::front);
  return sherd == sherds_.end() ? nullptr : &*sherd;
}

const records::SherdRecord* PlateSherds::at(const Eigen::Vector2d& place_mm) const {
  return ofScan(scanAt(place_mm));
}

const sherds::PhotographedAgain* PlateSherds::again(const Eigen::Vector2d& place_mm) const {
  const int scan = scanAt(place_mm);
  if (scan < 0) return nullptr;
  const auto found = std::ranges::find(again_, fronts_[static_cast<std::size_t>(scan)].row,
                                       &sherds::PhotographedAgain::front);
  return found == again_.end() ? nullptr : &*found;
}

JoinedNumbers PlateSherds::afterJoin(const decisions::PairDecision& join) const {
  if (join.kind != decisions::DecisionKind::Join || join.scans.size() != 2 ||
      join.scans.front().side != batch::Side::Front)
    return {};
  const int first = scanAt(join.scans[0].place_mm), second = scanAt(join.scans[1].place_mm);
  if (first < 0 || second < 0 || first == second) return {};
  // As it will lie there: under the first one's name, at the mean of all points.
  std::vector<records::ScanRecord> found = fronts_;
  records::ScanRecord& whole = found[static_cast<std::size_t>(first)];
  const records::ScanRecord& gone = fronts_[static_cast<std::size_t>(second)];
  const double n = whole.points.value_or(1), m = gone.points.value_or(1);
  if (n + m > 0) {
    whole.plate_x_mm = (n * *whole.plate_x_mm + m * *gone.plate_x_mm) / (n + m);
    whole.plate_y_mm = (n * *whole.plate_y_mm + m * *gone.plate_y_mm) / (n + m);
  }
  found.erase(found.begin() + second);
  const std::vector<int> same = samePieces(fronts_, found, {join});
  const bool second_stays = same[static_cast<std::size_t>(first)] < 0;
  const auto numberOf = [this](int scan) {
    const records::SherdRecord* sherd = ofScan(scan);
    return sherd == nullptr ? std::string() : sherd->number;
  };
  return {numberOf(second_stays ? second : first), numberOf(second_stays ? first : second)};
}

}  // namespace ostraka::intake
