#include "checks/lone_scans.h"

#include <cmath>
#include <optional>
#include <utility>

#include "base/message.h"
#include "scan/footprint.h"

namespace ostraka::checks {
namespace {

// Sherds that lean on each other hide a strip; both sides of a sherd show nearly the same outline.
constexpr double kLess = 0.10, kMore = 0.05;

}  // namespace

std::vector<Message> perhapsTouching(std::span<const scan::Scan* const> lone,
                                     std::span<const scan::Scan* const> others) {
  std::vector<double> areas;
  for (const scan::Scan* other : others) areas.push_back(scan::areaFromAbove_mm2(other->cloud));
  std::vector<Message> words;
  for (const scan::Scan* scan : lone) {
    const double area = scan::areaFromAbove_mm2(scan->cloud);
    double least = 1;
    std::optional<std::pair<std::size_t, std::size_t>> best;
    for (std::size_t i = 0; i < others.size(); ++i)
      for (std::size_t j = i + 1; j < others.size(); ++j) {
        const double off = area / (areas[i] + areas[j]) - 1;
        if (off < -kLess || off > kMore || std::abs(off) >= least) continue;
        least = std::abs(off);
        best = {i, j};
      }
    if (best)
      words.push_back(
          message("%1 may be two sherds that touch, %2 and %3 of the other side: split it in the "
                  "review, or move them apart and reshoot its side.",
                  scan->id, others[best->first]->id, others[best->second]->id));
  }
  return words;
}

}  // namespace ostraka::checks
