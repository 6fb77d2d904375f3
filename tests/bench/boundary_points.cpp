// boundary_points SCANS SET...: what scan::findBoundary (neighbours alone) and PCL's
// BoundaryEstimation take for the boundary of the scans, with the same neighbours and angle. PCL
// projects onto the plane of a point's own normal, we onto that of its neighbours.
#include <pcl/features/boundary.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <cstdio>
#include <filesystem>
#include <vector>

#include "cloud/ply.h"
#include "scan/boundary.h"

namespace {

using namespace ostraka;

std::vector<std::uint8_t> byPcl(const PointCloud& cloud, const scan::BoundaryOptions& options) {
  pcl::PointCloud<pcl::PointNormal>::Ptr points(new pcl::PointCloud<pcl::PointNormal>);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    pcl::PointNormal p;
    p.getVector3fMap() = cloud.points[i];
    p.getNormalVector3fMap() = cloud.normals[i];
    points->push_back(p);
  }
  pcl::BoundaryEstimation<pcl::PointNormal, pcl::PointNormal, pcl::Boundary> estimation;
  estimation.setInputCloud(points);
  estimation.setInputNormals(points);
  estimation.setSearchMethod(
      pcl::search::KdTree<pcl::PointNormal>::Ptr(new pcl::search::KdTree<pcl::PointNormal>));
  estimation.setKSearch(options.neighbours + 1);
  estimation.setAngleThreshold(static_cast<float>(options.gap_rad));
  pcl::PointCloud<pcl::Boundary> found;
  estimation.compute(found);
  std::vector<std::uint8_t> boundary;
  for (const pcl::Boundary& b : found) boundary.push_back(b.boundary_point);
  return boundary;
}

}  // namespace

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  if (argc < 3) return std::fprintf(stderr, "usage: boundary_points SCANS SET...\n"), 2;
  std::printf(
      "| set | side | scans | points | ours | PCL | both |\n|---|---|---|---|---|---|---|\n");
  for (int k = 2; k < argc; ++k)
    for (const char* side : {"front", "back"}) {
      long scans = 0, points = 0, ours = 0, pcl_points = 0, both = 0;
      std::vector<fs::path> files;
      for (const auto& entry : fs::directory_iterator(fs::path(argv[1]) / argv[k] / side))
        if (entry.path().extension() == ".ply") files.push_back(entry.path());
      for (const fs::path& file : files) {
        const auto cloud = readPlyCloud(file);
        if (!cloud)
          return std::fprintf(stderr, "%s\n", cloud.error().sentence().english().c_str()), 1;
        if (!cloud->hasNormals()) continue;
        const auto own = scan::findBoundary(*cloud, {}, {}), other = byPcl(*cloud, {});
        ++scans;
        points += static_cast<long>(cloud->size());
        for (std::size_t i = 0; i < own.size(); ++i) {
          ours += own[i] != 0;
          pcl_points += other[i] != 0;
          both += own[i] != 0 && other[i] != 0;
        }
      }
      std::printf("| %s | %s | %ld | %ld | %ld | %ld | %ld |\n", argv[k], side, scans, points, ours,
                  pcl_points, both);
    }
  return 0;
}
