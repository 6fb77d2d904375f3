#pragma once
#include <cmath>

#include "cloud/point_cloud.h"

namespace ostraka::test {

/// A box of 0.5 mm spacing seen from above: its top and its four walls, standing on z = 0.
inline PointCloud box(double x, double y, double width, double depth, double height) {
  PointCloud cloud;
  const auto add = [&](double px, double py, double pz, double nx, double ny, double nz) {
    cloud.points.push_back(Eigen::Vector3d(px, py, pz).cast<float>());
    cloud.normals.push_back(Eigen::Vector3d(nx, ny, nz).cast<float>());
  };
  for (double u = 0; u <= width; u += 0.5) {
    for (double v = 0; v <= depth; v += 0.5) add(x + u, y + v, height, 0, 0, 1);
    for (double z = 0.5; z < height; z += 0.5)
      add(x + u, y, z, 0, -1, 0), add(x + u, y + depth, z, 0, 1, 0);
  }
  for (double v = 0.5; v < depth; v += 0.5) {
    for (double z = 0.5; z < height; z += 0.5)
      add(x, y + v, z, -1, 0, 0), add(x + width, y + v, z, 1, 0, 0);
  }
  return cloud;
}

inline void append(PointCloud& cloud, const PointCloud& more) {
  cloud.points.insert(cloud.points.end(), more.points.begin(), more.points.end());
  cloud.normals.insert(cloud.normals.end(), more.normals.begin(), more.normals.end());
}

}  // namespace ostraka::test
