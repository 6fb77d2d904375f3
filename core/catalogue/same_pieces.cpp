#include "catalogue/same_pieces.h"

#include <algorithm>
#include <cmath>
#include <compare>

namespace ostraka::catalogue {
namespace {

using pipeline::kSamePiece_mm;

struct Candidate {
  double distance_mm;
  bool other_name;
  std::size_t known, found;
  auto operator<=>(const Candidate&) const = default;
};

bool liesAt(const ScanRecord& scan, const pipeline::ScanRef& ref) {
  return scan.side == ref.side && scan.plate_x_mm && scan.plate_y_mm &&
         std::hypot(*scan.plate_x_mm - ref.place_mm.x(), *scan.plate_y_mm - ref.place_mm.y()) <
             kSamePiece_mm;
}

bool wasEdited(const ScanRecord& known, const ScanRecord& found, const pipeline::Decisions& edits) {
  return std::any_of(edits.begin(), edits.end(), [&](const pipeline::PairDecision& d) {
    const pipeline::ScanRef& first = d.scans.front();
    return liesAt(known, first) || liesAt(found, first);
  });
}

}  // namespace

std::vector<int> samePieces(const std::vector<ScanRecord>& known,
                            const std::vector<ScanRecord>& found,
                            const pipeline::Decisions& edits) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < known.size(); ++i)
    for (std::size_t j = 0; j < found.size(); ++j) {
      if (known[i].side != found[j].side) continue;
      const bool other_name = known[i].name != found[j].name;
      if (!known[i].plate_x_mm || !known[i].plate_y_mm) {
        if (!other_name) candidates.push_back({kSamePiece_mm, other_name, i, j});
        continue;
      }
      const double distance_mm = std::hypot(*known[i].plate_x_mm - *found[j].plate_x_mm,
                                            *known[i].plate_y_mm - *found[j].plate_y_mm);
      if (distance_mm < kSamePiece_mm)
        candidates.push_back({distance_mm, other_name, i, j});
      else if (!other_name && wasEdited(known[i], found[j], edits))
        candidates.push_back({distance_mm, other_name, i, j});  // behind all that lie at one place
    }
  std::sort(candidates.begin(), candidates.end());
  std::vector<int> same(known.size(), -1);
  std::vector<bool> taken(found.size());
  for (const Candidate& c : candidates) {
    if (same[c.known] >= 0 || taken[c.found]) continue;
    same[c.known] = static_cast<int>(c.found);
    taken[c.found] = true;
  }
  return same;
}

}  // namespace ostraka::catalogue
