#include "colour/correction.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/median.h"
#include "base/message.h"
#include "batch/photograph.h"

namespace ostraka::colour {
namespace {

constexpr int kPasses = 20;

// Of the 95 % residual. A camera's own tone curve (half of a smoothstep, or an exponent of 0.8 to
// 1.25) or a flare of 4 % leaves up to 5.6. Light that falls by 40 % from edge to edge, or a shadow
// that takes 30 % of it from a row or a column on, leaves 5.8 and more, two covered patches 16.
constexpr double kMostOff = 5.7;

// The inverse of batch::linearLight, by a table of steps of a twentieth of the darkest level.
std::uint8_t encoded(double light) {
  constexpr int kSteps = 1 << 16;
  static const std::vector<std::uint8_t> levels = [] {
    std::vector<std::uint8_t> table;
    for (int i = 0; i <= kSteps; ++i) {
      const double v = static_cast<double>(i) / kSteps;
      const double level = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
      table.push_back(static_cast<std::uint8_t>(std::lround(255 * level)));
    }
    return table;
  }();
  return levels[static_cast<std::size_t>(std::lround(kSteps * std::clamp(light, 0.0, 1.0)))];
}

Patches<double> offBy(const Patches<Eigen::Vector3d>& light, const Eigen::Matrix3d& matrix) {
  Patches<double> off;
  for (std::size_t i = 0; i < off.size(); ++i)
    off[i] = ciede2000(labOf(matrix * light[i]), referenceLab()[i]);
  return off;
}

}  // namespace

// X-Rite, New color specifications for ColorChecker SG and Classic charts; i1Pro 2, M0, 2 degrees.
const Patches<Lab>& referenceLab() {
  static const Patches<Lab> lab = {
      Lab(37.54, 14.37, 14.92),  Lab(64.66, 19.27, 17.50),  Lab(49.32, -3.82, -22.54),
      Lab(43.46, -12.74, 22.72), Lab(54.94, 9.61, -24.79),  Lab(70.48, -32.26, -0.37),
      Lab(62.73, 35.83, 56.50),  Lab(39.43, 10.75, -45.17), Lab(50.57, 48.64, 16.67),
      Lab(30.10, 22.54, -20.87), Lab(71.77, -24.13, 58.19), Lab(71.51, 18.24, 67.37),
      Lab(28.37, 15.42, -49.80), Lab(54.38, -39.72, 32.27), Lab(42.43, 51.05, 28.62),
      Lab(81.80, 2.67, 80.41),   Lab(50.63, 51.28, -14.12), Lab(49.57, -29.71, -28.32),
      Lab(95.19, -1.03, 2.93),   Lab(81.29, -0.57, 0.44),   Lab(66.89, -0.75, -0.06),
      Lab(50.76, -0.13, 0.14),   Lab(35.63, -0.46, -0.48),  Lab(20.64, 0.07, -0.46)};
  return lab;
}

Color Correction::of(const Color& colour) const {
  const std::array<double, 256>& light = batch::linearLight();
  const Eigen::Vector3d corrected =
      matrix * Eigen::Vector3d(light[colour[0]], light[colour[1]], light[colour[2]]);
  return {encoded(corrected[0]), encoded(corrected[1]), encoded(corrected[2])};
}

cv::Mat3b Correction::of(const cv::Mat3b& picture) const {
  cv::Mat3b corrected(picture.size());
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      const cv::Vec3b& bgr = picture(y, x);
      const Color rgb = of(Color{bgr[2], bgr[1], bgr[0]});
      corrected(y, x) = {rgb[2], rgb[1], rgb[0]};
    }
  return corrected;
}

Correction fitted(const Patches<Eigen::Vector3d>& light) {
  Patches<double> weights;
  weights.fill(1);
  Correction best;
  for (int pass = 0; pass < kPasses; ++pass) {
    Eigen::Matrix3d both = Eigen::Matrix3d::Zero(), own = both;
    for (std::size_t i = 0; i < light.size(); ++i) {
      // L* goes with the cube root: a step of light counts by its slope, in the dark a hundred
      // times as much as in white; at first it does not, or one covered dark patch would rule.
      const double slope = pass == 0 ? 1 : std::pow((referenceLab()[i][0] + 16) / 116, -2);
      const double weight = weights[i] * slope * slope;
      both += weight * lightOf(referenceLab()[i]) * light[i].transpose();
      own += weight * light[i] * light[i].transpose();
    }
    own.diagonal().array() += 1e-9 * own.trace() + 1e-12;  // what is all grey has no matrix
    best.matrix = both * own.inverse();
    const Patches<double> off = offBy(light, best.matrix);
    const std::vector<double> sorted(off.begin(), off.end());
    best.median = quantileOf(sorted, 0.5);
    best.within_95 = quantileOf(sorted, 0.95);
    const double scale = std::max(1.0, 2 * best.median);
    for (std::size_t i = 0; i < off.size(); ++i)
      weights[i] = 1 / (1 + off[i] * off[i] / (scale * scale));
  }
  return best;
}

Result<Correction> correctionBy(const Chart& chart) {
  if (chart.clipped > 0)
    return Error::notEnough(
        message("The colour chart is overexposed or underexposed (clipped patches: %1), so "
                "it is not used and colours stay as photographed; reshoot it at another "
                "exposure.",
                chart.clipped));
  const Correction found = fitted(chart.light);
  if (!(found.within_95 <= kMostOff))
    return Error::notEnough(
        message("The colour chart is shaded, bent or partly hidden, so it is not used and "
                "colours stay as photographed; reshoot it flat, whole and evenly lit."));
  return found;
}

}  // namespace ostraka::colour
