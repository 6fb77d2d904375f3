#include "pairing/turning_angles.h"

#include <cmath>
#include <limits>

#include "base/message.h"
#include "pairing/contour.h"

namespace ostraka::pairing {

Result<std::vector<double>> turningAngles(std::span<const Eigen::Vector2d> contour, int n) {
  if (contour.size() < 3 || n < 3) {
    return Error::notEnough(message("A contour needs at least three points."));
  }
  const std::vector<Eigen::Vector2d> p = resampled(contour, n);
  std::vector<double> angles(p.size());
  const std::size_t count = p.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d in = p[i] - p[(i + count - 1) % count];
    const Eigen::Vector2d out = p[(i + 1) % count] - p[i];
    angles[i] = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
  }
  return angles;
}

std::vector<double> accumulated(std::span<const double> angles, int shift) {
  const std::size_t n = angles.size();
  std::vector<double> sums(n);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sum += angles[(i + static_cast<std::size_t>(shift)) % n];
    sums[i] = sum;
  }
  return sums;
}

std::vector<double> shiftCosts(std::span<const double> a, std::span<const double> b,
                               Offset offset) {
  const std::size_t n = a.size();
  if (n == 0 || b.size() != n) return std::vector<double>(n, std::numeric_limits<double>::max());
  const std::vector<double> sums_a = accumulated(a, 0);
  std::vector<double> costs(n);
  for (std::size_t shift = 0; shift < n; ++shift) {
    const std::vector<double> sums_b = accumulated(b, static_cast<int>(shift));
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double d = sums_a[i] - sums_b[i];
      sum += d;
      squares += d * d;
    }
    const double count = static_cast<double>(n);
    const double mean = offset == Offset::Free ? sum / count : 0.0;
    costs[shift] = std::sqrt(std::max(0.0, squares / count - mean * mean));
  }
  return costs;
}

}  // namespace ostraka::pairing
