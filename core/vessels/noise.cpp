#include "vessels/noise.h"

#include <array>

namespace ostraka::vessels {
namespace {

float lattice(int x, int y, int z, std::uint32_t seed) {
  return static_cast<float>(cellHash(x, y, z, seed)) * (2.f / 4294967296.f) - 1.f;
}

struct Cell {
  int x, y, z;
  Eigen::Vector3f f;
};

Cell cellOf(const Eigen::Vector3f& p) {
  const float fx = std::floor(p.x()), fy = std::floor(p.y()), fz = std::floor(p.z());
  return {static_cast<int>(fx),
          static_cast<int>(fy),
          static_cast<int>(fz),
          {p.x() - fx, p.y() - fy, p.z() - fz}};
}

std::array<float, 8> corners(const Cell& c, std::uint32_t seed) {
  std::array<float, 8> v;
  for (int i = 0; i < 8; ++i)
    v[i] = lattice(c.x + (i & 1), c.y + ((i >> 1) & 1), c.z + (i >> 2), seed);
  return v;
}

}  // namespace

std::uint32_t cellHash(int x, int y, int z, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1u ^
                    static_cast<std::uint32_t>(y) * 0x85EBCA77u ^
                    static_cast<std::uint32_t>(z) * 0xC2B2AE3Du ^ seed * 0x27D4EB2Fu;
  h = (h ^ (h >> 15)) * 0x85EBCA6Bu;
  h = (h ^ (h >> 13)) * 0xC2B2AE35u;
  return h ^ (h >> 16);
}

NoiseValue noiseWithGradient(const Eigen::Vector3f& p, std::uint32_t seed) {
  const Cell c = cellOf(p);
  const std::array<float, 8> v = corners(c, seed);
  const Eigen::Vector3f s = c.f.array().square() * (3 - 2 * c.f.array());
  const Eigen::Vector3f ds = 6 * c.f.array() * (1 - c.f.array());
  const auto mix = [](float a, float b, float t) { return a + (b - a) * t; };
  const float x00 = mix(v[0], v[1], s.x()), x10 = mix(v[2], v[3], s.x());
  const float x01 = mix(v[4], v[5], s.x()), x11 = mix(v[6], v[7], s.x());
  const float y0 = mix(x00, x10, s.y()), y1 = mix(x01, x11, s.y());
  const float dx =
      mix(mix(v[1] - v[0], v[3] - v[2], s.y()), mix(v[5] - v[4], v[7] - v[6], s.y()), s.z());
  const float dy = mix(x10 - x00, x11 - x01, s.z());
  return {mix(y0, y1, s.z()), {dx * ds.x(), dy * ds.y(), (y1 - y0) * ds.z()}};
}

float noise(const Eigen::Vector3f& p, std::uint32_t seed) {
  return noiseWithGradient(p, seed).value;
}

float fractalNoise(const Eigen::Vector3f& p, std::uint32_t seed, int octaves, float share) {
  float sum = 0, weight = 1;
  Eigen::Vector3f q = p;
  for (int o = 0; o < octaves; ++o) {
    sum += weight * noise(q, seed + static_cast<std::uint32_t>(o) * 101u);
    weight *= share;
    q = q * 2.03f + Eigen::Vector3f(17.3f, 5.1f, 9.7f);
  }
  return sum;
}

}  // namespace ostraka::vessels
