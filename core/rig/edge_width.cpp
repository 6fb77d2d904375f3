#include "rig/edge_width.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"

namespace ostraka::rig {
namespace {

float valueAt(const cv::Mat1b& grey, double x, double y) {
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const auto u = static_cast<float>(x - x0), v = static_cast<float>(y - y0);
  return (1 - v) * ((1 - u) * grey(y0, x0) + u * grey(y0, x0 + 1)) +
         v * ((1 - u) * grey(y0 + 1, x0) + u * grey(y0 + 1, x0 + 1));
}

// Contrast over the steepest slope across one place of a marker's outer edge; 0 where none is.
double widthAt(const cv::Mat1b& grey, const Eigen::Vector2d& place, const Eigen::Vector2d& out,
               double reach) {
  constexpr double kStep = 0.5;
  const int n = static_cast<int>(2 * reach / kStep) + 1;
  std::vector<float> profile(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector2d p = place + (i * kStep - reach) * out;
    if (p.x() < 0 || p.y() < 0 || p.x() >= grey.cols - 1 || p.y() >= grey.rows - 1) return 0;
    profile[static_cast<std::size_t>(i)] = valueAt(grey, p.x(), p.y());
  }
  const auto [low, high] = std::minmax_element(profile.begin(), profile.end());
  const float contrast = *high - *low;
  float slope = 0;  // over two pixels: noise does not make an edge steep
  for (std::size_t i = 4; i < profile.size(); ++i)
    slope = std::max(slope, std::abs(profile[i] - profile[i - 4]) / 2);
  return contrast < 30 || slope <= 0 ? 0 : contrast / slope;
}

}  // namespace

std::vector<double> edgeWidths(const cv::Mat1b& grey,
                               const std::array<Eigen::Vector2d, 4>& corners) {
  std::vector<double> widths;
  for (std::size_t c = 0; c < 4; ++c) {
    const Eigen::Vector2d a = corners[c], b = corners[(c + 1) % 4];
    const Eigen::Vector2d along = (b - a).normalized(), out(along.y(), -along.x());
    const double reach = std::clamp((b - a).norm() / 7, 3.0, 12.0);  // within border and margin
    for (const double t : {0.3, 0.5, 0.7})
      if (const double w = widthAt(grey, a + t * (b - a), out, reach); w > 0) widths.push_back(w);
  }
  return widths;
}

double typicalWidth(std::vector<double> widths) {
  if (widths.size() < 12) return 0;
  return medianOf(widths);
}

}  // namespace ostraka::rig
