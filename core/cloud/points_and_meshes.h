#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace ostraka {

using Color = std::array<std::uint8_t, 3>;  ///< red, green, blue, sRGB

/// Oriented points, mm. normals, colors and quality are empty or as long as points.
struct PointCloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals;  ///< unit length, outward
  std::vector<Color> colors;
  std::vector<float> quality;  ///< confidence 0..1

  std::size_t size() const { return points.size(); }
  bool empty() const { return points.empty(); }
  bool hasNormals() const { return !points.empty() && normals.size() == points.size(); }
};

/// Indexed triangles, counter-clockwise seen from outside, mm.
struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Vector3f> normals;       ///< per vertex; empty or as long as vertices
  std::vector<Color> colors;                  ///< per vertex; empty or as long as vertices
  std::vector<std::uint8_t> seen;             ///< per vertex, 0 = filled in; empty or as vertices
  std::vector<std::array<int, 3>> triangles;  ///< indices of vertices
};

}  // namespace ostraka
