#include "mask/plate_agreement.h"

#include <algorithm>
#include <cmath>

#include "ground/plate_geometry.h"

namespace ostraka::mask {
namespace {

constexpr float kUnlike = 0.22F;     // density of a sherd's residual, as in weighEvidence
constexpr float kFooled = 0.03F;     // how often an open line of sight is none: hull and pose err
constexpr float kMostAgreement = 6;  // a pair may be fooled by a colour that repeats

uchar atCell(const cv::Mat1b& reduced, int y, int x, int reduction) {
  return reduced(std::min(y / reduction, reduced.rows - 1),
                 std::min(x / reduction, reduced.cols - 1));
}

bool knowsPlate(const PlateView& view, int y, int x) {
  return view.plate == nullptr || atCell(*view.plate, y, x, view.reduction) != 0;
}

// What another camera sees of a plate point; false where it is no witness: out of its picture,
// where the plate is not known, or behind what may be a sherd, whose even colour would agree with
// itself.
bool witness(const PlateView& other, const Eigen::Vector3d& p_plate, cv::Vec3f& value) {
  const Eigen::Vector3d q = other.image->camera_from_plate * p_plate;
  if (q.z() <= 0) return false;
  const Eigen::Vector2d pixel = other.image->intrinsics.project(q);
  const cv::Mat3f& residual = *other.residual;
  const int x = static_cast<int>(std::floor(pixel.x())),
            y = static_cast<int>(std::floor(pixel.y()));
  if (x < 0 || y < 0 || x + 1 >= residual.cols || y + 1 >= residual.rows) return false;
  if (atCell(*other.hull, y, x, other.reduction) != 0 || !knowsPlate(other, y, x)) return false;
  const auto u = static_cast<float>(pixel.x() - x), v = static_cast<float>(pixel.y() - y);
  value = (residual(y, x) * (1 - u) + residual(y, x + 1) * u) * (1 - v) +
          (residual(y + 1, x) * (1 - u) + residual(y + 1, x + 1) * u) * v;
  return true;
}

float density(float dg, const cv::Vec3f& dc, float var_g, float var_c) {
  return std::exp(-0.5F * (dg * dg / var_g + dc.dot(dc) / var_c)) /
         (15.75F * std::sqrt(var_g) * var_c);  // (2 pi)^1.5
}

// log P(other's residual | own's residual, both see the same plate) / P(other's residual).
float pairOdds(const cv::Vec3f& own, const cv::Vec3f& other) {
  const float g = (own[0] + own[1] + own[2]) / 3;
  const cv::Vec3f d = own - other;
  const float dg = (d[0] + d[1] + d[2]) / 3;
  // Poses are good to half a pixel and a shadow's border is a few pixels wide, so a tenth of its
  // depth; noise of both residuals.
  const float same =
      density(dg, d - cv::Vec3f(dg, dg, dg), 0.0009F + 0.01F * g * g, 0.0004F + 0.0025F * g * g);
  // Anywhere: lit plate, plate in a shadow of any depth to a twentieth, a sherd of any clay.
  const float h = (other[0] + other[1] + other[2]) / 3;
  const cv::Vec3f c = other - cv::Vec3f(h, h, h);
  const float shadow = h < 0.05F && h > -3
                           ? std::exp(-0.5F * c.dot(c) / (0.0009F + 0.0025F * h * h)) /
                                 (3 * 6.283F * (0.0009F + 0.0025F * h * h))
                           : 0.F;
  const float any = 0.5F * density(h, c, 0.0009F, 0.0004F) + 0.2F * shadow + 0.3F * kUnlike;
  return std::log(kFooled + (1 - kFooled) * same / any);
}

}  // namespace

void weighAgreement(const PlateView& view, std::span<const PlateView> others,
                    const std::function<bool(double, double)>& bare_at, const cv::Mat1b& allowed,
                    cv::Mat1f& log_odds) {
  if (others.empty()) return;
  ground::PlateGrid millimetres;
  millimetres.pitch_mm = 1;
  millimetres.size = 1;
  const cv::Mat2f plate = ground::gridOfPixels(*view.image, millimetres, view.bend);
  for (int y = 0; y < log_odds.rows; ++y)
    for (int x = 0; x < log_odds.cols; ++x) {
      if (allowed(y, x) == 0 || !knowsPlate(view, y, x)) continue;
      const cv::Vec3f own = (*view.residual)(y, x);
      const cv::Vec2f p = plate(y, x);
      if (!bare_at(p[0], p[1])) continue;
      float odds = 0;
      cv::Vec3f value;
      for (const PlateView& other : others)
        if (witness(other, Eigen::Vector3d(p[0], p[1], view.bend.at(p[0], p[1])), value))
          odds += pairOdds(own, value);
      log_odds(y, x) -= std::clamp(odds, -kMostAgreement, kMostAgreement);
    }
}

}  // namespace ostraka::mask
