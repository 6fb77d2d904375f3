#include "decisions/piece_edits.h"

#include <algorithm>
#include <cstdio>

#include "base/text.h"
#include "decisions/candidate_table.h"
#include "scan/fracture.h"

namespace ostraka::decisions {
namespace {

using scan::Scan;

constexpr std::size_t kLeastPoints = 200;  // fewer make no outline and no fracture

std::vector<ScanRef> refsOf(const std::vector<Scan>& scans, batch::Side side,
                            const std::string& photographs) {
  std::vector<ScanRef> refs;
  for (const Scan& scan : scans) {
    refs.push_back(refOf(scan, side));
    refs.back().photographs = photographs;
  }
  return refs;
}

Scan made(std::string id, PointCloud cloud) {
  Scan scan{std::move(id), std::move(cloud), {}, Eigen::Vector3d::UnitZ()};
  scan.fracture = scan::findFracture(scan.cloud, scan.up);
  return scan;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// Properties that only one of the two has are dropped.
PointCloud together(const PointCloud& a, const PointCloud& b) {
  PointCloud cloud = a;
  append(cloud.points, b.points);
  append(cloud.normals, b.normals);
  append(cloud.colors, b.colors);
  append(cloud.quality, b.quality);
  if (cloud.normals.size() != cloud.size()) cloud.normals.clear();
  if (cloud.colors.size() != cloud.size()) cloud.colors.clear();
  if (cloud.quality.size() != cloud.size()) cloud.quality.clear();
  return cloud;
}

std::string nextId(const std::vector<Scan>& scans, batch::Side side) {
  int last = 0;
  for (const Scan& scan : scans) {
    int number = 0;
    if (scan.id.size() > 1 && std::sscanf(scan.id.c_str() + 1, "%d", &number) == 1)
      last = std::max(last, number);
  }
  return formatted("%c%03d", side == batch::Side::Front ? 'f' : 'b', last + 1);
}

bool join(std::vector<Scan>& scans, const std::vector<int>& pieces) {
  std::vector<int> gone(pieces.begin() + 1, pieces.end());
  std::sort(gone.rbegin(), gone.rend());
  // Two that were meant may lie in one scan by now.
  if (std::adjacent_find(gone.begin(), gone.end()) != gone.end() ||
      std::find(gone.begin(), gone.end(), pieces.front()) != gone.end())
    return false;
  Scan& first = scans[static_cast<std::size_t>(pieces.front())];
  PointCloud cloud = first.cloud;
  for (std::size_t i = 1; i < pieces.size(); ++i)
    cloud = together(cloud, scans[static_cast<std::size_t>(pieces[i])].cloud);
  first = made(first.id, std::move(cloud));
  for (const int i : gone) scans.erase(scans.begin() + i);
  return true;
}

bool split(std::vector<Scan>& scans, int piece, batch::Side side, const PairDecision& decision) {
  Scan& scan = scans[static_cast<std::size_t>(piece)];
  const Eigen::Vector2d along = decision.cut_mm[1] - decision.cut_mm[0];
  std::vector<int> left, right;
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    const Eigen::Vector2d p = scan.cloud.points[i].head<2>().cast<double>() - decision.cut_mm[0];
    (along.x() * p.y() - along.y() * p.x() >= 0 ? left : right).push_back(static_cast<int>(i));
  }
  if (left.size() < kLeastPoints || right.size() < kLeastPoints) return false;
  Scan other = made(nextId(scans, side), subset(scan.cloud, right));
  scan = made(scan.id, subset(scan.cloud, left));
  scans.push_back(std::move(other));
  return true;
}

}  // namespace

bool hasEdits(const Decisions& standing, batch::Side side) {
  return std::any_of(standing.begin(), standing.end(), [&](const PairDecision& d) {
    return (d.kind == DecisionKind::Join || d.kind == DecisionKind::Split) &&
           d.scans.front().side == side;
  });
}

EditedPieces editedPieces(std::vector<Scan> scans, batch::Side side, const Decisions& standing,
                          const std::string& photographs) {
  EditedPieces edited{std::move(scans), {}};
  for (const PairDecision& d : standing) {
    if ((d.kind != DecisionKind::Join && d.kind != DecisionKind::Split) ||
        d.scans.front().side != side)
      continue;
    const std::vector<ScanRef> refs = refsOf(edited.scans, side, photographs);
    std::vector<int> pieces;
    for (const ScanRef& ref : d.scans) pieces.push_back(resolved(ref, refs));
    const bool there = std::find(pieces.begin(), pieces.end(), -1) == pieces.end();
    const bool done =
        there && (d.kind == DecisionKind::Join ? join(edited.scans, pieces)
                                               : split(edited.scans, pieces.front(), side, d));
    if (!done)
      edited.warnings.push_back(
          d.kind == DecisionKind::Join
              ? message("The decision of %1 by %2 merges fragments that no longer exist; decide "
                        "again.",
                        momentOf(d), d.by)
              : message("The decision of %1 by %2 splits a fragment that does not exist, or misses "
                        "it; decide again.",
                        momentOf(d), d.by));
  }
  return edited;
}

}  // namespace ostraka::decisions
