#include "model/surface_field.h"

#include <algorithm>
#include <cmath>

namespace ostraka::model {
namespace {

using Eigen::Vector3f;

constexpr int kSmoothingRounds = 3;
constexpr float kNormalSigma = 0.5f;    // about 29 degrees: the paper's value, between 0.5 and 1.5
constexpr float kCreaseCosine = 0.77f;  // 40 degrees: above what smoothed normals scatter
constexpr float kLeastSecondSheet = 0.08f;  // of all weight: one or two neighbours are no sheet
// Each of these decides over a range, or the surface would have a ledge where it changes its mind.
constexpr float kCosineRange = 0.1f, kSheetRange = 0.08f;
constexpr float kBendRange = 0.25f;        // of the radius
constexpr float kRadiusInSpacings = 2.4f;  // some 15 neighbours on a flat, enough after smoothing

struct NearSurfel {
  int index;
  float mass, weight, offset;  // weight: mass by confidence
};

// A sheet of the surface near a place, by weighted neighbours.
struct Sheet {
  float weight = 0, distance = 0;
  Vector3f normal = Vector3f::Zero(), centre = Vector3f::Zero();

  void add(float w, float offset, const Vector3f& n, const Vector3f& p) {
    weight += w;
    distance += w * offset;
    normal += w * n;
    centre += w * p;
  }
  bool close() {
    if (!(weight > 1e-20f) || !(normal.norm() > 1e-20f)) return false;
    distance /= weight;
    centre /= weight;
    normal.normalize();
    return true;
  }
};

// 0 up to `from`, 1 beyond `from` + `range`.
float ramp(float value, float from, float range) {
  return std::clamp((value - from) / range, 0.0f, 1.0f);
}

// Where another sheet lies behind a convex crease the body is where both say inside, at a concave
// one where either does (Fleishman, Cohen-Or, Silva, SIGGRAPH 2005): without it, a face would be
// drawn past its edge.
// The bend is the sum of both sheets' heights over each other's planes: one height alone changes
// its sign where two scans of one wall disagree by a tenth of a millimetre. Returns how much the
// other sheet's distance counts.
float otherSheetRules(const Sheet& first, const Sheet& second, float radius) {
  const Vector3f between = second.centre - first.centre;
  const float bend = (first.normal - second.normal).dot(between);
  const bool rules = bend < 0 ? second.distance > first.distance : second.distance < first.distance;
  if (!rules) return 0;
  return ramp(-first.normal.dot(second.normal), -kCreaseCosine, kCosineRange) *
         ramp(std::abs(bend), 0, kBendRange * radius);
}

// The distance of p from the smooth surface through its neighbours, and the surface's normal, which
// comes in as the first guess of it; the neighbours are left with their own distances.
float smoothDistance(const Surfels& surfels, const Vector3f& p, float radius,
                     std::vector<NearSurfel>& near, Vector3f& gradient) {
  float distance = 0;
  const float residual_scale = 1 / (0.5f * radius);
  for (int round = 0; round < kSmoothingRounds; ++round) {
    float sum = 0, total = 0;
    Vector3f normal = Vector3f::Zero();
    for (NearSurfel& n : near) {
      const Vector3f& nj = surfels.normals[static_cast<std::size_t>(n.index)];
      float w = n.weight;
      const float turn = (nj - gradient).squaredNorm() / (kNormalSigma * kNormalSigma);
      const float off = round > 0 ? (n.offset - distance) * residual_scale : 0;
      w *= std::exp(-turn - off * off);
      // The mean of both normals: exact on spheres at the surface.
      n.offset = 0.5f * (nj + gradient).dot(p - surfels.points[static_cast<std::size_t>(n.index)]);
      sum += w * n.offset;
      total += w;
      normal += w * nj;
    }
    if (!(total > 1e-20f)) break;
    distance = sum / total;
    if (normal.norm() > 1e-20f) gradient = normal.normalized();
  }
  return distance;
}

// Corrects distance and normal where another sheet of the surface is near. Whether there is one is
// asked of the surface that was seen, whatever its noise: where two scans of a wall disagree, it
// has little confidence beside the face above it.
void blendOtherSheet(const Surfels& surfels, const Vector3f& p, float radius,
                     const std::vector<NearSurfel>& near, float& distance, Vector3f& gradient) {
  Sheet first, second;
  float all = 0, others = 0;
  for (const NearSurfel& n : near) {
    const std::size_t i = static_cast<std::size_t>(n.index);
    const float turn =
        (surfels.normals[i] - gradient).squaredNorm() / (kNormalSigma * kNormalSigma);
    const float same = std::exp(-turn);
    all += n.mass;
    first.add(n.weight * same, n.offset, surfels.normals[i], surfels.points[i]);
    if (turn <= 1) continue;
    others += n.mass * (1 - same);
    second.add(n.weight * (1 - same), surfels.normals[i].dot(p - surfels.points[i]),
               surfels.normals[i], surfels.points[i]);
  }
  const float is_sheet = ramp(others / std::max(all, 1e-20f), kLeastSecondSheet, kSheetRange);
  if (!(is_sheet > 0) || !first.close() || !second.close()) return;
  first.distance = distance;
  const float share = is_sheet * otherSheetRules(first, second, radius);
  distance += share * (second.distance - distance);
  if (share > 0) gradient = (gradient + share * (second.normal - gradient)).normalized();
}

}  // namespace

SurfaceField::SurfaceField(const Surfels& surfels, const Grid& indicator)
    : surfels_(surfels),
      indicator_(indicator),
      radius_(kRadiusInSpacings * static_cast<float>(surfels.spacing_mm)),
      full_support_(0),
      bins_(surfels.points, radius_) {
  // What a flat piece of surface gives at no distance: the integral of (1 - u)^4, u = (r / R)^2.
  full_support_ = static_cast<float>(M_PI) * radius_ * radius_ / 5;
}

float SurfaceField::farDistance(const Vector3f& p) const {
  // The indicator climbs from 0 to 1 over about two cells.
  return -2 * indicator_.cell_mm * indicator_.interpolated(p);
}

FieldSample SurfaceField::sample(const Vector3f& p) const {
  thread_local std::vector<NearSurfel> near;
  near.clear();
  Vector3f gradient = Vector3f::Zero();
  float support = 0, most = 0;
  bins_.within(p, radius_, [&](int j, float d2) {
    const std::size_t i = static_cast<std::size_t>(j);
    const float u = 1 - d2 / (radius_ * radius_);
    const float mass = u * u * u * u * surfels_.area[i];
    support += mass;
    const float w = mass * surfels_.confidence[i];
    near.push_back({j, mass, w, 0});
    // The start is the nearest neighbour's say: a mean across a crease would stay between the
    // faces.
    if (w > most) {
      most = w;
      gradient = surfels_.normals[i];
    }
  });
  support = std::min(1.0f, support / full_support_);
  const float far = farDistance(p);
  if (near.empty() || !(gradient.norm() > 1e-20f)) return {far, Vector3f::Zero(), 0};
  gradient.normalize();
  float distance = smoothDistance(surfels_, p, radius_, near, gradient);
  blendOtherSheet(surfels_, p, radius_, near, distance, gradient);
  // Below a tenth of full support (an edge of a hole, half a radius out) the indicator takes over.
  const float own = std::min(1.0f, support / 0.1f);
  return {own * distance + (1 - own) * far, gradient, support};
}

}  // namespace ostraka::model
