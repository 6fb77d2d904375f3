#include "intake/same_pieces.h"

#include <algorithm>
#include <compare>
#include <cstdlib>

#include "intake/edited_pieces.h"

namespace ostraka::intake {
namespace {

using decisions::DecisionKind;
using decisions::kSamePiece_mm;

struct Candidate {
  double distance_mm;
  bool other_name;
  std::size_t known, found;
  auto operator<=>(const Candidate&) const = default;
};

double between_mm(const records::ScanRecord& scan, const Eigen::Vector2d& place_mm) {
  return (*placeOf(scan) - place_mm).norm();
}

class Matching {
 public:
  Matching(const std::vector<records::ScanRecord>& known,
           const std::vector<records::ScanRecord>& found)
      : known_(known), found_(found), same_(known.size(), -1), taken_(found.size()) {}

  void cut(const decisions::PairDecision& split,
           const std::map<store::ScanRow, Eigen::Vector2d>& typed_mm) {
    const decisions::ScanRef& ref = split.scans.front();
    const auto before = halvesOf(split, known_), now = halvesOf(split, found_);
    if (now && !before) {
      const int whole = at(known_, ref);
      if (whole < 0) return;
      const records::ScanRecord& cut = known_[static_cast<std::size_t>(whole)];
      if (!areHalves(found_[now->first], found_[now->second], cut)) return;
      const auto typed = typed_mm.find(cut.row);
      const Eigen::Vector2d to = typed == typed_mm.end() ? *placeOf(cut) : typed->second;
      const bool first = between_mm(found_[now->first], to) <= between_mm(found_[now->second], to);
      match(static_cast<std::size_t>(whole), first ? now->first : now->second);
    } else if (before && !now) {
      const int whole = at(found_, ref);
      if (whole < 0) return;
      const records::ScanRecord &one = known_[before->first], &other = known_[before->second];
      if (!areHalves(one, other, found_[static_cast<std::size_t>(whole)])) return;
      const bool first = one.row < other.row;
      match(first ? before->first : before->second, static_cast<std::size_t>(whole));
    }
  }

  void byPlaces() {
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < known_.size(); ++i)
      for (std::size_t j = 0; j < found_.size(); ++j) {
        if (known_[i].side != found_[j].side) continue;
        const bool other_name = known_[i].name != found_[j].name;
        const auto from = placeOf(known_[i]);
        const double distance_mm = from          ? between_mm(found_[j], *from)
                                   : !other_name ? 0
                                                 : kSamePiece_mm;
        if (distance_mm < kSamePiece_mm) candidates.push_back({distance_mm, other_name, i, j});
      }
    matchNearest(candidates);
  }

  // Of what is left over: the first part before, and the whole now, or the other way round.
  void joins(const decisions::Decisions& edits) {
    std::vector<Candidate> candidates;
    for (const decisions::PairDecision& join : edits) {
      if (join.kind != DecisionKind::Join) continue;
      const decisions::ScanRef& first = join.scans.front();
      const std::vector<Eigen::Vector2d> parts = joinedPlaces(join, edits);
      const auto fits = [&](const records::ScanRecord& part, const records::ScanRecord& whole) {
        return between_mm(part, first.place_mm) < kSamePiece_mm &&
               liesBetween(*placeOf(whole), parts);
      };
      for (std::size_t i = 0; i < known_.size(); ++i)
        for (std::size_t j = 0; j < found_.size(); ++j) {
          if (known_[i].side != first.side || found_[j].side != first.side) continue;
          if (known_[i].isThere() && placeOf(known_[i]) &&
              (fits(known_[i], found_[j]) || fits(found_[j], known_[i])))
            candidates.push_back({between_mm(found_[j], *placeOf(known_[i])),
                                  known_[i].name != found_[j].name, i, j});
        }
    }
    matchNearest(candidates);
  }

  const std::vector<int>& same() const { return same_; }

 private:
  // Not the piece itself beside a small neighbour that was not there, or is gone.
  static bool areHalves(const records::ScanRecord& a, const records::ScanRecord& b,
                        const records::ScanRecord& whole) {
    if (!a.points || !b.points || !whole.points) return true;
    const int larger = std::max(*a.points, *b.points);
    return std::abs(*whole.points - *a.points - *b.points) < std::abs(*whole.points - larger);
  }

  // The piece that is whole there, -1 when it is not.
  static int at(const std::vector<records::ScanRecord>& scans, const decisions::ScanRef& ref) {
    int nearest = -1;
    double least_mm = kSamePiece_mm;
    for (std::size_t i = 0; i < scans.size(); ++i) {
      if (scans[i].side != ref.side || !scans[i].isThere() || !placeOf(scans[i])) continue;
      const double off_mm = between_mm(scans[i], ref.place_mm);
      if (off_mm >= least_mm) continue;
      least_mm = off_mm;
      nearest = static_cast<int>(i);
    }
    return nearest;
  }

  void match(std::size_t known, std::size_t found) {
    if (same_[known] >= 0 || taken_[found]) return;
    same_[known] = static_cast<int>(found);
    taken_[found] = true;
  }

  void matchNearest(std::vector<Candidate>& candidates) {
    std::sort(candidates.begin(), candidates.end());
    for (const Candidate& c : candidates) match(c.known, c.found);
  }

  const std::vector<records::ScanRecord>&known_, &found_;
  std::vector<int> same_;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<int> samePieces(const std::vector<records::ScanRecord>& known,
                            const std::vector<records::ScanRecord>& found,
                            const decisions::Decisions& edits,
                            const std::map<store::ScanRow, Eigen::Vector2d>& typed_mm) {
  Matching matching(known, found);
  for (const decisions::PairDecision& edit : edits)
    if (edit.kind == DecisionKind::Split) matching.cut(edit, typed_mm);
  matching.byPlaces();
  matching.joins(edits);
  return matching.same();
}

}  // namespace ostraka::intake
