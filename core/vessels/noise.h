#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>

/// Chance that depends on nothing but its numbers: the same bytes for any order and any thread.
namespace ostraka::vessels {

/// Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014 (finaliser).
inline std::uint64_t mixed(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ull;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
  return x ^ (x >> 31);
}
inline std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  return mixed(mixed(a) ^ b);
}

/// A stream of numbers from a seed.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mixed(seed)) {}
  std::uint64_t next() { return mixed(state_++); }
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  int below(int count) { return static_cast<int>(uniform() * count); }
  bool chance(double probability) { return uniform() < probability; }
  /// Standard normal, Box-Muller.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

 private:
  std::uint64_t state_;
};

/// About standard normal, within 3.46: the sum of a hash's four 16-bit parts. For millions of
/// pixels.
inline float quickNormal(std::uint64_t hash) {
  const float sum = static_cast<float>((hash & 0xFFFF) + ((hash >> 16) & 0xFFFF) +
                                       ((hash >> 32) & 0xFFFF) + (hash >> 48));
  return (sum - 131070.f) * (1.7320508f / 65536.f);
}

/// 0 below low, 1 above high, level at both; the other way round with low > high.
inline float smoothStep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.f, 1.f);
  return t * t * (3 - 2 * t);
}

struct NoiseValue {
  float value = 0;  ///< about -1..1, standard deviation about 0.36
  Eigen::Vector3f gradient = Eigen::Vector3f::Zero();
};

/// Smooth value noise on the unit lattice with its analytic gradient.
NoiseValue noiseWithGradient(const Eigen::Vector3f& p, std::uint32_t seed);
float noise(const Eigen::Vector3f& p, std::uint32_t seed);
/// Octaves of doubling frequency, each of `share` of the last one's weight, not normalised: the
/// first has weight 1.
float fractalNoise(const Eigen::Vector3f& p, std::uint32_t seed, int octaves, float share = 0.5f);
/// Three independent bits fields of a lattice cell, uniform in [0, 1).
std::uint32_t cellHash(int x, int y, int z, std::uint32_t seed);

}  // namespace ostraka::vessels
