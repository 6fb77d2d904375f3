#include "mask/plate_agreement.h"

#include <algorithm>
#include <cmath>

#include "mask/plate_geometry.h"

namespace ostraka::mask {
namespace {

constexpr float kUnlike = 0.22F;   // density of a sherd's residual, as in weighEvidence
constexpr float kInTheWay = 0.3F;  // how often the other camera does not see the plate point
constexpr float kMost = 6;         // a pair may be fooled by a colour that repeats

bool sampleAt(const cv::Mat3f& residual, const Eigen::Vector2d& pixel, cv::Vec3f& value) {
  const int x = static_cast<int>(std::floor(pixel.x())),
            y = static_cast<int>(std::floor(pixel.y()));
  if (x < 0 || y < 0 || x + 1 >= residual.cols || y + 1 >= residual.rows) return false;
  const auto u = static_cast<float>(pixel.x() - x), v = static_cast<float>(pixel.y() - y);
  value = (residual(y, x) * (1 - u) + residual(y, x + 1) * u) * (1 - v) +
          (residual(y + 1, x) * (1 - u) + residual(y + 1, x + 1) * u) * v;
  return true;
}

// log P(other's residual | plate seen by both) / P(. | sherd).
float pairOdds(const cv::Vec3f& own, const cv::Vec3f& other) {
  const float g = (own[0] + own[1] + own[2]) / 3;
  const cv::Vec3f d = own - other;
  const float dg = (d[0] + d[1] + d[2]) / 3;
  const cv::Vec3f colour = d - cv::Vec3f(dg, dg, dg);
  // Poses are good to half a pixel and a shadow's border is a few pixels wide, so a tenth of its
  // depth; noise of both residuals.
  const float var_g = 0.0009F + 0.01F * g * g;
  const float var_c = 0.0004F + 0.0025F * g * g;
  const float same = std::exp(-0.5F * (dg * dg / var_g + colour.dot(colour) / var_c)) /
                     (15.75F * std::sqrt(var_g) * var_c);  // (2 pi)^1.5
  return std::min(kMost, std::log(kInTheWay + (1 - kInTheWay) * same / kUnlike));
}

}  // namespace

void weighAgreement(const PlateView& view, std::span<const PlateView> others,
                    const std::function<bool(double, double)>& bare_at, const cv::Mat1b& allowed,
                    cv::Mat1f& log_odds) {
  if (others.empty()) return;
  PlateGrid millimetres;
  millimetres.pitch_mm = 1;
  millimetres.size = 1;
  const cv::Mat2f plate = gridOfPixels(*view.image, millimetres);
  for (int y = 0; y < log_odds.rows; ++y)
    for (int x = 0; x < log_odds.cols; ++x) {
      if (allowed(y, x) == 0) continue;
      const cv::Vec3f own = (*view.residual)(y, x);
      // Lit plate agrees with lit plate everywhere, and needs no second witness.
      if (own[0] + own[1] + own[2] > -0.15F) continue;
      const cv::Vec2f p = plate(y, x);
      if (!bare_at(p[0], p[1])) continue;
      float odds = 0;
      for (const PlateView& other : others) {
        const Eigen::Vector3d q = other.image->camera_from_plate * Eigen::Vector3d(p[0], p[1], 0);
        cv::Vec3f value;
        if (q.z() <= 0 || !sampleAt(*other.residual, other.image->intrinsics.project(q), value))
          continue;
        odds += pairOdds(own, value);
      }
      log_odds(y, x) -= std::min(odds, kMost);
    }
}

}  // namespace ostraka::mask
