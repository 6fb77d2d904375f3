#include "stereo/window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/processors.h"

namespace ostraka::stereo {
namespace {

/// Variance of the grey values that the sensor and the rounding leave; keeps blank windows apart
/// from textured ones.
constexpr float kNoiseVariance = 1.5F;
/// Below this share of the window's weight a correlation says nothing.
constexpr float kMinShare = 0.5F;

/// Eight lanes; the compiler splits them where the processor has four.
using Floats = float __attribute__((vector_size(32)));
using Ints = std::int32_t __attribute__((vector_size(32)));

/// The sums over a window's samples of w, w i, w j, w i i, w j j, w i j, eight partial sums each.
struct LaneSums {
  Floats w{}, i{}, j{}, ii{}, jj{}, ij{};
};

OSTRAKA_CLONED void correlate(const Window& window, const std::uint32_t* packed, int width,
                              int height, const AffineMap& m, LaneSums& out) {
  const auto load = [](const float* from, Floats& value) {
    std::memcpy(&value, from, sizeof value);
  };
  LaneSums sum;
  const Floats zero{}, max_x = zero + static_cast<float>(width - 1);
  const Floats max_y = zero + static_cast<float>(height - 1);
  for (int k = 0; k < window.samples; k += Window::kLanes) {
    Floats dx, dy, grey, weight;
    load(window.dx + k, dx);
    load(window.dy + k, dy);
    load(window.grey + k, grey);
    load(window.weight + k, weight);
    Floats x = m.x0 + m.xx * dx + m.xy * dy, y = m.y0 + m.yx * dx + m.yy * dy;
    x = x > zero ? x : zero;  // what is not on the picture comes to lie on its blank border
    x = x < max_x ? x : max_x;
    y = y > zero ? y : zero;
    y = y < max_y ? y : max_y;
    const Ints ix = __builtin_convertvector(x, Ints), iy = __builtin_convertvector(y, Ints);
    const Floats rx = x - __builtin_convertvector(ix, Floats);
    const Floats ry = y - __builtin_convertvector(iy, Floats);
    const Ints place = iy * width + ix;
    Ints q;
    for (int l = 0; l < Window::kLanes; ++l) q[l] = static_cast<std::int32_t>(packed[place[l]]);
    const Ints low = q & 0x00ff00ff, high = (q >> 8) & 0x00ff00ff;
    const Floats a = __builtin_convertvector(low & 255, Floats);
    const Floats b = __builtin_convertvector(high & 255, Floats);
    const Floats c = __builtin_convertvector(low >> 16, Floats);
    const Floats d = __builtin_convertvector(high >> 16, Floats);
    const Floats least_ab = a < b ? a : b, least_cd = c < d ? c : d;
    const Floats least = least_ab < least_cd ? least_ab : least_cd;
    const Floats top = a + rx * (b - a), bottom = c + rx * (d - c);
    const Floats v = top + ry * (bottom - top) - window.base;
    const Floats w = least > zero ? weight : zero;
    const Floats wi = w * grey, wj = w * v;
    sum.w += w;
    sum.i += wi;
    sum.j += wj;
    sum.ii += wi * grey;
    sum.jj += wj * v;
    sum.ij += wi * v;
  }
  out = sum;
}

/// The places of a window and their weights, row by row.
struct Disc {
  static constexpr int kRadius_px = 3;
  static constexpr float kSigma_px = 2;
  static constexpr int kRow = 2 * kRadius_px + 1;
  struct Place {
    int dx, dy;
    float weight;
  };
  std::array<Place, kRow * kRow> places;
  int count = 0;
  float weight = 0;

  Disc() {
    for (int v = -kRadius_px; v <= kRadius_px; ++v)
      for (int u = -kRadius_px; u <= kRadius_px; ++u) {
        const int reach = u * u + v * v;
        if (reach > kRadius_px * kRadius_px + kRadius_px) continue;
        const float w = std::exp(-0.5F / (kSigma_px * kSigma_px) * static_cast<float>(reach));
        places[count++] = {u, v, w};
        weight += w;
      }
  }
};
static_assert(Disc::kRow * Disc::kRow + Window::kLanes <= Window::kMaxSamples);

/// In the order of the lanes.
float total(const Floats& lanes) {
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) +
         ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

}  // namespace

bool cutWindow(const Frame& frame, int x, int y, Window& window) {
  static const Disc kDisc;
  window.base = frame.grey(y, x);
  if (window.base <= 0) window.base = 128.0F;
  int count = 0;
  float counted = 0;
  for (int k = 0; k < kDisc.count; ++k) {
    const Disc::Place& place = kDisc.places[k];
    const int px = x + place.dx, py = y + place.dy;
    if (px < 0 || py < 0 || px >= frame.width || py >= frame.height) continue;
    const float grey = frame.grey(py, px);
    if (grey <= 0) continue;
    window.dx[count] = static_cast<float>(place.dx);
    window.dy[count] = static_cast<float>(place.dy);
    window.weight[count] = place.weight;
    window.grey[count] = grey - window.base;
    counted += place.weight;
    ++count;
  }
  window.total_weight = counted;
  window.samples = (count + Window::kLanes - 1) / Window::kLanes * Window::kLanes;
  for (int k = count; k < window.samples; ++k)
    window.dx[k] = window.dy[k] = window.weight[k] = window.grey[k] = 0;
  return counted > 0.35F * kDisc.weight;
}

float dissimilarity(const Window& window, const Frame& other, const AffineMap& map) {
  LaneSums sum;
  correlate(window, other.packed.data(), other.width, other.height, map, sum);
  const float w = total(sum.w);
  if (w < kMinShare * window.total_weight) return -1.0F;
  const float inverse = 1.0F / w;
  const float i = total(sum.i) * inverse, j = total(sum.j) * inverse;
  const float vi = total(sum.ii) * inverse - i * i, vj = total(sum.jj) * inverse - j * j;
  const float covariance = total(sum.ij) * inverse - i * j;
  return 1.0F - covariance / std::sqrt((std::max(vi, 0.0F) + kNoiseVariance) *
                                       (std::max(vj, 0.0F) + kNoiseVariance));
}

}  // namespace ostraka::stereo
