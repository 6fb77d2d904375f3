#include <ceres/jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/message.h"
#include "files/json_numbers.h"
#include "rig/camera.h"

namespace ostraka::rig {
namespace {

constexpr double kWidest_rad = 1.5;  // a pinhole shows 90 degrees at infinity
constexpr double kStep_rad = 0.015;
constexpr double kMostTerm = 1e6;  // long lenses have k3 of thousands: their x/z are small
constexpr int kEnough = 50;        // steps, and halvings of an interval

// Without the terms that are not around the axis.
Distortion roundPart(Distortion lens) {
  if (lens.lens == Lens::Fisheye) return lens;
  lens[2] = lens[3] = 0;
  std::fill(lens.terms.begin() + 8, lens.terms.end(), 0.0);
  return lens;
}

// How far off the axis a lens shows a ray at this angle.
double bentRadius(const Distortion& round, double angle) {
  return round.bent({std::tan(angle), 0}).x();
}

// The angle up to which that grows.
double foldOf(const Distortion& round) {
  const auto grows = [&](double angle) {
    return bentRadius(round, angle) > 0 && round.slope({std::tan(angle), 0})(0, 0) > 0;
  };
  double low = 0, high = kStep_rad;
  while (high < kWidest_rad && grows(high)) low = high, high += kStep_rad;
  if (high >= kWidest_rad) return kWidest_rad;
  for (int halving = 0; halving < kEnough; ++halving) {
    const double middle = (low + high) / 2;
    (grows(middle) ? low : high) = middle;
  }
  return low;
}

// The point by fixed-point steps, which go to no place where the model has folded; nothing where
// they do not come to an end.
std::optional<Eigen::Vector2d> ofPoint(const Distortion& lens, const Eigen::Vector2d& target) {
  Eigen::Vector2d n = target;
  for (int step = 0; step < kEnough; ++step) {
    const Eigen::Vector2d error = lens.bent(n) - target;
    n -= error;
    if (error.squaredNorm() < 1e-24) return n;
  }
  return std::nullopt;
}

// The same of a fisheye, by the angle.
std::optional<Eigen::Vector2d> ofAngle(const Distortion& lens, const Eigen::Vector2d& target) {
  const double shown = target.norm();
  double angle = shown;
  for (int step = 0; step < kEnough; ++step) {
    const double a2 = angle * angle, last = angle;
    angle = shown / (1 + a2 * (lens[0] + a2 * (lens[1] + a2 * (lens[2] + a2 * lens[3]))));
    if (std::abs(angle - last) > 1e-13) continue;
    if (!(angle >= 0 && angle <= kWidest_rad)) return std::nullopt;
    return shown > 0 ? Eigen::Vector2d(std::tan(angle) / shown * target) : target;
  }
  return std::nullopt;
}

}  // namespace

std::vector<double> Distortion::list() const {
  std::size_t count = 5;
  if (lens == Lens::Fisheye) count = 4;
  if (lens == Lens::Full)
    count = std::all_of(terms.begin() + 8, terms.end(), [](double s) { return s == 0; }) ? 8 : 12;
  return {terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(count)};
}

Eigen::Vector2d Distortion::bent(const Eigen::Vector2d& n) const {
  Eigen::Vector2d out;
  bend(*this, terms.data(), n.x(), n.y(), out.data());
  return out;
}

Eigen::Matrix2d Distortion::slope(const Eigen::Vector2d& n) const {
  using Jet = ceres::Jet<double, 2>;
  std::array<Jet, 5> own;
  for (std::size_t k = 0; k < own.size(); ++k) own[k] = Jet(terms[k]);
  std::array<Jet, 2> out;
  bend(*this, own.data(), Jet(n.x(), 0), Jet(n.y(), 1), out.data());
  Eigen::Matrix2d slope;
  slope << out[0].v.transpose(), out[1].v.transpose();
  return slope;
}

double Distortion::reach() const {
  return std::tan(foldOf(roundPart(*this)));
}

Eigen::Vector2d Distortion::unbent(const Eigen::Vector2d& target) const {
  const std::optional<Eigen::Vector2d> soon =
      lens == Lens::Fisheye ? ofAngle(*this, target) : ofPoint(*this, target);
  if (soon) return *soon;
  // What bends more: the angle by halving, then Newton's steps for what is not around the axis.
  const Distortion round = roundPart(*this);
  const double radius = target.norm(), fold = foldOf(round);
  double low = 0, high = fold;
  for (int halving = 0; halving < kEnough; ++halving) {
    const double middle = (low + high) / 2;
    (bentRadius(round, middle) < radius ? low : high) = middle;
  }
  const double farthest = std::tan(fold);
  Eigen::Vector2d n = std::tan(low) / radius * target;
  if (high == fold) return n;
  for (int step = 0; step < kEnough; ++step) {
    const Eigen::Vector2d error = bent(n) - target;
    if (error.squaredNorm() < 1e-24) break;
    n -= slope(n).inverse() * error;
  }
  return n.norm() <= farthest ? n : Eigen::Vector2d(farthest / radius * target);
}

bool Intrinsics::folds() const {
  if (distortion.lens == Lens::Standard) return false;
  const double middle = 0.25 * std::min(width / fx, height / fy);
  const Distortion round = roundPart(distortion);
  return !(bentRadius(round, foldOf(round)) >= middle);
}

void readLens(const nlohmann::json& from, Intrinsics& camera) {
  const auto model = from.value("lens", nlohmann::json("standard"));
  if (model != "standard" && model != "fisheye")
    throw JsonValueError(
        message("The lens %1 is not known; it is 'standard' or 'fisheye'.", model.dump()));
  const auto terms = from.value("dist", nlohmann::json::array());
  const std::size_t count = terms.size();
  const bool fisheye = model == "fisheye";
  if (!terms.is_array() ||
      (fisheye ? count != 4 : count != 0 && count != 4 && count != 5 && count != 8 && count != 12))
    throw JsonValueError(
        message("Numbers in 'dist': %1; a lens has 0, 4, 5, 8 or 12 in OpenCV's "
                "order, a fisheye has 4.",
                count));
  Distortion& lens = camera.distortion = {};
  for (std::size_t k = 0; k < count; ++k)
    lens[k] = numberIn(terms[k], "dist", -kMostTerm, kMostTerm);
  if (fisheye)
    lens.lens = Lens::Fisheye;
  else if (std::any_of(lens.terms.begin() + 5, lens.terms.end(), [](double k) { return k != 0; }))
    lens.lens = Lens::Full;
  if (camera.folds())
    throw JsonValueError(
        message("No lens has the numbers in 'dist': its picture folds near the "
                "middle. Check their order."));
}

void writeLens(const Distortion& lens, nlohmann::ordered_json& to) {
  to["dist"] = lens.list();
  if (lens.lens == Lens::Fisheye) to["lens"] = "fisheye";
}

}  // namespace ostraka::rig
