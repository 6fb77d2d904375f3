#include "rendering/table.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace ostraka::rendering {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

// Linear albedos. Oak, pine, walnut, beech, limed oak.
const std::array<Vector3f, 5> kWoods{Vector3f(0.36f, 0.22f, 0.105f), Vector3f(0.47f, 0.31f, 0.16f),
                                     Vector3f(0.14f, 0.075f, 0.04f), Vector3f(0.43f, 0.26f, 0.15f),
                                     Vector3f(0.34f, 0.30f, 0.25f)};
// Denim, linen, bottle green, wine red, charcoal.
const std::array<Vector3f, 5> kCloths{Vector3f(0.05f, 0.08f, 0.16f), Vector3f(0.47f, 0.40f, 0.30f),
                                      Vector3f(0.03f, 0.10f, 0.05f), Vector3f(0.20f, 0.025f, 0.03f),
                                      Vector3f(0.045f, 0.045f, 0.05f)};
const std::array<Vector3f, 3> kGranites{
    Vector3f(0.30f, 0.29f, 0.28f), Vector3f(0.33f, 0.23f, 0.19f), Vector3f(0.09f, 0.09f, 0.095f)};
const std::array<Vector3f, 3> kMats{Vector3f(0.015f, 0.10f, 0.07f), Vector3f(0.02f, 0.06f, 0.18f),
                                    Vector3f(0.06f, 0.06f, 0.065f)};
const std::array<Vector3f, 4> kFloors{Vector3f(0.34f, 0.33f, 0.31f), Vector3f(0.16f, 0.11f, 0.08f),
                                      Vector3f(0.07f, 0.07f, 0.08f), Vector3f(0.40f, 0.36f, 0.30f)};

constexpr float kMatX = 225, kMatY = 160;  // mm, half of a cutting mat for A3

template <std::size_t N>
Vector3f chosen(const std::array<Vector3f, N>& from, vessels::Random& random) {
  Vector3f color = from[static_cast<std::size_t>(random.below(static_cast<int>(N)))];
  color *= static_cast<float>(random.uniform(0.85, 1.15));
  for (int c = 0; c < 3; ++c) color[c] *= static_cast<float>(random.uniform(0.94, 1.06));
  return color;
}

}  // namespace

TableSurface::TableSurface(TableKind kind, vessels::Random& random)
    : kind_(kind), seed_(static_cast<std::uint32_t>(random.next())) {
  const double turn = kind == TableKind::CuttingMat ? random.uniform(-0.1, 0.1)
                                                    : random.uniform(0, 2 * std::numbers::pi);
  turn_ = Eigen::Rotation2Df(static_cast<float>(turn)).toRotationMatrix();
  const auto off = [&](double most) { return static_cast<float>(random.uniform(-most, most)); };
  shift_ = kind == TableKind::CuttingMat ? Vector2f(off(18), off(14)) : Vector2f(off(60), off(60));
  const auto edge = [&] { return static_cast<float>(random.uniform(270, 620)); };
  low_ = {-edge(), -edge()};
  high_ = {edge(), edge()};
  switch (kind) {
    case TableKind::Wood:
      body_ = chosen(kWoods, random);
      gloss_ = {static_cast<float>(random.uniform(0, 0.8)), 0.38f};
      break;
    case TableKind::Cloth:
      body_ = chosen(kCloths, random);
      break;
    case TableKind::Granite:
      body_ = chosen(kGranites, random);
      gloss_ = {0.9f, 0.12f};
      break;
    case TableKind::CuttingMat:
      body_ = chosen(kMats, random);
      gloss_ = {0.35f, 0.45f};
      break;
  }
  second_ = random.chance(0.5) ? Vector3f(0.55f, 0.52f, 0.47f) : Vector3f(body_ * 0.6f);
  period_mm_ = static_cast<float>(kind == TableKind::Wood ? random.uniform(85, 160)
                                                          : random.uniform(14, 40));
  if (kind == TableKind::Cloth && random.chance(0.6)) period_mm_ = 0;  // one colour, no checks
  floor_ = chosen(kFloors, random);
  wall_ = Vector3f::Constant(static_cast<float>(random.uniform(0.3, 0.6)));
  mean_ = kind == TableKind::Cloth && period_mm_ > 0 ? Vector3f(0.5f * (body_ + second_)) : body_;
}

bool TableSurface::holds(const Vector2f& p) const {
  const Vector2f q = turn_ * p + shift_;
  return (q.array() > low_.array()).all() && (q.array() < high_.array()).all();
}

Vector3f TableSurface::albedo(const Vector2f& p) const {
  const Vector2f q = turn_ * p + shift_;
  switch (kind_) {
    case TableKind::Wood:
      return wood(q);
    case TableKind::Cloth:
      return cloth(q);
    case TableKind::Granite:
      return granite(q);
    case TableKind::CuttingMat:
      return cuttingMat(q);
  }
  return body_;
}

// Planks side by side; growth rings cut nearly along, as flame figures and fine streaks.
Vector3f TableSurface::wood(const Vector2f& q) const {
  const float plank = std::floor(q.y() / period_mm_);
  const auto number = static_cast<std::uint32_t>(static_cast<int>(plank) + 1000);
  const std::uint32_t h = vessels::cellHash(static_cast<int>(number), 1, 2, seed_);
  const float v = q.y() - plank * period_mm_, gap = std::min(v, period_mm_ - v);
  const float u = q.x() + static_cast<float>(h & 0x3FF), w = v + 40 * static_cast<float>(number);
  const std::uint32_t s = seed_ + number;
  const float ring = 0.11f * w + 1.5f * vessels::noise({u / 170, w / 45, 3}, s) +
                     0.35f * vessels::noise({u / 40, w / 9, 5}, s);
  const float late = ring - std::floor(ring);  // early wood is light, late wood dark, then a step
  const float streaks = vessels::fractalNoise({u / 55, w / 1.3f, 9}, s + 1, 3);
  const float pores =
      vessels::smoothStep(0.35f, 0.8f, vessels::noise({u / 7, w / 0.45f, 11}, s + 2));
  const float tone = 0.9f + 0.2f * static_cast<float>(h >> 20) / 4096.f;
  Vector3f color = body_ * (tone * (1 + 0.16f * streaks - 0.16f * late * late - 0.22f * pores));
  color.z() *= 1 - 0.08f * late;
  return color * (gap < 0.5f ? 0.25f : 1.f);
}

// Plain weave; folds are left to the light's low-frequency change.
Vector3f TableSurface::cloth(const Vector2f& q) const {
  Vector3f color = body_;
  if (period_mm_ > 0) {
    const bool a = std::fmod(std::abs(q.x()), 2 * period_mm_) < period_mm_,
               b = std::fmod(std::abs(q.y()), 2 * period_mm_) < period_mm_;
    color = a && b ? second_ : a || b ? Vector3f(0.5f * (body_ + second_)) : body_;
  }
  constexpr float thread = 0.7f;  // mm
  const float x = q.x() / thread, y = q.y() / thread;
  const bool over = (static_cast<int>(std::floor(x)) + static_cast<int>(std::floor(y))) % 2 == 0;
  const float across = over ? x - std::floor(x) : y - std::floor(y);
  const float round = 1 - 1.6f * (across - 0.5f) * (across - 0.5f);
  const float folds = 0.16f * vessels::fractalNoise({q.x() / 90, q.y() / 60, 1}, seed_, 2);
  const float lint = 0.1f * vessels::noise({q.x() / 2.f, q.y() / 2.f, 4}, seed_ + 3);
  return color * (round * (1 + folds + lint));
}

// Grains of feldspar, quartz and mica.
Vector3f TableSurface::granite(const Vector2f& q) const {
  const float coarse = vessels::fractalNoise({q.x() / 4.5f, q.y() / 4.5f, 0}, seed_, 3),
              fine = vessels::fractalNoise({q.x() / 1.6f, q.y() / 1.6f, 3}, seed_ + 1, 2);
  Vector3f color = body_ * (1 + 0.35f * coarse);
  color += vessels::smoothStep(0.3f, 0.45f, coarse + 0.4f * fine) *
           (Vector3f(0.52f, 0.50f, 0.47f) - color) * 0.75f;
  color += vessels::smoothStep(0.28f, 0.4f, fine - 0.35f * coarse) *
           (Vector3f(0.03f, 0.03f, 0.032f) - color) * 0.85f;
  return color.cwiseMax(0.01f);
}

Vector3f TableSurface::cuttingMat(const Vector2f& q) const {
  if (std::abs(q.x()) > kMatX || std::abs(q.y()) > kMatY) return wood(q);
  const float border = std::min(kMatX - std::abs(q.x()), kMatY - std::abs(q.y()));
  const float worn = 1 + 0.08f * vessels::fractalNoise({q.x() / 30, q.y() / 30, 0}, seed_, 3) +
                     0.05f * vessels::noise({q.x() / 0.8f, q.y() / 0.8f, 2}, seed_ + 1);
  const auto near = [&](float period, float width) {
    return border > 9 && (std::abs(std::remainder(q.x(), period)) < width / 2 ||
                          std::abs(std::remainder(q.y(), period)) < width / 2);
  };
  const bool line = near(50, 0.6f) || near(10, 0.25f) || std::abs(border - 9) < 0.3f;
  return (line ? Vector3f(0.42f, 0.45f, 0.36f) : body_) * worn;
}

Vector3f TableSurface::floor(const Vector2f& p) const {
  return floor_ * (1 + 0.15f * vessels::fractalNoise({p.x() / 400, p.y() / 400, 0}, seed_ + 9, 2));
}

}  // namespace ostraka::rendering
