#include "vessels/clay.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ostraka::vessels {
namespace {

// Linear albedos of fired clays: orange, buff, red, brown, grey, pale.
const std::array<Eigen::Vector3f, 6> kBodies{
    Eigen::Vector3f(0.42f, 0.17f, 0.07f),  Eigen::Vector3f(0.44f, 0.31f, 0.17f),
    Eigen::Vector3f(0.33f, 0.09f, 0.05f),  Eigen::Vector3f(0.24f, 0.15f, 0.09f),
    Eigen::Vector3f(0.16f, 0.16f, 0.165f), Eigen::Vector3f(0.46f, 0.39f, 0.28f)};
const std::array<Eigen::Vector3f, 3> kSlips{Eigen::Vector3f(0.24f, 0.05f, 0.03f),
                                            Eigen::Vector3f(0.50f, 0.42f, 0.31f),
                                            Eigen::Vector3f(0.10f, 0.08f, 0.07f)};
const std::array<Eigen::Vector3f, 3> kPaints{Eigen::Vector3f(0.04f, 0.035f, 0.03f),
                                             Eigen::Vector3f(0.16f, 0.05f, 0.03f),
                                             Eigen::Vector3f(0.60f, 0.55f, 0.45f)};
const std::array<Eigen::Vector3f, 4> kTempers{
    Eigen::Vector3f(0.55f, 0.53f, 0.50f), Eigen::Vector3f(0.07f, 0.065f, 0.06f),
    Eigen::Vector3f(0.30f, 0.10f, 0.06f), Eigen::Vector3f(0.32f, 0.29f, 0.25f)};

constexpr float kSoil = 0.65f;  // share of light that a break's own roughness and soil leave
// Of one sample of a pixel; the mean of four has half of it.
constexpr float kFaceGlitter = 0.13f, kBreakGlitter = 0.2f;

// One inclusion per cell at most, wholly inside its cell, so that a look into one cell suffices.
void mixTemper(const Eigen::Vector3f& p, float cell_mm, float share, std::uint32_t seed,
               Eigen::Vector3f& albedo) {
  const Eigen::Vector3f q = p / cell_mm;
  const Eigen::Vector3f cell = q.array().floor();
  const std::uint32_t h = cellHash(static_cast<int>(cell.x()), static_cast<int>(cell.y()),
                                   static_cast<int>(cell.z()), seed);
  if (static_cast<float>(h & 0xFFFF) > share * 65536.f) return;
  const std::uint32_t k = cellHash(static_cast<int>(h >> 16), 3, 5, seed);
  const float radius = 0.18f + 0.24f * static_cast<float>(k & 0xFF) / 255.f;
  const Eigen::Vector3f middle =
      Eigen::Vector3f::Constant(radius) + (1 - 2 * radius) *
                                              Eigen::Vector3f(static_cast<float>((k >> 8) & 0xFF),
                                                              static_cast<float>((k >> 16) & 0xFF),
                                                              static_cast<float>(k >> 24)) /
                                              255.f;
  Eigen::Vector3f d = q - cell - middle;
  d[static_cast<int>(k % 3)] *=
      1.f + static_cast<float>((h >> 20) & 7) * 0.12f;  // grains are not round
  const float inside = smoothStep(1.f, 0.8f, d.norm() / radius);
  if (inside <= 0) return;
  const Eigen::Vector3f& color = kTempers[(h >> 24) & 3];
  albedo += 0.85f * inside * (color - albedo);
}

// 1 where the brush went.
float painted(const Clay& clay, const ClayPlace& place, const Eigen::Vector3f& p) {
  const float wobble = 0.8f * noise(p / 6, clay.seed + 51);
  float up = place.up_mm + clay.paint_phase_mm + wobble;
  if (clay.paint == Paint::Waves) up += 2.2f * std::sin(place.around_mm / 5);
  if (clay.paint == Paint::Zigzag)
    up += 4.f * std::abs(std::remainder(place.around_mm, 12.f)) / 6.f;
  const float off = std::abs(std::remainder(up, clay.paint_period_mm));
  const float width = clay.paint_width_mm * (1 + 0.5f * noise(p / 9, clay.seed + 52));
  const float dry = smoothStep(-0.75f, -0.45f, fractalNoise(p / 0.8f, clay.seed + 53, 2));
  return smoothStep(width / 2 + 0.15f, width / 2 - 0.15f, off) * dry;
}

}  // namespace

Clay makeClay(bool plain, Random& random) {
  Clay clay;
  clay.seed = static_cast<std::uint32_t>(random.next());
  clay.body = kBodies[random.below(static_cast<int>(kBodies.size()))] *
              static_cast<float>(random.uniform(0.85, 1.15));
  for (int c = 0; c < 3; ++c) clay.body[c] *= static_cast<float>(random.uniform(0.92, 1.08));
  clay.core = 0.45f * clay.body + Eigen::Vector3f::Constant(0.03f);
  clay.slip = kSlips[random.below(static_cast<int>(kSlips.size()))];
  clay.paint_color = kPaints[random.below(static_cast<int>(kPaints.size()))];
  clay.core_strength = static_cast<float>(random.uniform(0, 0.9));
  const double decorated = random.uniform(), where = random.uniform(), kind = random.uniform();
  clay.slip_outside = decorated < 0.45;
  clay.slip_inside = decorated < 0.45 && where < 0.4;
  clay.slip_worn = static_cast<float>(random.uniform(0.1, 0.5));
  if (decorated > 0.3 && decorated < 0.75)
    clay.paint = kind < 0.4 ? Paint::Bands : kind < 0.7 ? Paint::Waves : Paint::Zigzag;
  clay.paint_period_mm = static_cast<float>(random.uniform(9, 22));
  clay.paint_width_mm = static_cast<float>(random.uniform(1, 4));
  clay.paint_phase_mm = static_cast<float>(random.uniform(0, 20));
  clay.grain = static_cast<float>(random.uniform(0.17, 0.28));
  clay.mottle = static_cast<float>(random.uniform(0.2, 0.4));
  clay.temper = static_cast<float>(random.uniform(0.06, 0.25));
  clay.temper_mm = static_cast<float>(random.uniform(1.2, 2.6));
  clay.roughness = static_cast<float>(random.uniform(0.34, 0.6));
  if (plain) {
    clay.slip_outside = clay.slip_inside = false;
    clay.paint = Paint::None;
    clay.core_strength *= 0.3f;
    clay.grain *= 0.55f;
    clay.mottle *= 0.35f;
    clay.temper *= 0.4f;
    clay.temper_mm = 0.9f;
  }
  return clay;
}

void widen(Clay& clay, double shiny_share, Random& random) {
  const double kind = random.uniform();
  if (kind < 0.4) {  // fired without air, or of white earth: nearly neutral
    static constexpr std::array<double, 5> kGreys{0.035, 0.07, 0.14, 0.3, 0.58};
    const auto grey = static_cast<float>(kGreys[static_cast<std::size_t>(random.below(5))]) *
                      static_cast<float>(random.uniform(0.85, 1.15));
    for (int c = 0; c < 3; ++c)
      clay.body[c] = grey * static_cast<float>(random.uniform(0.96, 1.04));
    clay.core = clay.body * static_cast<float>(random.uniform(0.5, 1.0));
    clay.core_strength *= 0.5f;
    if (grey < 0.1f) clay.mottle *= 0.7f;
  }
  const double color = random.uniform();
  if (color < 0.3)
    clay.slip = Eigen::Vector3f(0.017f, 0.015f, 0.0145f);  // black gloss
  else if (color < 0.5)
    clay.slip = Eigen::Vector3f(0.055f, 0.019f, 0.013f);  // brown, misfired black
  else if (color < 0.65)
    clay.slip = Eigen::Vector3f(0.60f, 0.56f, 0.49f);  // white
  const double shines = random.uniform(), rubbed = random.uniform();
  const auto worn = static_cast<float>(random.uniform(0.05, 0.35));
  const Gloss shine{static_cast<float>(random.uniform(0.5, 1.0)),
                    static_cast<float>(random.uniform(0.14, 0.36))};
  if (shines >= shiny_share) return;
  clay.shine = shine;
  clay.burnished = rubbed < 0.3;
  clay.slip_outside = !clay.burnished;
  clay.slip_inside = clay.slip_inside || (clay.slip_outside && rubbed > 0.6);
  clay.slip_worn = worn;
  if (clay.burnished) {
    clay.slip_inside = false;
    clay.grain *= 0.6f;
  }
}

ClaySample sampleClay(const Clay& clay, const Eigen::Vector3f& p, const ClayPlace& place) {
  const bool broken = place.broken > 0.4f;
  Eigen::Vector3f albedo = clay.body;
  const float middle = 1 - std::abs(2 * place.depth - 1);
  if (clay.core_strength > 0) {
    const float fired = smoothStep(0.25f, 0.8f, middle + 0.3f * noise(p / 4, clay.seed + 1));
    albedo += clay.core_strength * fired * (clay.core - albedo);
  }
  mixTemper(p, clay.temper_mm, clay.temper, clay.seed + 2, albedo);
  mixTemper(p + Eigen::Vector3f(0.37f, 0.21f, 0.11f), 0.62f * clay.temper_mm, 1.3f * clay.temper,
            clay.seed + 3, albedo);
  mixTemper(p, 0.45f, 0.12f, clay.seed + 4, albedo);
  Gloss shine = clay.shine;
  shine.weight = clay.burnished && !broken ? shine.weight : 0;
  if (!broken) {
    const bool outside = place.depth < 0.5f;
    if ((outside && clay.slip_outside) || (!outside && clay.slip_inside)) {
      const float left = fractalNoise(p / 3, clay.seed + 11, 4) * 0.5f + 0.5f;
      const float kept = smoothStep(clay.slip_worn - 0.05f, clay.slip_worn + 0.05f, left);
      albedo += 0.92f * kept * (clay.slip - albedo);
      if (!clay.burnished) shine.weight = kept * clay.shine.weight;
    }
    if (clay.paint != Paint::None && outside)
      albedo += 0.9f * painted(clay, place, p) * (clay.paint_color - albedo);
  }
  const float clouds = fractalNoise(p / 9, clay.seed + 21, 5);
  const NoiseValue grain = noiseWithGradient(p / 0.42f, clay.seed + 22);
  const NoiseValue fine = noiseWithGradient(p / 0.21f, clay.seed + 23);
  albedo *= std::max(
      0.25f, 1 + clay.mottle * clouds + clay.grain * (2.2f * grain.value + 1.4f * fine.value));
  if (!broken) {
    const float even = 1 - 0.6f * std::min(1.f, shine.weight);  // what shines is smooth
    return {albedo, 0.22f * clay.roughness * even * (0.8f * grain.gradient + 0.35f * fine.gradient),
            kFaceGlitter * even, shine};
  }
  // A break is rough at every scale, about as steep at each; its pits hold soil and see less light.
  const NoiseValue pits = noiseWithGradient(p / 0.84f, clay.seed + 24);
  const float height_mm = 0.84f * pits.value + 0.42f * grain.value + 0.21f * fine.value;
  albedo *= kSoil * std::exp(clay.pits_per_mm * height_mm);
  return {albedo,
          clay.roughness * (pits.gradient + grain.gradient + 0.7f * fine.gradient),
          kBreakGlitter,
          {}};
}

}  // namespace ostraka::vessels
