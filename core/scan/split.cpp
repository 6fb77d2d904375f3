#include "scan/split.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/message.h"
#include "base/plate_order.h"
#include "base/text.h"
#include "cloud/bounds.h"
#include "cloud/nearest.h"
#include "scan/footprint.h"
#include "scan/fracture.h"
#include "scan/outlines.h"
#include "scan/touching.h"

namespace ostraka::scan {
namespace {

constexpr std::size_t kFewest = 100;  // points; fewer make no scan, and mostly are flying points

// Where a sheet rises it may have given way under the sherd.
double heightAbove(const rig::SheetBend& ground, const Eigen::Vector3f& p) {
  return p.z() - std::min(0.0, ground.at(p.x(), p.y()));
}

std::vector<int> abovePlate(const PointCloud& cloud, const SplitOptions& options) {
  std::vector<int> kept;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double z = heightAbove(options.ground, cloud.points[i]);
    const bool plate =
        z < options.plate_mm || (z < options.plate_flat_mm && cloud.normals[i].z() > 0.9f);
    if (!plate) kept.push_back(static_cast<int>(i));
  }
  return kept;
}

int rootOf(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    int& up = parent[static_cast<std::size_t>(i)];
    up = parent[static_cast<std::size_t>(up)];
    i = up;
  }
  return i;
}

// Pieces whose points are at most gap_mm apart, as lists of indices in order of their first point.
std::vector<std::vector<int>> connectedPieces(const PointCloud& cloud, double gap_mm) {
  const PointCloud coarse = thinned(cloud, gap_mm / 3);
  const KdTree tree(coarse.points);
  std::vector<int> parent(coarse.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<Neighbour> found;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    tree.within(coarse.points[i], static_cast<float>(gap_mm), found);
    for (const Neighbour& n : found) {
      const int a = rootOf(parent, static_cast<int>(i)), b = rootOf(parent, n.index);
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  std::vector<int> piece_of_root(coarse.size(), -1);
  std::vector<std::vector<int>> pieces;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const int root = rootOf(parent, tree.nearest(cloud.points[i]).index);
    int& piece = piece_of_root[static_cast<std::size_t>(root)];
    if (piece < 0) {
      piece = static_cast<int>(pieces.size());
      pieces.emplace_back();
    }
    pieces[static_cast<std::size_t>(piece)].push_back(static_cast<int>(i));
  }
  return pieces;
}

// Pieces that stereo left without a connection to their sherd's edge go to it.
std::vector<std::vector<int>> withHoveringJoined(const PointCloud& cloud,
                                                 std::vector<std::vector<int>> pieces,
                                                 const SplitOptions& options) {
  std::vector<std::vector<int>> standing, hovering;
  for (std::vector<int>& piece : pieces) {
    const bool hovers =
        piece.size() >= kFewest && std::all_of(piece.begin(), piece.end(), [&](int i) {
          return heightAbove(options.ground, cloud.points[static_cast<std::size_t>(i)]) >
                 options.hover_mm;
        });
    (hovers ? hovering : standing).push_back(std::move(piece));
  }
  std::vector<KdTree> trees;
  if (!hovering.empty())
    for (const std::vector<int>& piece : standing) trees.emplace_back(subset(cloud, piece).points);
  for (std::vector<int>& piece : hovering) {
    auto nearest = static_cast<float>(options.hover_reach_mm);
    std::optional<std::size_t> home;
    for (std::size_t j = 0; j < trees.size(); ++j) {
      const double most = options.hover_share * static_cast<double>(trees[j].size());
      if (static_cast<double>(piece.size()) > most) continue;
      for (const int i : piece) {
        const Neighbour found =
            trees[j].nearest(cloud.points[static_cast<std::size_t>(i)], nearest);
        if (found.index < 0) continue;
        nearest = std::sqrt(found.squared_distance);
        home = j;
      }
    }
    if (home)
      standing[*home].insert(standing[*home].end(), piece.begin(), piece.end());
    else
      standing.push_back(std::move(piece));
  }
  return standing;
}

struct Extent {
  Eigen::Vector2d middle;
  double longest_mm = 0, height_mm = 0;
};

// Above the plate, of all but the highest tenth: stereo's noise stands up from the edge of a
// shadow.
double heightOf(const PointCloud& piece, const rig::SheetBend& ground) {
  std::vector<double> heights;
  for (const Eigen::Vector3f& p : piece.points) heights.push_back(heightAbove(ground, p));
  const auto high = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() * 9 / 10);
  std::nth_element(heights.begin(), high, heights.end());
  return *high;
}

Extent extentOf(const PointCloud& piece, const rig::SheetBend& ground) {
  const auto [low, high] = boundsOf(piece.points);
  return {(low + high).head<2>().cast<double>() / 2,
          static_cast<double>((high - low).head<2>().norm()), heightOf(piece, ground)};
}

// A side's limits on the sizes of sherds, and how much of the usual sherd's size a millimetre is.
struct Limits {
  SplitOptions options;
  batch::Side side;
  double usual = 1;  // size of the usual sherd of the batch / that of one of 45 mm
};

// The sherd in which half of all that is seen from above is reached, the largest first: crumbs do
// not count, however many they are.
double usualSize(const PointCloud& cloud, const std::vector<std::vector<int>>& pieces) {
  constexpr double kFilled = 0.6;  // of the square around it
  std::vector<double> areas;
  for (const std::vector<int>& piece : pieces)
    if (piece.size() >= kFewest) areas.push_back(areaFromAbove_mm2(subset(cloud, piece)));
  std::sort(areas.rbegin(), areas.rend());
  double left = std::accumulate(areas.begin(), areas.end(), 0.0) / 2;
  for (const double area : areas)
    if ((left -= area) <= 0) return std::sqrt(area / kFilled) / kUsualSherd_mm;
  return 1;
}

Limits limitsOf(const PointCloud& cloud, const std::vector<std::vector<int>>& pieces,
                batch::Side side, const SplitOptions& options) {
  Limits limits{options, side};
  if (options.lengths == Lengths::Millimetres) return limits;
  limits.usual = usualSize(cloud, pieces);
  SplitOptions& beside = limits.options;
  for (double* length : {&beside.hover_mm, &beside.hover_reach_mm, &beside.min_extent_mm,
                         &beside.min_height_mm, &beside.touching.min_extent_mm})
    *length *= limits.usual;
  beside.min_area_mm2 *= limits.usual * limits.usual;
  return limits;
}

// Without a scale nobody can say that it is too small for a sherd.
void leaveOutRelative(const Limits& limits, double longest, SplitResult& result) {
  const Decimal percent = decimal(100 * longest / (limits.usual * kUsualSherd_mm), 0);
  result.warnings.push_back(inOne(
      limits.side == batch::Side::Front
          ? message("An object of %1 % of the typical sherd's length was left out of the front "
                    "side; without a scale, it may be a sherd.",
                    percent)
          : message("An object of %1 % of the typical sherd's length was left out of the back "
                    "side; without a scale, it may be a sherd.",
                    percent),
      message("If it is one, photograph it alone.")));
  result.doubtful.push_back(result.warnings.back());
}

bool isSmall(const PointCloud& piece, const SplitOptions& options) {
  return extentOf(piece, options.ground).longest_mm < options.min_extent_mm ||
         areaFromAbove_mm2(piece) < options.min_area_mm2;
}

// A piece that is no sherd is reported and left aside.
bool isSherd(const PointCloud& piece, const Limits& limits, SplitResult& result) {
  const Extent extent = extentOf(piece, limits.options.ground);
  const bool small = isSmall(piece, limits.options);
  const bool flat = extent.height_mm < limits.options.min_height_mm;
  if (!small && !flat) return true;
  if (limits.options.lengths == Lengths::Relative) {
    leaveOutRelative(limits, extent.longest_mm, result);
  } else if (small) {
    result.warnings.push_back(
        message("A small object of %1 mm at x %2, y %3 mm was left out; if it is a sherd, "
                "photograph it alone.",
                decimal(extent.longest_mm, 0), decimal(extent.middle.x(), 0),
                decimal(extent.middle.y(), 0)));
  } else {
    result.warnings.push_back(
        message("A flat object at x %1, y %2 mm was left out; it may be a marker or dirt on the "
                "plate.",
                decimal(extent.middle.x(), 0), decimal(extent.middle.y(), 0)));
  }
  return false;
}

// Too few points for a scan. As large as a sherd is what a coarse reconstruction leaves of one.
void leaveOutSparse(const PointCloud& piece, const Limits& limits, SplitResult& result) {
  const Extent extent = extentOf(piece, limits.options.ground);
  if (limits.options.lengths == Lengths::Relative || isSmall(piece, limits.options) ||
      extent.height_mm < limits.options.min_height_mm)
    return;
  result.warnings.push_back(
      message("A sparse object of %1 points at x %2, y %3 mm was left out; if it is a sherd, "
              "photograph it closer.",
              piece.size(), decimal(extent.middle.x(), 0), decimal(extent.middle.y(), 0)));
}

// Whether a piece lies on or under another, seen from above.
bool isWithin(const PointCloud& piece, const PointCloud& thing) {
  constexpr double kCell_mm = 1, kMost = 0.9;
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3f& p : thing.points) points.push_back(p.head<2>().cast<double>());
  const Footprint footprint(points, kCell_mm);
  const auto held = std::count_if(piece.points.begin(), piece.points.end(), [&](const auto& p) {
    return footprint.depth(p.template head<2>().template cast<double>()) > 0;
  });
  return static_cast<double>(held) >= kMost * static_cast<double>(piece.size());
}

// Pieces of one thing become one. A crumb on or under its thing is noise; one beside it may be a
// sherd behind which no photograph looks, and is reported as any other.
std::vector<PointCloud> joinedByOutlines(const PointCloud& cloud,
                                         const std::vector<std::vector<int>>& pieces,
                                         const SplitOptions& options, std::size_t& flying) {
  std::vector<PointCloud> whole, left;
  for (const std::vector<int>& piece : pieces) whole.push_back(subset(cloud, piece));
  const std::vector<std::size_t> thing = thingsOf(whole, options.images, options.masks);
  std::vector<std::vector<int>> joined = pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::vector<int>& home = joined[thing[i]];
    if (thing[i] == i) continue;
    if (!isSmall(whole[i], options))
      home.insert(home.end(), pieces[i].begin(), pieces[i].end());
    else if (isWithin(whole[i], whole[thing[i]]))
      flying += pieces[i].size();
    else
      left.push_back(whole[i]);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (thing[i] == i)
      left.push_back(joined[i].size() == pieces[i].size() ? std::move(whole[i])
                                                          : subset(cloud, joined[i]));
  return left;
}

// One sherd, or several that touch: what was cut is looked at again, for three may lie in a row.
void addParts(PointCloud piece, const Limits& limits, SplitResult& result) {
  const TouchingParts parts = cutTouching(piece, limits.options.touching);
  if (parts.count == 1) {
    result.scans.push_back({{}, std::move(piece), {}, Eigen::Vector3d::UnitZ()});
    return;
  }
  for (const Neck& neck : parts.necks)
    result.warnings.push_back(
        message("Two sherds touch at x %1, y %2 mm and were split there; leave a finger's width "
                "between sherds.",
                decimal(neck.place.x(), 0), decimal(neck.place.y(), 0)));
  for (int k = 0; k < parts.count; ++k) {
    std::vector<int> indices;
    for (std::size_t i = 0; i < piece.size(); ++i)
      if (parts.part[i] == k) indices.push_back(static_cast<int>(i));
    PointCloud part = subset(piece, indices);
    if (isSherd(part, limits, result)) addParts(std::move(part), limits, result);
  }
}

}  // namespace

Result<SplitResult> splitScans(const PointCloud& plate_cloud, batch::Side side,
                               const SplitOptions& options, Progress& progress) {
  if (!plate_cloud.empty() && !plate_cloud.hasNormals())
    return Error::unusable(message("The plate's point cloud has no normals."));
  const PointCloud above = subset(plate_cloud, abovePlate(plate_cloud, options));
  SplitResult result;
  std::size_t flying = 0, sparse = 0;
  auto connected = connectedPieces(above, options.gap_mm);
  const Limits limits = limitsOf(above, connected, side, options);
  const auto pieces = withHoveringJoined(above, std::move(connected), limits.options);
  std::vector<std::vector<int>> large;
  for (const std::vector<int>& indices : pieces)
    if (indices.size() < kFewest) {
      flying += indices.size();
      ++sparse;
      leaveOutSparse(subset(above, indices), limits, result);
    } else {
      large.push_back(indices);
    }
  for (PointCloud& piece : joinedByOutlines(above, std::move(large), limits.options, flying))
    if (isSherd(piece, limits, result)) addParts(std::move(piece), limits, result);
  if (result.scans.empty())
    return Error::notEnough(
        side == batch::Side::Front
            ? message("No sherd was found on the front side; check its masks and "
                      "photographs.")
            : message("No sherd was found on the back side; check its masks and "
                      "photographs."));
  std::stable_sort(result.scans.begin(), result.scans.end(), [&](const Scan& a, const Scan& b) {
    return comesBefore(extentOf(a.cloud, options.ground).middle,
                       extentOf(b.cloud, options.ground).middle);
  });
  for (std::size_t i = 0; i < result.scans.size(); ++i) {
    result.scans[i].id = formatted("%c%03zu", side == batch::Side::Front ? 'f' : 'b', i + 1);
    result.scans[i].fracture = findFracture(result.scans[i].cloud, result.scans[i].up);
  }
  progress.note(NoteLevel::Info, std::string("scans: ") + std::to_string(result.scans.size()) +
                                     " sherds on the " + batch::name(side) + " side, " +
                                     std::to_string(flying) + " outliers removed, " +
                                     std::to_string(sparse) + " pieces of too few points");
  for (const Message& warning : result.warnings) progress.note(NoteLevel::Warning, warning);
  return result;
}

}  // namespace ostraka::scan
