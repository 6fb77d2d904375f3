#include "stereo/window.h"

#include <algorithm>
#include <cmath>

namespace ostraka::stereo {
namespace {

/// Variance of the grey values that the sensor and the rounding leave; keeps blank windows apart
/// from textured ones.
constexpr float kNoiseVariance = 1.5F;
/// Below this share of the window's weight a correlation says nothing.
constexpr float kMinShare = 0.5F;

struct Moments {
  float w = 0, i = 0, j = 0, ii = 0, jj = 0, ij = 0;
};

__attribute__((target_clones("arch=x86-64-v3", "default"))) void correlate(
    const Window& window, const std::uint32_t* packed, int width, int height, const AffineMap& m,
    Moments& out) {
  constexpr int n = Window::kLanes;
  alignas(64) float sw[n] = {}, si[n] = {}, sj[n] = {}, sii[n] = {}, sjj[n] = {}, sij[n] = {};
  const float max_x = static_cast<float>(width - 1), max_y = static_cast<float>(height - 1);
  for (int start = 0; start < window.samples; start += n) {
    const float* dx = window.dx + start;
    const float* dy = window.dy + start;
    const float* weight = window.weight + start;
    const float* grey = window.grey + start;
    for (int l = 0; l < n; ++l) {
      float x = m.x0 + m.xx * dx[l] + m.xy * dy[l];
      float y = m.y0 + m.yx * dx[l] + m.yy * dy[l];
      x = x > 0.0F ? x : 0.0F;
      x = x < max_x ? x : max_x;
      y = y > 0.0F ? y : 0.0F;
      y = y < max_y ? y : max_y;
      const int ix = static_cast<int>(x), iy = static_cast<int>(y);
      const float rx = x - static_cast<float>(ix), ry = y - static_cast<float>(iy);
      const std::uint32_t q = packed[iy * width + ix];
      const int a = static_cast<int>(q & 255U), b = static_cast<int>((q >> 8U) & 255U);
      const int c = static_cast<int>((q >> 16U) & 255U), d = static_cast<int>(q >> 24U);
      const float fa = static_cast<float>(a), fc = static_cast<float>(c);
      const float top = fa + rx * (static_cast<float>(b) - fa);
      const float bottom = fc + rx * (static_cast<float>(d) - fc);
      const float v = top + ry * (bottom - top) - window.base;
      const bool whole = (a != 0) & (b != 0) & (c != 0) & (d != 0);
      const float w = whole ? weight[l] : 0.0F;
      const float wi = w * grey[l], wj = w * v;
      sw[l] += w;
      si[l] += wi;
      sj[l] += wj;
      sii[l] += wi * grey[l];
      sjj[l] += wj * v;
      sij[l] += wi * v;
    }
  }
  for (int l = 0; l < n; ++l) {
    out.w += sw[l];
    out.i += si[l];
    out.j += sj[l];
    out.ii += sii[l];
    out.jj += sjj[l];
    out.ij += sij[l];
  }
}

}  // namespace

bool cutWindow(const Frame& frame, int x, int y, const WindowShape& shape, Window& window) {
  window.base = frame.grey(y, x);
  const bool centre_counts = window.base > 0;
  if (!centre_counts) window.base = 128.0F;
  const float by_distance = -0.5F / (shape.sigma_px * shape.sigma_px);
  const float sigma_grey = shape.sigma_grey * window.base;
  const float by_grey =
      shape.sigma_grey > 0 && centre_counts ? -0.5F / (sigma_grey * sigma_grey) : 0.0F;
  const int r = shape.radius_px;
  const int reach2 = r * r + r;  // a disc rather than a square
  int count = 0;
  float total = 0, counted = 0;
  for (int v = -r; v <= r; v += shape.step_px)
    for (int u = -r; u <= r; u += shape.step_px) {
      if (u * u + v * v > reach2) continue;
      float w = std::exp(by_distance * static_cast<float>(u * u + v * v));
      total += w;
      const int px = x + u, py = y + v;
      if (px < 0 || py < 0 || px >= frame.width || py >= frame.height) continue;
      const float grey = frame.grey(py, px);
      if (grey <= 0) continue;
      const float difference = grey - window.base;
      counted += w;
      w *= std::exp(by_grey * difference * difference);
      window.dx[count] = static_cast<float>(u);
      window.dy[count] = static_cast<float>(v);
      window.weight[count] = w;
      window.grey[count] = difference;
      window.total_weight = count == 0 ? w : window.total_weight + w;
      ++count;
    }
  window.samples = (count + Window::kLanes - 1) / Window::kLanes * Window::kLanes;
  for (int k = count; k < window.samples; ++k)
    window.dx[k] = window.dy[k] = window.weight[k] = window.grey[k] = 0;
  return counted > 0.35F * total;
}

float dissimilarity(const Window& window, const Frame& other, const AffineMap& map) {
  Moments m;
  correlate(window, other.packed.data(), other.width, other.height, map, m);
  if (m.w < kMinShare * window.total_weight) return -1.0F;
  const float inverse = 1.0F / m.w;
  const float vi = m.ii * inverse - m.i * m.i * inverse * inverse;
  const float vj = m.jj * inverse - m.j * m.j * inverse * inverse;
  const float covariance = m.ij * inverse - m.i * m.j * inverse * inverse;
  return 1.0F - covariance / std::sqrt((std::max(vi, 0.0F) + kNoiseVariance) *
                                       (std::max(vj, 0.0F) + kNoiseVariance));
}

}  // namespace ostraka::stereo
