#include "evaluate/identify.h"

#include <algorithm>

#include "cloud/surface.h"

namespace ostraka::evaluate {
namespace {

constexpr double kReach_mm = 1.5;     // as the overlap of models, metrics.md
constexpr std::size_t kAsked = 2000;  // points of a scan that are looked at

std::vector<Eigen::Vector3d> somePoints(const PointCloud& cloud) {
  std::vector<Eigen::Vector3d> points;
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / kAsked);
  for (std::size_t i = 0; i < cloud.size(); i += step)
    points.push_back(cloud.points[i].cast<double>());
  return points;
}

double shareOn(const Surface& surface, const std::vector<Eigen::Vector3d>& points, int threads) {
  if (points.empty()) return 0;
  const std::vector<SurfacePoint> found = surface.closest(points, threads);
  const auto near = std::count_if(found.begin(), found.end(),
                                  [](const SurfacePoint& p) { return p.distance_mm <= kReach_mm; });
  return static_cast<double>(near) / static_cast<double>(points.size());
}

// For each sherd the scan that is its, -1 for none.
std::vector<int> scanOfSherd(const std::vector<NamedScan>& scans,
                             const std::vector<TriangleMesh>& placed, int threads) {
  std::vector<Surface> surfaces;
  for (const TriangleMesh& mesh : placed) surfaces.emplace_back(mesh);
  std::vector<int> scan_of(placed.size(), -1);
  for (std::size_t s = 0; s < scans.size(); ++s) {
    const std::vector<Eigen::Vector3d> points = somePoints(scans[s].cloud);
    std::size_t best = 0;
    double best_share = 0;
    for (std::size_t t = 0; t < surfaces.size(); ++t) {
      const double share = shareOn(surfaces[t], points, threads);
      if (share > best_share) {
        best_share = share;
        best = t;
      }
    }
    if (best_share < 0.5) continue;
    int& taken = scan_of[best];
    if (taken < 0 || scans[taken].cloud.size() < scans[s].cloud.size()) taken = static_cast<int>(s);
  }
  return scan_of;
}

std::vector<std::string> namesLeft(const std::vector<NamedScan>& scans,
                                   const std::vector<bool>& used) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scans.size(); ++i)
    if (!used[i]) names.push_back(scans[i].name);
  return names;
}

}  // namespace

PairsTruth truthOfScans(const std::vector<NamedScan>& fronts, const std::vector<NamedScan>& backs,
                        const std::vector<TrueSherd>& sherds, int threads) {
  std::vector<TriangleMesh> in_front, in_back;
  for (const TrueSherd& sherd : sherds) {
    in_front.push_back(transformed(sherd.mesh, sherd.plate_front_from_model));
    in_back.push_back(transformed(sherd.mesh, sherd.plate_back_from_model));
  }
  const std::vector<int> front_of = scanOfSherd(fronts, in_front, threads);
  const std::vector<int> back_of = scanOfSherd(backs, in_back, threads);
  PairsTruth truth;
  std::vector<bool> front_used(fronts.size(), false), back_used(backs.size(), false);
  for (std::size_t t = 0; t < sherds.size(); ++t) {
    if (front_of[t] < 0 || back_of[t] < 0) {
      ++truth.unseen_pairs;
      continue;
    }
    front_used[front_of[t]] = back_used[back_of[t]] = true;
    const std::string& front = fronts[front_of[t]].name;
    const std::string& back = backs[back_of[t]].name;
    truth.pairs.push_back({front, back, front, back, sherds[t].frontFromBack()});
  }
  truth.unpaired_front = namesLeft(fronts, front_used);
  truth.unpaired_back = namesLeft(backs, back_used);
  return truth;
}

}  // namespace ostraka::evaluate
