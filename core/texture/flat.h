#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>

namespace ostraka::texture {

/// Twice the signed area; positive for counter-clockwise corners.
template <class Scalar>
Scalar crossOf(const std::array<Eigen::Matrix<Scalar, 2, 1>, 3>& t) {
  return (t[1].x() - t[0].x()) * (t[2].y() - t[0].y()) -
         (t[1].y() - t[0].y()) * (t[2].x() - t[0].x());
}

/// Calls visit(x, y, weights) for each whole (x, y) within the triangle or so little outside it
/// that a weight is no less than -slack; width and height bound them. weights: barycentric.
template <class Visit>
void forEachInside(const std::array<Eigen::Vector2d, 3>& t, int width, int height, double slack,
                   Visit visit) {
  const double cross = crossOf(t);
  if (!(std::abs(cross) >= 1e-12)) return;
  const Eigen::Vector2d low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
  const Eigen::Vector2d high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  if (!low.allFinite() || !high.allFinite()) return;
  const double reach = slack > 0 ? 1 : 0;
  const double x0 = std::max(0.0, std::ceil(low.x() - reach));
  const double y0 = std::max(0.0, std::ceil(low.y() - reach));
  const double x1 = std::min<double>(width - 1, std::floor(high.x() + reach));
  const double y1 = std::min<double>(height - 1, std::floor(high.y() + reach));
  if (!(x0 <= x1 && y0 <= y1)) return;
  for (int y = static_cast<int>(y0); y <= static_cast<int>(y1); ++y)
    for (int x = static_cast<int>(x0); x <= static_cast<int>(x1); ++x) {
      const Eigen::Vector2d p(x, y);
      Eigen::Vector3d w;
      for (std::size_t k = 0; k < 3; ++k)
        w[static_cast<Eigen::Index>(k)] =
            crossOf<double>({p, t[(k + 1) % 3], t[(k + 2) % 3]}) / cross;
      if (w.minCoeff() >= -slack) visit(x, y, w);
    }
}

}  // namespace ostraka::texture
