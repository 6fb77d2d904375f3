#include "pipeline/lone_scans.h"

#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace ostraka::pipeline {
namespace {

// Sherds that lean on each other hide a strip; both sides of a sherd show nearly the same outline.
constexpr double kLess = 0.10, kMore = 0.05;

// Squares of 1 mm that hold points, seen from above.
double plateArea_mm2(const scan::Scan& scan) {
  std::set<std::pair<int, int>> squares;
  for (const Eigen::Vector3f& p : scan.cloud.points)
    squares.insert({static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))});
  return static_cast<double>(squares.size());
}

}  // namespace

std::vector<std::string> perhapsTouching(std::span<const scan::Scan* const> lone,
                                         std::span<const scan::Scan* const> others) {
  std::vector<double> areas;
  for (const scan::Scan* other : others) areas.push_back(plateArea_mm2(*other));
  std::vector<std::string> words;
  for (const scan::Scan* scan : lone) {
    const double area = plateArea_mm2(*scan);
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
      words.push_back(scan->id + " may be two sherds that touch, " + others[best->first]->id +
                      " and " + others[best->second]->id +
                      " of the other side: cut it in the review, or lay them apart and photograph "
                      "its side again.");
  }
  return words;
}

}  // namespace ostraka::pipeline
