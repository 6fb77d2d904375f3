#include "colour/ciede2000.h"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace ostraka::colour {
namespace {

// Lindbloom's table: XYZ of D50 to linear sRGB, Bradford's adaptation to D65 within.
const Eigen::Matrix3d& lightFromXyz() {
  static const Eigen::Matrix3d matrix{{3.1338561, -1.6168667, -0.4906146},
                                      {-0.9787684, 1.9161415, 0.0334540},
                                      {0.0719453, -0.2289914, 1.4052427}};
  return matrix;
}

constexpr double kEdge = 6.0 / 29;  // below it the cube root gives way to a line

double rooted(double t) {
  return t > kEdge * kEdge * kEdge ? std::cbrt(t) : t / (3 * kEdge * kEdge) + 4.0 / 29;
}

double cubed(double f) {
  return f > kEdge ? f * f * f : 3 * kEdge * kEdge * (f - 4.0 / 29);
}

constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

// 0 to 2 pi; 0 for grey.
double hueOf(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double hue = std::atan2(b, a);
  return hue < 0 ? hue + 2 * std::numbers::pi : hue;
}

double squareRootOfShare(double chroma) {
  const double c7 = std::pow(chroma, 7);
  return std::sqrt(c7 / (c7 + std::pow(25.0, 7)));
}

}  // namespace

Lab labOfXyz(const Eigen::Vector3d& xyz) {
  const Eigen::Vector3d f = xyz.cwiseQuotient(kWhite).unaryExpr(&rooted);
  return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

Lab labOf(const Eigen::Vector3d& light) {
  return labOfXyz(lightFromXyz().inverse() * light);
}

Eigen::Vector3d lightOf(const Lab& lab) {
  const double y = (lab[0] + 16) / 116;
  const Eigen::Vector3d xyz(cubed(y + lab[1] / 500), cubed(y), cubed(y - lab[2] / 200));
  return lightFromXyz() * xyz.cwiseProduct(kWhite);
}

// Symbols as in the paper, equations 2 to 22.
double ciede2000(const Lab& one, const Lab& other) {
  using std::cos;
  const double c_mean = (std::hypot(one[1], one[2]) + std::hypot(other[1], other[2])) / 2;
  const double g = (1 - squareRootOfShare(c_mean)) / 2;
  const double a1 = (1 + g) * one[1], a2 = (1 + g) * other[1];
  const double c1 = std::hypot(a1, one[2]), c2 = std::hypot(a2, other[2]);
  const double h1 = hueOf(a1, one[2]), h2 = hueOf(a2, other[2]);
  constexpr double kHalf = std::numbers::pi;
  double dh = c1 * c2 == 0 ? 0 : h2 - h1;
  if (dh > kHalf) dh -= 2 * kHalf;
  if (dh < -kHalf) dh += 2 * kHalf;
  const double dl = other[0] - one[0], dc = c2 - c1;
  const double big_dh = 2 * std::sqrt(c1 * c2) * std::sin(dh / 2);
  double h = h1 + h2;
  if (c1 * c2 != 0) {
    if (std::abs(h1 - h2) > kHalf) h += h < 2 * kHalf ? 2 * kHalf : -2 * kHalf;
    h /= 2;
  }
  const double l = (one[0] + other[0]) / 2, c = (c1 + c2) / 2;
  const double t = 1 - 0.17 * cos(h - radians(30)) + 0.24 * cos(2 * h) +
                   0.32 * cos(3 * h + radians(6)) - 0.20 * cos(4 * h - radians(63));
  const double turn = radians(30) * std::exp(-std::pow((h - radians(275)) / radians(25), 2));
  const double from_middle = (l - 50) * (l - 50);
  const double sl = 1 + 0.015 * from_middle / std::sqrt(20 + from_middle);
  const double sc = 1 + 0.045 * c, sh = 1 + 0.015 * c * t;
  const double rt = -std::sin(2 * turn) * 2 * squareRootOfShare(c);
  const double x = dl / sl, y = dc / sc, z = big_dh / sh;
  return std::sqrt(x * x + y * y + z * z + rt * y * z);
}

}  // namespace ostraka::colour
