#pragma once
#include <bit>
#include <cstdint>

namespace ostraka::ground {

/// e to the x, relative error below 3e-7; x is held within +-87. Plain arithmetic, so that loops
/// over it are vectorised and give the same bits on every processor.
inline float expOf(float x) {
  x = x < -87.F ? -87.F : x;
  x = x > 87.F ? 87.F : x;
  constexpr float kRounding = 12582912.F;  // 1.5 * 2^23: adding it rounds to a whole number
  const float shifted = x * 1.44269504F + kRounding;
  const float whole = shifted - kRounding;
  const float rest = (x - whole * 0.693359375F) + whole * 2.12194440e-4F;  // log 2 in two parts
  // Taylor to the sixth power: |rest| <= 0.35.
  float p = 1.F / 720;
  p = p * rest + 1.F / 120;
  p = p * rest + 1.F / 24;
  p = p * rest + 1.F / 6;
  p = p * rest + 0.5F;
  p = p * rest + 1;
  p = p * rest + 1;
  const std::int32_t power = std::bit_cast<std::int32_t>(shifted) - 0x4B400000;
  return std::bit_cast<float>((power + 127) << 23) * p;
}

/// Natural logarithm of a positive, normal number, error below 3e-7 of 1 + |result|.
inline float logOf(float x) {
  const std::int32_t bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t power = (bits - 0x3F3504F3) >> 23;  // the rest lies in sqrt(1/2) .. sqrt(2)
  const float rest = std::bit_cast<float>(bits - (power << 23));
  const float s = (rest - 1) / (rest + 1), z = s * s;
  const float series = 2 * s * (1 + z * (1.F / 3 + z * (1.F / 5 + z * (1.F / 7 + z * (1.F / 9)))));
  return static_cast<float>(power) * 0.693147181F + series;
}

}  // namespace ostraka::ground
