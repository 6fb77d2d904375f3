#include "model/surface_field.h"

#include <algorithm>
#include <cmath>

namespace ostraka::model {
namespace {

using Eigen::Vector3f;

constexpr int kRounds = 3;
constexpr float kNormalSigma = 0.5f;    // about 29 degrees: the paper's value, between 0.5 and 1.5
constexpr float kCreaseCosine = 0.77f;  // 40 degrees: above what smoothed normals scatter
constexpr float kLeastSecondSheet = 0.08f;  // of all weight: one or two neighbours are no sheet
constexpr float kRadiusInSpacings = 2.4f;   // some 15 neighbours on a flat, enough after smoothing

struct Near {
  int index;
  float weight, offset;
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

// Where another sheet lies behind a convex crease the body is where both say inside, at a concave
// one where either does (Fleishman, Cohen-Or, Silva, SIGGRAPH 2005): without it, a face would be
// drawn past its edge.
bool otherSheetRules(const Sheet& first, const Sheet& second) {
  if (first.normal.dot(second.normal) > kCreaseCosine) return false;
  const Vector3f between = second.centre - first.centre;
  const float a = first.normal.dot(between), b = -second.normal.dot(between);
  if (a < 0 && b < 0) return second.distance > first.distance;
  if (a > 0 && b > 0) return second.distance < first.distance;
  return false;
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
  thread_local std::vector<Near> near;
  near.clear();
  Vector3f gradient = Vector3f::Zero();
  float support = 0, most = 0;
  bins_.within(p, radius_, [&](int j, float d2) {
    const std::size_t i = static_cast<std::size_t>(j);
    const float u = 1 - d2 / (radius_ * radius_);
    const float mass = u * u * u * u * surfels_.area[i];
    support += mass;
    const float w = mass * surfels_.confidence[i];
    near.push_back({j, w, 0});
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
  float distance = 0;
  const float residual_scale = 1 / (0.5f * radius_);
  for (int round = 0; round < kRounds; ++round) {
    float sum = 0, total = 0;
    Vector3f normal = Vector3f::Zero();
    for (Near& n : near) {
      const Vector3f& nj = surfels_.normals[static_cast<std::size_t>(n.index)];
      float w = n.weight;
      const float turn = (nj - gradient).squaredNorm() / (kNormalSigma * kNormalSigma);
      const float off = round > 0 ? (n.offset - distance) * residual_scale : 0;
      w *= std::exp(-turn - off * off);
      // The mean of both normals: exact on spheres at the surface.
      n.offset = 0.5f * (nj + gradient).dot(p - surfels_.points[static_cast<std::size_t>(n.index)]);
      sum += w * n.offset;
      total += w;
      normal += w * nj;
    }
    if (!(total > 1e-20f)) break;
    distance = sum / total;
    if (normal.norm() > 1e-20f) gradient = normal.normalized();
  }
  Sheet first, second;
  float all = 0;
  for (const Near& n : near) {
    const std::size_t i = static_cast<std::size_t>(n.index);
    const float turn =
        (surfels_.normals[i] - gradient).squaredNorm() / (kNormalSigma * kNormalSigma);
    const float same = std::exp(-turn);
    all += n.weight;
    first.add(n.weight * same, n.offset, surfels_.normals[i], surfels_.points[i]);
    if (turn > 1)
      second.add(n.weight * (1 - same), surfels_.normals[i].dot(p - surfels_.points[i]),
                 surfels_.normals[i], surfels_.points[i]);
  }
  if (second.weight > kLeastSecondSheet * all && first.close() && second.close()) {
    first.distance = distance;
    if (otherSheetRules(first, second)) {
      distance = second.distance;
      gradient = second.normal;
    }
  }
  // Below a tenth of full support (an edge of a hole, half a radius out) the indicator takes over.
  const float own = std::min(1.0f, support / 0.1f);
  return {own * distance + (1 - own) * far, gradient, support};
}

}  // namespace ostraka::model
