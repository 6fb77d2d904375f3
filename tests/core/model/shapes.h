#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <random>

#include "cloud/point_cloud.h"

namespace ostraka::model {

// A closed box centred on the origin, two triangles a face.
inline TriangleMesh boxMesh(const Eigen::Vector3f& size) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back(
        size.cwiseProduct(Eigen::Vector3f((k & 1) - 0.5f, ((k >> 1) & 1) - 0.5f, (k >> 2) - 0.5f)));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

struct BoxScan {
  Eigen::Vector3f size = {24, 18, 5};
  float spacing_mm = 0.35f, noise_mm = 0.03f;
  float hole_mm = 0;  // a square hole of this size in the middle of the upper face
};

// What one side of a rig sees of a box: the face turned up and the walls but for the lowest 0.4 mm,
// with noise along the normal. turned: the other face.
inline PointCloud scanOfBox(const BoxScan& o, bool turned, unsigned seed) {
  std::mt19937 random(seed);
  const auto jitter = [&](float width) {
    return width * (static_cast<float>(random() % 20001) / 10000.0f - 1);
  };
  const auto gauss = [&] {  // sum of 12 uniform numbers
    float sum = 0;
    for (int i = 0; i < 12; ++i) sum += jitter(0.5f);
    return o.noise_mm * sum;
  };
  PointCloud cloud;
  const Eigen::Vector3f half = 0.5f * o.size;
  const float up = turned ? -1.0f : 1.0f;
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.0f, 1.0f}) {
      if (axis == 2 && sign != up) continue;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (float a = -half[u] + 0.5f * o.spacing_mm; a < half[u]; a += o.spacing_mm)
        for (float b = -half[v] + 0.5f * o.spacing_mm; b < half[v]; b += o.spacing_mm) {
          Eigen::Vector3f p, n = Eigen::Vector3f::Zero();
          p[axis] = sign * half[axis] + gauss();
          p[u] = a + jitter(0.3f * o.spacing_mm);
          p[v] = b + jitter(0.3f * o.spacing_mm);
          n[axis] = sign;
          if (axis != 2 && up * p[2] < -half[2] + 0.4f) continue;
          if (axis == 2 && std::abs(p[0]) < 0.5f * o.hole_mm && std::abs(p[1]) < 0.5f * o.hole_mm)
            continue;
          n += Eigen::Vector3f(jitter(0.3f), jitter(0.3f), jitter(0.3f));
          cloud.points.push_back(p);
          cloud.normals.push_back(n.normalized());
        }
    }
  return cloud;
}

// Distance from the surface of a box centred on the origin.
inline float distanceToBox(const Eigen::Vector3f& p, const Eigen::Vector3f& size) {
  const Eigen::Vector3f q = p.cwiseAbs() - 0.5f * size;
  const float inside = q.maxCoeff();
  return inside < 0 ? -inside : q.cwiseMax(0.0f).norm();
}

}  // namespace ostraka::model
