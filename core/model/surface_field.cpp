#include "model/surface_field.h"

#include <algorithm>
#include <cmath>

namespace ostraka::model {
namespace {

using Eigen::Vector3f;

constexpr int kRounds = 3;
constexpr float kNormalSigma = 0.5f;  // about 29 degrees: the paper's value, between 0.5 and 1.5
constexpr float kRadiusInSpacings = 2.4f;  // some 15 neighbours on a flat, enough after smoothing

struct Near {
  int index;
  float weight, offset;
};

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
  float support = 0;
  bins_.within(p, radius_, [&](int j, float d2) {
    const std::size_t i = static_cast<std::size_t>(j);
    const float u = 1 - d2 / (radius_ * radius_);
    const float mass = u * u * u * u * surfels_.area[i];
    support += mass;
    const float w = mass * surfels_.confidence[i];
    near.push_back({j, w, 0});
    gradient += w * surfels_.normals[i];
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
      if (round > 0) {
        const float turn = (nj - gradient).squaredNorm() / (kNormalSigma * kNormalSigma);
        const float off = (n.offset - distance) * residual_scale;
        w *= std::exp(-turn - off * off);
      }
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
  // Below a tenth of full support (an edge of a hole, half a radius out) the indicator takes over.
  const float own = std::min(1.0f, support / 0.1f);
  return {own * distance + (1 - own) * far, gradient, support};
}

}  // namespace ostraka::model
