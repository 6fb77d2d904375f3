#include "ground/bare_rows.h"

#include <algorithm>

#include "base/processors.h"
#include "ground/exponential.h"

namespace ostraka::ground {
namespace {

constexpr float kFar = 18;  // chi-square of three tolerances in both: no weight beyond

struct Channels {
  const float *a, *b, *c;
  explicit Channels(const ColourRow& row)
      : a(row.channel[0].data()), b(row.channel[1].data()), c(row.channel[2].data()) {}
};

struct Sums {
  float* __restrict a, * __restrict b, * __restrict c, * __restrict weight, * __restrict squares;
};

// Brightness along (1,1,1), colour across it, each against its tolerance (1 / square).
inline float chiSquare(float a, float b, float c, float per_brightness, float per_colour) {
  const float g = (a + b + c) * (1 / 3.F);
  return g * g * per_brightness +
         ((a - g) * (a - g) + (b - g) * (b - g) + (c - g) * (c - g)) * per_colour;
}

OSTRAKA_CLONED void addLook(const Channels value, const Channels light, const Channels before,
                            const Channels anchor, const Tolerance near, const Tolerance far,
                            float unseen, int size, const Sums sums) {
  const float near_g = 1 / (near.brightness * near.brightness),
              near_c = 1 / (near.colour * near.colour),
              far_g = 1 / (far.brightness * far.brightness), far_c = 1 / (far.colour * far.colour);
  for (int x = 0; x < size; ++x) {
    const float a = value.a[x] - light.a[x], b = value.b[x] - light.b[x],
                c = value.c[x] - light.c[x];
    const float one = chiSquare(a - before.a[x], b - before.b[x], c - before.c[x], near_g, near_c);
    const float two = chiSquare(a - anchor.a[x], b - anchor.b[x], c - anchor.c[x], far_g, far_c);
    const float like = expOf(-0.5F * (one + two));
    const float w = ((one > kFar) | (two > kFar) | (value.a[x] == unseen)) ? 0.F : like;
    sums.a[x] += w * a;
    sums.b[x] += w * b;
    sums.c[x] += w * c;
    sums.weight[x] += w;
    sums.squares[x] += w * w;
  }
}

}  // namespace

float bareWeight(const cv::Vec3f& residual, const Tolerance& tolerance) {
  const float chi = chiSquare(residual[0], residual[1], residual[2],
                              1 / (tolerance.brightness * tolerance.brightness),
                              1 / (tolerance.colour * tolerance.colour));
  return chi > kFar ? 0.F : expOf(-0.5F * chi);
}

ColourRow::ColourRow(int size) {
  for (std::vector<float>& values : channel) values.resize(static_cast<std::size_t>(size));
}

void ColourRow::read(const cv::Vec3f* colours) {
  const int size = static_cast<int>(channel[0].size());
  float *a = channel[0].data(), *b = channel[1].data(), *c = channel[2].data();
  for (int x = 0; x < size; ++x) a[x] = colours[x][0], b[x] = colours[x][1], c[x] = colours[x][2];
}

BareRow::BareRow(int size)
    : size_(size), before_(size), anchor_(size), sum_(size), weight_(size), squares_(size) {}

void BareRow::start(const cv::Vec3f* before, const cv::Vec3f* anchor) {
  before_.read(before);
  anchor_.read(anchor);
  for (std::vector<float>* sums :
       {&sum_.channel[0], &sum_.channel[1], &sum_.channel[2], &weight_, &squares_})
    std::fill(sums->begin(), sums->end(), 0.F);
}

void BareRow::add(const ColourRow& value, const ColourRow& light, float unseen,
                  const Tolerance& tolerance, const Tolerance& from_anchor) {
  addLook(Channels(value), Channels(light), Channels(before_), Channels(anchor_), tolerance,
          from_anchor, unseen, size_,
          {sum_.channel[0].data(), sum_.channel[1].data(), sum_.channel[2].data(), weight_.data(),
           squares_.data()});
}

void BareRow::addCertain(const ColourRow& value, const ColourRow& light, float unseen,
                         float weight) {
  for (int x = 0; x < size_; ++x) {
    if (value.channel[0][x] == unseen) continue;
    for (int c = 0; c < 3; ++c)
      sum_.channel[c][x] += weight * (value.channel[c][x] - light.channel[c][x]);
    weight_[x] += weight;
    squares_[x] += weight;
  }
}

void BareRow::write(cv::Vec3f* sum, float* weight, float* trusted) const {
  for (int x = 0; x < size_; ++x) {
    sum[x] = {sum_.channel[0][x], sum_.channel[1][x], sum_.channel[2][x]};
    weight[x] = weight_[x];
    trusted[x] = weight_[x] > 0 ? squares_[x] : 0.F;
  }
}

}  // namespace ostraka::ground
